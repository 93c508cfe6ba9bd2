package radiosity.mesh.cut;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import radiosity.mesh.face.CutPoints;
import radiosity.mesh.face.Faces;
import radiosity.mesh.room.ClosedRooms;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/** What four times as many triangles cost, counted in what is looked at: at most five times as much. */
class ScalingTest {

    private static final Surface GREY = radiosity.testkit.RoomScenes.grey("grey", 0, 0.5);

    /** Planes in which many small faces lie beside a large one. */
    private enum Plane {
        LEVEL(new Vec3(1, 0, 0), new Vec3(0, 1, 0)),
        UPRIGHT(new Vec3(0, 0, 1), new Vec3(0, 1, 0)),
        OBLIQUE(new Vec3(.6, .8, 0), new Vec3(-.48, .36, .8));

        private final Vec3 right;
        private final Vec3 up;

        Plane(Vec3 right, Vec3 up) {
            this.right = right;
            this.up = up;
        }

        Vec3 at(double x, double y) {
            return right.times(x).plus(up.times(y));
        }
    }

    /** Small faces in n rows of n, and a large one that shares one of their edges. */
    private static Scene sheet(Plane plane, int n) {
        SceneBuilder builder = new SceneBuilder();
        double h = 1.0 / n;
        for (int i = 0; i < n * n; i++) {
            double x = h * (i % n);
            double y = h * (i / n);
            builder.polygon(GREY, plane.at(x, y), plane.at(x + h, y), plane.at(x + h, y + h), plane.at(x, y + h));
        }
        builder.polygon(GREY, plane.at(h, 0), plane.at(0, 0), plane.at(-1, -3), plane.at(2, -3));
        Vec3 above = plane.right.cross(plane.up);
        builder.polygon(GREY, plane.at(0, -2), plane.at(1, -2), plane.at(1, -2).plus(above));
        return builder.scene("sheet");
    }

    private static long looksForContacts(Scene scene) {
        DiscontinuityMesher cutting = new DiscontinuityMesher(new Faces(scene));
        assertTrue(cutting.edges.size() > 0, "expected a cut where the triangle stands on the large face, got none");
        return cutting.contacts.looks();
    }

    private static void assertScales(double once, double fourTimes) {
        assertTrue(fourTimes <= 5 * once, "expected at most 5 times " + once + ", got " + fourTimes);
    }

    @ParameterizedTest
    @EnumSource
    void coplanarFacesBesideALargeOne(Plane plane) {
        assertScales(looksForContacts(sheet(plane, 20)), looksForContacts(sheet(plane, 40)));
    }

    /** All in one plane, and the box of each reaches into those of many others. */
    @ParameterizedTest
    @EnumSource
    void sliversThatMeetAtAPoint(Plane plane) {
        assertScales(looksForContacts(fan(plane, 500)), looksForContacts(fan(plane, 2000)));
    }

    private static Scene fan(Plane plane, int n) {
        SceneBuilder builder = new SceneBuilder();
        for (int i = 0; i < n; i++) {
            builder.polygon(GREY, plane.at(0, 0), onArc(plane, i, n), onArc(plane, i + 1, n));
        }
        builder.polygon(GREY, plane.at(0, 0), onArc(plane, n, n), plane.at(-8, 1), plane.at(-8, -1));
        Vec3 above = plane.right.cross(plane.up);
        builder.polygon(GREY, plane.at(-2, 0), plane.at(-4, 0), plane.at(-2, 0).plus(above));
        return builder.scene("fan");
    }

    private static Vec3 onArc(Plane plane, int i, int n) {
        double t = 2.0 * i / n - 1;
        return plane.at(-1 + (1 - t * t), 2 * t);
    }

    /** Many have one coordinate in common. */
    @ParameterizedTest
    @EnumSource
    void pointsInAPlane(Plane plane) {
        assertScales(looksForPoints(plane, 32), looksForPoints(plane, 64));
    }

    private static long looksForPoints(Plane plane, int n) {
        Scene scene = sheet(plane, n);
        CutPoints points = new CutPoints(scene, 1e-7);
        for (int p = 0; p < scene.points().length / 3; p++) {
            points.use(p);
        }
        return points.looks + n * n;
    }

    /** How closed boxes stand: where, and whether they are seen from inside. */
    private enum Boxes {
        BESIDE_EACH_OTHER(1.5, false),
        TOUCHING(1, false),
        IN_ONE_PLACE(0, false),
        ROOMS(1.5, true),
        TOUCHING_ROOMS(1, true),
        ROOMS_IN_ONE_PLACE(0, true);

        private final double apart;
        private final boolean inward;

        Boxes(double apart, boolean inward) {
            this.apart = apart;
            this.inward = inward;
        }

        Scene scene(int n) {
            SceneBuilder builder = new SceneBuilder();
            if (!inward) {
                box(builder, -1, -1, -1, 2 * n, true);
            }
            for (int i = 0; i < n * n; i++) {
                box(builder, apart * (i % n), 0, apart * (i / n), 1, inward);
            }
            return builder.scene("boxes");
        }
    }

    private static void box(SceneBuilder builder, double x, double y, double z, double edge, boolean inward) {
        for (int axis = 0; axis < 3; axis++) {
            for (int side = 0; side < 2; side++) {
                Vec3[] corners = new Vec3[4];
                for (int k = 0; k < 4; k++) {
                    int u = k == 1 || k == 2 ? 1 : 0;
                    int v = k / 2;
                    int[] at = {side, u, v};
                    boolean turned = side == 0 == inward;
                    corners[turned ? k : 3 - k] = new Vec3(x + edge * at[(3 - axis) % 3],
                            y + edge * at[(4 - axis) % 3], z + edge * at[(5 - axis) % 3]);
                }
                builder.polygon(GREY, corners);
            }
        }
    }

    private static ClosedRooms rooms(Scene scene) {
        return new ClosedRooms(new Faces(scene), f -> false, new BitSet());
    }

    @ParameterizedTest
    @EnumSource
    void roomsOfClosedBoxes(Boxes boxes) {
        ClosedRooms few = rooms(boxes.scene(12));
        ClosedRooms many = rooms(boxes.scene(24));
        assertEquals(boxes == Boxes.BESIDE_EACH_OTHER ? 1 : boxes.inward && boxes.apart > 0 ? 144 : 0, few.count());
        assertEquals(few.count() == 144 ? 576 : few.count(), many.count());
        assertScales(few.looks, many.looks);
    }

    @Test
    void pointsThatAreOne_areFoundAcrossCells() {
        Scene scene = sheet(Plane.LEVEL, 2);
        CutPoints points = new CutPoints(scene, 1e-3);
        for (int i = 0; i < 100; i++) {
            Vec3 p = new Vec3(.9 + .016 * i, .9 + .016 * i, 5);
            int number = points.number(p.plus(new Vec3(1e-4, 0, -1e-4)));
            assertEquals(number, points.number(p));
            assertEquals(number, points.number(p.minus(new Vec3(1e-4, 3e-4, 0))));
        }
    }
}
