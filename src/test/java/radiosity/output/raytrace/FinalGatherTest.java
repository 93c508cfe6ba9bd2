package radiosity.output.raytrace;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.formfactor.ContourFactor;
import radiosity.output.gltf.Handmade;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;

/** Light that is gathered anew at a point, against closed forms. */
class FinalGatherTest {

    private static final Vec3 UP = new Vec3(0, 1, 0);

    private static Rgb gather(Solution solution, Vec3 point, int count) {
        return new FinalGather(new ElementRays(solution)).irradiance(point, UP, 12_345, count);
    }

    /** In a room that is lit everywhere alike, whatever ray is chosen brings the same. */
    @Test
    void uniformRoom_givesItsLightExactly() {
        Handmade room = new Handmade();
        Vec3 x = new Vec3(1, 0, 0);
        Vec3 z = new Vec3(0, 0, 1);
        int wall = room.surface("wall", .5);
        Rgb light = new Rgb(4, 2, 1);
        room.grid(wall, Vec3.ZERO, z, x, 1, 2, p -> light).grid(wall, UP, x, z, 3, 4, p -> light)
                .grid(wall, Vec3.ZERO, UP, z, 5, 3, p -> light).grid(wall, x, z, UP, 1, 1, p -> light)
                .grid(wall, Vec3.ZERO, x, UP, 2, 2, p -> light).grid(wall, z, UP, x, 2, 1, p -> light);
        Rgb got = gather(room.solution(), new Vec3(.3, 0, .7), 50);
        for (int c = 0; c < 3; c++) {
            assertEquals(light.channel(c) / 2, got.channel(c), 1e-9);
        }
    }

    private static Handmade lamp() {
        Handmade made = new Handmade();
        made.grid(made.surface("floor", .5), new Vec3(-3, 0, -3), new Vec3(0, 0, 6), new Vec3(6, 0, 0), 1, 1,
                p -> Rgb.grey(7));
        made.grid(made.surface("lamp", new Rgb(10, 5, 1), Rgb.BLACK, false), new Vec3(-.5, 2, -.5),
                new Vec3(1, 0, 0), new Vec3(0, 0, 1), 1, 1, p -> Rgb.BLACK);
        return made;
    }

    private static double factor(Vec3 at, double right) {
        return ContourFactor.factor(at, new Vec3(0, 1, 0), new Vec3(-.5, 2, -.5), new Vec3(right, 2, -.5),
                new Vec3(right, 2, .5), new Vec3(-.5, 2, .5));
    }

    /** Lambert's form factor of a square. */
    @Test
    void lamp_givesItsFormFactor() {
        for (Vec3 at : new Vec3[] {Vec3.ZERO, new Vec3(2, 0, 1), new Vec3(-.4, 0, -2.9)}) {
            Rgb got = gather(lamp().solution(), at, 256);
            double factor = factor(at, .5);
            assertEquals(10 * factor, got.r(), .005 * 10 * factor);
            assertEquals(got.r() / 2, got.g(), 1e-9);
        }
    }

    /** A screen that reaches to the middle of the lamp, as seen from the point, leaves the form factor of half of it. */
    @Test
    void screen_hidesItsPartOfTheLamp() {
        Handmade made = lamp();
        made.grid(made.surface("screen", Rgb.BLACK, Rgb.BLACK, true), new Vec3(0, 1, -3), new Vec3(3, 0, 0),
                new Vec3(0, 0, 6), 1, 1, p -> Rgb.BLACK);
        double half = factor(Vec3.ZERO, 0);
        assertEquals(10 * half, gather(made.solution(), Vec3.ZERO, 1024).r(), .02 * 10 * half);
    }

    private static Solution floor(Light light) {
        Handmade made = new Handmade();
        made.grid(made.surface("floor", .5), new Vec3(-3, 0, -3), new Vec3(0, 0, 6), new Vec3(6, 0, 0), 1, 1,
                p -> Rgb.grey(7));
        Solution s = made.solution();
        return new Solution(s.scene().with(s.scene().surfaces(), List.of(light)), 3, s.positions(), s.irradiance(),
                s.corners(), s.faceOf(), 0, 0, 0, s.ledger(), SavedState.NONE);
    }

    /** Inverse square of a light at height 2: at its foot a quarter of what it has at distance 1. */
    @Test
    void lightWithoutGeometry_isAdded() {
        Light point = new Light("l", Light.Kind.POINT, Rgb.grey(8), new Vec3(0, 2, 0), Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, 1,
                0, 0);
        assertEquals(2, gather(floor(point), Vec3.ZERO, 1).g(), 1e-6);
    }

    /** A level place in the open has the illuminance of the sky, but for how finely that sees the horizon. */
    @Test
    void skyInTheOpen_hasItsIlluminance() {
        assertEquals(100, gather(floor(Light.sky(Light.Kind.SKY_UNIFORM, 100, UP, UP)), Vec3.ZERO, 9).r(), .5);
        assertEquals(100, gather(floor(Light.sky(Light.Kind.SKY_OVERCAST, 100, UP, UP)), Vec3.ZERO, 4096).r(), .5);
    }

    /** What reflects much more than the mean is found by rays of its own: few that go all round would meet it. */
    @Test
    void brightSpot_givesItsFormFactorByFewRays() {
        Handmade made = new Handmade();
        made.grid(made.surface("floor", .5), new Vec3(-30, 0, -30), new Vec3(0, 0, 60), new Vec3(60, 0, 0), 1, 1,
                p -> Rgb.BLACK);
        made.grid(made.surface("spot", .5), new Vec3(-.05, 2, -.05), new Vec3(.1, 0, 0), new Vec3(0, 0, .1), 1, 1,
                p -> Rgb.grey(2000));
        double factor = ContourFactor.factor(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(-.05, 2, -.05),
                new Vec3(.05, 2, -.05), new Vec3(.05, 2, .05), new Vec3(-.05, 2, .05));
        assertEquals(1000 * factor, gather(made.solution(), new Vec3(1, 0, 0), 16).b(), .005 * 1000 * factor);
    }
}
