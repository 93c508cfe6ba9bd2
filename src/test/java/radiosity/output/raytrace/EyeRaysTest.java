package radiosity.output.raytrace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.output.gltf.Handmade;
import radiosity.output.mesh.TJunctions;
import radiosity.scene.Rgb;
import radiosity.scene.Specular;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;

/**
 * What is seen in mirrors and through glass, against closed forms.
 *
 * <p>A wall in the plane z = 8 faces -z and has an irradiance that is linear in x and y, so that a colour names a
 * place. What shines is in and below the plane z = 0; the eye is above it and looks down.
 */
class EyeRaysTest {

    private static final double EXACT = 1e-6;
    private static final double FAR = 8;
    private static final double RHO = .5;
    private static final Vec3 EYE = new Vec3(.3, -.2, 3);
    private static final Specular MIRROR = new Specular(Rgb.grey(1), Rgb.BLACK, 0, 0, 1, false);

    private final Handmade made = new Handmade();

    /** Of the wall, W/m². */
    private static Rgb light(Vec3 p) {
        return new Rgb(40 + p.x(), 50 + p.y(), 30);
    }

    private static Rgb radiosity(Vec3 p) {
        return light(p).times(RHO);
    }

    private void wall(double z) {
        int wall = made.surface("wall", RHO);
        if (z > 0) {
            made.grid(wall, new Vec3(-20, -20, z), new Vec3(0, 40, 0), new Vec3(40, 0, 0), 3, 5, EyeRaysTest::light);
        } else {
            made.grid(wall, new Vec3(-20, -20, z), new Vec3(40, 0, 0), new Vec3(0, 40, 0), 3, 5, EyeRaysTest::light);
        }
    }

    /** A square of side 10 in a plane z, with nothing on it but what it mirrors and lets through. */
    private void sheet(Specular shine, double z, boolean up, Rgb light) {
        int surface = made.surface(new Surface("sheet " + z, Rgb.BLACK, Rgb.grey(.4), false)
                .with(Optional.of(shine)));
        Vec3 a = new Vec3(10, 0, 0);
        Vec3 b = new Vec3(0, 10, 0);
        made.grid(surface, new Vec3(-5, -5, z), up ? a : b, up ? b : a, 2, 3, p -> light);
    }

    private static Rgb seen(Solution solution, Vec3 direction) {
        Solution closed = TJunctions.close(solution);
        int element = new ElementRays(closed).first(EYE, Vec3.ZERO, direction).element();
        return new EyeRays(closed, 0).seen(element, EYE, direction, 5);
    }

    private static void assertSeen(Rgb expected, Rgb got, double error) {
        for (int c = 0; c < 3; c++) {
            assertEquals(expected.channel(c), got.channel(c), error * expected.channel(c), expected + " " + got);
        }
    }

    private static Vec3 down(double x, double y) {
        return new Vec3(x, y, -1).unit();
    }

    @Test
    void pointSeenInAMirror_hasTheColourOfThePoint() {
        wall(FAR);
        sheet(MIRROR, 0, true, Rgb.BLACK);
        Solution solution = made.solution();
        Random random = new Random(1);
        for (int i = 0; i < 200; i++) {
            Vec3 d = down(random.nextDouble() - .5, random.nextDouble() - .5);
            double way = (EYE.z() + FAR) / -d.z();
            assertSeen(radiosity(EYE.plus(d.times(way))), seen(solution, d), EXACT);
        }
    }

    /** Between two mirrors that face each other a ray goes on, and each takes a tenth. */
    @Test
    void mirrorsInMirrors_takeTheirShareEachTime() {
        Specular dim = new Specular(new Rgb(.9, .5, 1), Rgb.BLACK, 0, 0, 1, false);
        wall(FAR);
        sheet(dim, 0, true, Rgb.BLACK);
        sheet(dim, 4, false, Rgb.BLACK);
        Vec3 d = down(.35, 0);
        // down 3, up 4, down 4: then it is beyond the edge of the upper mirror at x = 5, and goes up to the wall
        double across = .35 * (EYE.z() + 4 + 4 + FAR);
        assertSeen(radiosity(new Vec3(EYE.x() + across, EYE.y(), FAR)).times(new Rgb(.729, .125, 1)),
                seen(made.solution(), d), EXACT);
    }

    @Test
    void surfaceThatMirrorsAPart_addsItsOwnLight() {
        Specular half = new Specular(Rgb.grey(.25), Rgb.BLACK, .75, 0, 1, false);
        wall(FAR);
        sheet(half, 0, true, Rgb.grey(20));
        Vec3 d = down(0, 0);
        Rgb expected = radiosity(EYE).times(.25).plus(Rgb.grey(.75 * .4 * 20));
        assertSeen(expected, seen(made.solution(), d), EXACT);
    }

    /** Polished plastic: Fresnel's share is mirrored, and what is not is seen of the colour below. */
    @ParameterizedTest
    @ValueSource(doubles = {0, .3, .8, 1.5})
    void polish_mirrorsByFresnel(double slope) {
        double normal = Specular.normalReflectance(1.5);
        wall(FAR);
        sheet(new Specular(Rgb.grey(normal), Rgb.BLACK, 1 - normal, 0, 1.5, false), 0, true, Rgb.grey(20));
        Vec3 d = down(slope, 0);
        double i = Math.atan(slope);
        double t = Math.asin(Math.sin(i) / 1.5);
        double reflectance = slope == 0 ? .04
                : (Math.pow(Math.sin(i - t) / Math.sin(i + t), 2) + Math.pow(Math.tan(i - t) / Math.tan(i + t), 2)) / 2;
        Rgb expected = radiosity(new Vec3(EYE.x() + slope * (EYE.z() + FAR), EYE.y(), FAR)).times(reflectance)
                .plus(Rgb.grey((1 - reflectance) * .4 * 20));
        assertSeen(expected, seen(made.solution(), d), EXACT);
    }

