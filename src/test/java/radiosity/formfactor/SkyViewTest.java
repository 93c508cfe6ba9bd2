package radiosity.formfactor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import radiosity.scene.Light;
import radiosity.scene.Vec3;
import radiosity.util.Hash;

/** Skies through a window in the plane y = 4, from x = 1 to 3 and z = 1 to 2, against sums over parts of the window. */
class SkyViewTest {

    private static final Vec3 UP = new Vec3(0, 0, 1);
    private static final Vec3 IN = new Vec3(1, 0, 0);
    private static final int PARTS = 300;

    private static double seen(Vec3 p, Vec3 n) {
        return new Sky(Light.sky(Light.Kind.SKY_UNIFORM, 1, UP, UP)).irradiance(n, isFree(p), Sky.Detail.EXACT);
    }

    private static Predicate<Vec3> isFree(Vec3 p) {
        return d -> {
            double t = (4 - p.y()) / d.y();
            double x = p.x() + t * d.x();
            double z = p.z() + t * d.z();
            return t > 0 && x > 1 && x < 3 && z > 1 && z < 2;
        };
    }

    /** The window's part above the point's horizon, by midpoints. */
    private static double exact(Vec3 p, Vec3 n) {
        double low = Math.max(1, p.z());
        double sum = 0;
        for (int i = 0; i < PARTS * PARTS; i++) {
            Vec3 way = new Vec3(1 + 2 * (i % PARTS + 0.5) / PARTS, 4, low + (2 - low) * (i / PARTS + 0.5) / PARTS).minus(p);
            sum += way.dot(n) * way.y() / (way.dot(way) * way.dot(way));
        }
        return sum * 2 * (2 - low) / (PARTS * PARTS) / Math.PI;
    }

    /** Nearer to the window than that the window is seen as a strip, narrower than a cell. */
    @ParameterizedTest
    @CsvSource({"0.3, 1, 0.003", "1.3, 1, 0.003", "2, 2, 0.001", "2.7, 3, 0.001", "1.7, 3.7, 0.001", "1.7, 3.9, 0.005",
        "2.1, 3.95, 0.005", "2.5, 3.97, 0.01"})
    void floor_seesWindow(double x, double y, double error) {
        Vec3 p = new Vec3(x, y, 0);

        assertEquals(1, seen(p, UP) / exact(p, UP), error);
    }

    @ParameterizedTest
    @CsvSource({"3, 0.5", "3.1, 1.1", "2.3, 1.5", "3.7, 1.3", "1.2, 0.2"})
    void wall_seesWindowAboveItsHorizon(double y, double z) {
        Vec3 p = new Vec3(0, y, z);

        assertEquals(1, seen(p, IN) / exact(p, IN), 0.002);
    }

    @Test
    void wall_seesNoSkyBelowItsHorizon() {
        assertEquals(0, seen(new Vec3(0, 3, 2.1), IN));
    }

    /** A round hole of radius r in a level ceiling at height 1: r² / (1 + r²), straight below its middle. */
    @ParameterizedTest
    @CsvSource({"0.1, 0.005", "0.3, 0.001", "1, 0.0005", "5, 0.0005"})
    void floor_seesRoundHole(double radius, double error) {
        Predicate<Vec3> free = d -> d.z() > 0 && Math.hypot(d.x(), d.y()) < radius * d.z();
        double seen = new Sky(Light.sky(Light.Kind.SKY_UNIFORM, 1, UP, UP)).irradiance(UP, free, Sky.Detail.EXACT);

        assertEquals(1, seen * (1 + radius * radius) / (radius * radius), error);
    }

    @ParameterizedTest
    @EnumSource(names = {"SKY_UNIFORM", "SKY_OVERCAST", "SKY_CLEAR"})
    void freePlace_hasIrradianceOne_andVerticalOneLess(Light.Kind kind) {
        Sky sky = new Sky(Light.sky(kind, 1, UP, new Vec3(1, 2, 2).unit()));
        double vertical = sky.irradiance(IN, d -> true, Sky.Detail.EXACT);

        assertEquals(1, sky.irradiance(UP, d -> true, Sky.Detail.EXACT), 1e-12);
        assertTrue(vertical > 0.3 && vertical < 1, "vertical: " + vertical);
    }

    /** A kerb all around hides a three-thousandth of the sphere, and next to nothing of the light, by a low sun, too. */
    @ParameterizedTest
    @EnumSource(names = {"SKY_UNIFORM", "SKY_OVERCAST", "SKY_CLEAR"})
    void kerbAtTheHorizon_hidesLittle(Light.Kind kind) {
        for (double height : new double[] {.05, .2, 1.5}) {
            Sky sky = new Sky(Light.sky(kind, 1, UP, new Vec3(1, .7, height).unit()));
            assertEquals(1, sky.irradiance(UP, d -> d.z() > .005, Sky.Detail.EXACT), .002, "sun " + height + " high");
        }
    }

    /** Level bars, as of a greenhouse, above a point. */
    private static Predicate<Vec3> bars(double width, double spacing) {
        return d -> d.z() > 0 && beside(d.x() / d.z(), width, spacing) && beside(d.y() / d.z(), width, spacing);
    }

    private static boolean beside(double x, double width, double spacing) {
        double place = x / spacing + .17;
        return (place - Math.floor(place)) * spacing > width;
    }

    /** Bars thinner than a cell must not be missed; found by 2.4 million rays. */
    @ParameterizedTest
    @CsvSource({".02, .25", ".02, 1", ".05, .25", ".05, .5", ".1, .25", ".1, 1"})
    void thinBars_hideTheirShare(double width, double spacing) {
        Sky sky = new Sky(Light.sky(Light.Kind.SKY_UNIFORM, 1, UP, UP));
        double truth = mean(sky, bars(width, spacing), .5 / 48, 1000);
        double[] seen = IntStream.range(0, 50).mapToObj(i -> new Sky.Detail(0, 0, i))
                .mapToDouble(detail -> sky.irradiance(UP, bars(width, spacing), detail) / truth).toArray();

        assertEquals(1, DoubleStream.of(seen).sum() / 50, .01);
        assertEquals(0, Math.sqrt(DoubleStream.of(seen).map(x -> (x - 1) * (x - 1)).sum() / 50), .01);
    }

    /** Few rays have noise, and no bias. */
    @ParameterizedTest
    @CsvSource({".02, .25", ".05, .5", ".1, .25"})
    void fewRays_areRightInTheMean(double width, double spacing) {
        Sky sky = new Sky(Light.sky(Light.Kind.SKY_UNIFORM, 1, UP, UP));
        int[] rays = new int[1];
        Predicate<Vec3> free = bars(width, spacing);
        double few = mean(sky, d -> {
            rays[0]++;
            return free.test(d);
        }, .05, 400);

        assertEquals(mean(sky, free, .5 / 48, 1000), few, .005);
        assertTrue(rays[0] < 300 * 400, "rays: " + rays[0]);
    }

    private static double mean(Sky sky, Predicate<Vec3> free, double perRay, int times) {
        return IntStream.range(0, times).mapToObj(i -> new Sky.Detail(perRay, 1, Hash.mix(7, i)))
                .mapToDouble(detail -> sky.irradiance(UP, free, detail)).sum() / times;
    }
}
