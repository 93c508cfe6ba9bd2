package radiosity.mesh.room;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.mesh.face.Faces;
import radiosity.scene.Camera;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.testkit.Box;

/** Closed bodies of two-sided triangles have no inner sides, unless light or the viewer may be inside. */
class DarkCavitiesTest {

    private static final Surface SHEET = new Surface("sheet", Rgb.BLACK, Rgb.grey(0.5), true);
    private static final Surface LAMP = new Surface("lamp", Rgb.grey(1), Rgb.BLACK, false);
    private static final Box BODY = new Box(new Vec3(0.25, 0.25, 0.25), new Vec3(0.75, 0.75, 0.75));
    private static final Vec3 MIDDLE = new Vec3(0.5, 0.5, 0.5);

    /** A lamp beside a box of two-sided squares. */
    private static SceneBuilder body(int sides) {
        SceneBuilder builder = lamp(0.9);
        for (int side = 0; side < sides; side++) {
            builder.polygon(SHEET, BODY.inside(side));
        }
        return builder;
    }

    private static SceneBuilder lamp(double y) {
        return new SceneBuilder().polygon(LAMP, new Vec3(0.4, y, 0.4), new Vec3(0.6, y, 0.4), new Vec3(0.6, y, 0.6),
                new Vec3(0.4, y, 0.6));
    }

    private static int dark(SceneBuilder builder) {
        return DarkCavities.of(new Faces(builder.scene("body"))).cardinality();
    }

    /** The sides of a box, seen from inside or from outside. */
    private static SceneBuilder oneSided(SceneBuilder builder, Box box, boolean inside) {
        Surface wall = new Surface("wall", Rgb.BLACK, Rgb.grey(0.5), false);
        for (int side = 0; side < 6; side++) {
            List<Vec3> corners = Arrays.asList(box.inside(side));
            if (!inside) {
                Collections.reverse(corners);
            }
            builder.polygon(wall, corners.toArray(Vec3[]::new));
        }
        return builder;
    }

    /** Whoever forgets the lamps is not to turn the walls over. */
    @Test
    void roomWithoutLamp_isNotInsideOut() {
        Box room = new Box(Vec3.ZERO, new Vec3(1, 1, 1));
        assertEquals(0, insideOut(oneSided(new SceneBuilder(), room, true)));
        assertEquals(0, insideOut(oneSided(oneSided(new SceneBuilder(), room, true), BODY, false)));
        assertEquals(1, insideOut(oneSided(oneSided(new SceneBuilder(), room, true), BODY, true)));
    }

    private static int insideOut(SceneBuilder builder) {
        return DarkCavities.insideOut(new Faces(builder.scene("body"))).size();
    }

    @Test
    void closedBody_losesItsInnerSides() {
        Faces all = new Faces(body(6).scene("body"));
        BitSet dark = DarkCavities.of(all);
        assertEquals(12, dark.cardinality());
        dark.stream().forEach(f -> {
            float[] middle = all.middle(f);
            double inwards = 0;
            for (int a = 0; a < 3; a++) {
                float centre = (float) all.unit(MIDDLE).coordinate(a);
                inwards += (centre - middle[a]) * all.normal(f, a);
            }
            assertTrue(inwards > 0, "the normal of an inner side points to the body's middle");
        });
        Faces left = all.without(dark);
        assertEquals(all.count() - 12, left.count());
        float[] fronts = left.fronts();
        for (int t = 2; t < 14; t++) {
            double length = Math.hypot(Math.hypot(fronts[3 * t], fronts[3 * t + 1]), fronts[3 * t + 2]);
            assertEquals(1, length, 1e-6, "a side that is left is the front of its triangle");
        }
    }

    @Test
    void openBody_keepsAllSides() {
        assertEquals(0, dark(body(5)));
    }

    @Test
    void bodyAroundALamp_keepsAllSides() {
        SceneBuilder builder = body(6);
        double y = 0.5;
        builder.polygon(LAMP, new Vec3(0.4, y, 0.4), new Vec3(0.6, y, 0.4), new Vec3(0.6, y, 0.6),
                new Vec3(0.4, y, 0.6));
        assertEquals(0, dark(builder));
    }

    @Test
    void bodyThatEmits_keepsAllSides() {
        SceneBuilder builder = lamp(0.9);
        Surface glowing = new Surface("glowing", Rgb.grey(1), Rgb.grey(0.5), true);
        for (int side = 0; side < 6; side++) {
            builder.polygon(side == 0 ? glowing : SHEET, BODY.inside(side));
        }
        assertEquals(0, dark(builder));
    }

    @Test
    void bodyAroundAPointLight_keepsAllSides() {
        Light bulb = new Light("bulb", Light.Kind.POINT, Rgb.grey(1), MIDDLE, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, 1, 0, 0);
        assertEquals(0, dark(body(6).light(bulb)));
    }

    @Test
    void bodyAroundTheCamera_keepsAllSides() {
        assertEquals(0, dark(body(6).camera(new Camera(MIDDLE, new Vec3(0, 0, 1), new Vec3(0, 1, 0), 0.5, 1))));
    }

    @Test
    void oneSidedBody_keepsAllSides() {
        assertEquals(0, dark(oneSided(lamp(0.9), BODY, true)));
    }

    @Test
    void oneSidedBodySeenFromInside_isInsideOut() {
        assertEquals(1, insideOut(oneSided(lamp(0.9), BODY, true)));
        assertEquals(0, insideOut(oneSided(lamp(0.9), BODY, false)));
    }

    @Test
    void roomWithALamp_isNotInsideOut() {
        assertEquals(0, insideOut(oneSided(lamp(0.5), BODY, true)));
    }

    @Test
    void hollowOfASolid_isNotInsideOut() {
        Box around = new Box(new Vec3(0.2, 0.2, 0.2), new Vec3(0.8, 0.8, 0.8));
        assertEquals(0, insideOut(oneSided(oneSided(lamp(0.9), around, false), BODY, true)));
    }
}