    /**
     * Through a slab of glass of thickness 1 the ray is shifted (Snell) and weakened twice (Fresnel); what is reflected
     * to and fro within comes out farther aside. Nothing is above it.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, .4, .7})
    void slabOfGlass_shiftsAndWeakens(double slope) {
        double index = 1.3;
        double normal = Specular.normalReflectance(index);
        Specular glass = new Specular(Rgb.grey(normal), Rgb.grey(1 - normal), 0, 0, index, false);
        wall(-4);
        sheet(glass, 0, true, Rgb.grey(99));
        sheet(glass, -1, false, Rgb.grey(99));
        double i = Math.atan(slope);
        double within = Math.tan(Math.asin(Math.sin(i) / index));
        double f = Fresnel.reflectance(Math.cos(i), index);
        Rgb expected = Rgb.BLACK;
        for (int turns = 0; turns < 2; turns++) {
            double x = EYE.x() + slope * (EYE.z() + 3) + within * (1 + 2 * turns);
            expected = expected.plus(radiosity(new Vec3(x, EYE.y(), -4))
                    .times((1 - f) * (1 - f) * Math.pow(f, 2 * turns)));
        }
        assertSeen(expected, seen(made.solution(), down(slope, 0)), EXACT);
    }

    @Test
    void thinSheet_refractsNothing() {
        wall(-4);
        sheet(new Specular(Rgb.BLACK, new Rgb(.9, .5, .1), .5, 0, 1, true), 0, true, Rgb.grey(20));
        Vec3 d = down(.7, .2);
        Rgb expected = radiosity(EYE.plus(d.times((EYE.z() + 4) / -d.z()))).times(new Rgb(.9, .5, .1))
                .plus(Rgb.grey(.5 * .4 * 20));
        assertSeen(expected, seen(made.solution(), d), EXACT);
    }

    @Test
    void backsOfWhatDoesNotShine_areSeenThroughInAMirror() {
        wall(FAR);
        made.grid(made.surface("away", .5), new Vec3(-9, -9, 5), new Vec3(18, 0, 0), new Vec3(0, 18, 0), 1, 1,
                p -> Rgb.grey(1000));
        sheet(MIRROR, 0, true, Rgb.BLACK);
        Vec3 eye = EYE;
        assertSeen(radiosity(eye), seen(made.solution(), down(0, 0)), EXACT);
    }

    /**
     * Rough surfaces blur, and lose a little that goes from facet to facet: in a uniform room all but that is mirrored;
     * over a linear field a narrow lobe has the mean of the mirrored place.
     */
    @Test
    void roughMirror_blursAroundTheMirroredPlace() {
        wall(FAR);
        sheet(new Specular(Rgb.grey(1), Rgb.BLACK, 0, .25, 1, false), 0, true, Rgb.BLACK);
        Solution solution = TJunctions.close(made.solution());
        Vec3 d = down(.2, 0);
        int element = new ElementRays(solution).first(EYE, Vec3.ZERO, d).element();
        EyeRays rays = new EyeRays(solution, 0);
        Rgb sum = Rgb.BLACK;
        for (int s = 0; s < 64; s++) {
            sum = sum.plus(rays.seen(element, EYE, d, s).times(1. / 64));
        }
        assertSeen(radiosity(new Vec3(EYE.x() + .2 * (EYE.z() + FAR), EYE.y(), FAR)), sum, .01);
        Rgb one = rays.seen(element, EYE, d, 0);
        assertTrue(Math.abs(one.r() - sum.r()) > 1e-9, "each ray of a pixel goes elsewhere");
        assertEquals(one, rays.seen(element, EYE, d, 0), "the same rays each time");
    }

    /** In a uniform room clear glass cannot be seen: what it does not mirror comes from behind, however often divided. */
    @Test
    void clearGlassInAUniformRoom_isNotSeen() {
        Rgb light = Rgb.grey(8);
        Vec3[] room = {new Vec3(12, 0, 0), new Vec3(0, 12, 0), new Vec3(0, 0, 12)};
        box(made.surface("wall", .5), new Vec3(-6, -6, -6), room, true, light);
        double normal = Specular.normalReflectance(1.5);
        Vec3 u = new Vec3(1, .3, .2);
        Vec3 v = u.cross(new Vec3(.1, .2, 1)).unit();
        box(made.surface(new Surface("glass", Rgb.BLACK, Rgb.BLACK, false).with(Optional.of(
                new Specular(Rgb.grey(normal), Rgb.grey(1 - normal), 0, 0, 1.5, false)))), new Vec3(-.4, -.7, .1),
                new Vec3[] {u, v, u.cross(v).times(.8)}, false, Rgb.BLACK);
        Solution solution = made.solution();
        Random random = new Random(2);
        for (int i = 0; i < 300; i++) {
            assertSeen(Rgb.grey(4), seen(solution, down(random.nextDouble() - .5, random.nextDouble() - .5)), 1e-3);
        }
    }

    /** @param inside whether its sides are seen from inside */
    private void box(int surface, Vec3 at, Vec3[] edges, boolean inside, Rgb light) {
        for (int a = 0; a < 3; a++) {
            Vec3 u = edges[(a + 1) % 3];
            Vec3 v = edges[(a + 2) % 3];
            made.grid(surface, at, inside ? u : v, inside ? v : u, 2, 1, p -> light);
            made.grid(surface, at.plus(edges[a]), inside ? v : u, inside ? u : v, 1, 2, p -> light);
        }
    }
}
