package radiosity.mesh.room;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.mesh.cut.DiscontinuityMesher;
import radiosity.mesh.face.Faces;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.testkit.Box;
import radiosity.testkit.Prism;

/** A room is closed only where that is proven. */
class ClosedRoomsTest {

    private static final Surface WALL = radiosity.testkit.RoomScenes.grey("wall", 1, 0.5);
    private static final Box SMALL = new Box(new Vec3(0.4, 0.4, 0.4), new Vec3(0.6, 0.6, 0.6));

    private static SceneBuilder inside(Box box, int sides) {
        SceneBuilder builder = new SceneBuilder();
        for (int side = 0; side < sides; side++) {
            builder.polygon(WALL, box.inside(side));
        }
        return builder;
    }

    private static SceneBuilder withCube(SceneBuilder builder, Box box, boolean fromInside) {
        for (int side = 0; side < 6; side++) {
            Vec3[] p = box.inside(side);
            builder.polygon(WALL, fromInside ? p : new Vec3[] {p[3], p[2], p[1], p[0]});
        }
        return builder;
    }

    private static ClosedRooms rooms(SceneBuilder builder) {
        return rooms(builder.scene("room"));
    }

    private static ClosedRooms rooms(Scene scene) {
        return rooms(new Faces(scene));
    }

    private static ClosedRooms rooms(Faces faces) {
        return new ClosedRooms(faces, f -> false, new BitSet());
    }

    @Test
    void watertightRooms_areClosedAndPlain() {
        radiosity.testkit.RoomScenes.watertight().forEach((name, room) -> {
            ClosedRooms found = rooms(room.apply(WALL));
            assertEquals(1, found.count(), name);
            assertTrue(found.isPlain(), name);
        });
    }

    @Test
    void missingWall_isOpen() {
        assertEquals(0, rooms(inside(Box.UNIT, 5)).count());
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-2, 1e-4, 1e-6})
    void hairline_isOpen(double gap) {
        SceneBuilder builder = inside(Box.UNIT, 5);
        builder.polygon(WALL, new Vec3(0, 1, 1), new Vec3(1, 1, 1), new Vec3(1, gap, 1), new Vec3(0, gap, 1));
        assertEquals(0, rooms(builder).count());
    }

    @Test
    void cornersOnEdges_close() {
        SceneBuilder builder = inside(Box.UNIT, 5);
        for (double x = 0; x < 1; x += 0.25) {
            builder.polygon(WALL, new Vec3(x, 1, 1), new Vec3(x + 0.25, 1, 1), new Vec3(x + 0.25, 0, 1),
                    new Vec3(x, 0, 1));
        }
        assertEquals(1, rooms(builder).count());
    }

    @Test
    void blockWithoutBottomOnTheFloor_leavesTheRoomClosedButNotPlain() {
        ClosedRooms found = rooms(radiosity.testkit.RoomScenes.closedCornell(WALL));
        assertEquals(1, found.count());
        assertFalse(found.isPlain());
    }

    /** Where the floor is cut, what is under the block stands in no room. */
    @Test
    void blockWithoutBottomOnACutFloor_leavesTheRoomClosed() {
        Faces cut = DiscontinuityMesher.cut(new Faces(radiosity.testkit.RoomScenes.closedCornell(WALL)));
        ClosedRooms found = new ClosedRooms(cut, f -> true, new BitSet());
        assertEquals(1, found.count());
        assertTrue(found.isPlain());
        assertTrue(IntStream.range(0, cut.count()).allMatch(f -> found.isHidden(f) == (found.room(f) < 0)));
    }

    /** 4 mm thick, between floor, walls and ceiling that are one polygon each. */
    @Test
    void thinWall_makesTwoRoomsOfOne() {
        Faces cut = DiscontinuityMesher.cut(new Faces(withWall(0.5, 0.504)));
        ClosedRooms found = rooms(cut);
        assertEquals(2, found.count());
        for (int f = 0; f < cut.count(); f++) {
            double middle = cut.sceneCorner(f, 0).plus(cut.sceneCorner(f, 1)).plus(cut.sceneCorner(f, 2)).times(1 / 3.)
                    .z();
            int expected = middle < 0.501 ? found.room(firstAt(cut, 0)) : middle > 0.503 ? found.room(firstAt(cut, 1))
                    : -1;
            assertEquals(expected, found.room(f));
        }
    }

    @Test
    void wallOfNoThickness_makesTwoRoomsOfOne() {
        assertEquals(2, rooms(DiscontinuityMesher.cut(new Faces(withWall(0.5, 0.5)))).count());
    }

    private static int firstAt(Faces faces, double z) {
        return IntStream.range(0, faces.count()).filter(f -> IntStream.range(0, 3)
                .allMatch(k -> faces.sceneCorner(f, k).z() == z)).findFirst().orElseThrow();
    }

    private static Scene withWall(double near, double far) {
        return inside(Box.UNIT, 6)
                .polygon(WALL, new Vec3(0, 0, near), new Vec3(0, 1, near), new Vec3(1, 1, near), new Vec3(1, 0, near))
                .polygon(WALL, new Vec3(0, 0, far), new Vec3(1, 0, far), new Vec3(1, 1, far), new Vec3(0, 1, far))
                .scene("thin wall");
    }

    @Test
    void blockWithoutBottomAboveTheFloor_isOpen() {
        SceneBuilder builder = inside(new Box(new Vec3(0, -0.1, 0), new Vec3(1, 1, 1)), 6);
        new Prism(0.5, new double[] {.2, .2, .2, .6, .6, .6, .6, .2}).addTo(builder, WALL);
        assertEquals(0, rooms(builder).count());
    }

    @Test
    void solidsSeenFromOutside_areInTheRoom() {
        ClosedRooms found = rooms(withCube(inside(Box.UNIT, 6), SMALL, false));
        assertEquals(1, found.count());
        assertTrue(found.isPlain());
    }

    @Test
    void shellSeenFromInsideWithinARoom_isNotTrusted() {
        ClosedRooms found = rooms(withCube(inside(Box.UNIT, 6), SMALL, true));
        assertEquals(-1, found.room(0));
    }

    @Test
    void solidThroughAWall_isNotTrusted() {
        Box through = new Box(new Vec3(0.8, 0.4, 0.4), new Vec3(1.3, 0.6, 0.6));
        assertEquals(0, rooms(withCube(inside(Box.UNIT, 6), through, false)).count());
    }

    @Test
    void aCubeSeenFromOutside_isNoRoom() {
        assertEquals(0, rooms(withCube(new SceneBuilder(), Box.UNIT, false)).count());
    }
}
