package radiosity.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.accuracy.CieCase.Measured;
import radiosity.scene.Light;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.testkit.Cells;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/**
 * CIE 171:2006 under skies, in an all but black room of 4 m x 4 m x 3 m, in per cent of E_hz: 5.9 an opening in the roof; 5.11 one in
 * the wall y = 4, of 2 m x 1 m from 1 m above the floor; 5.13 the same below a black slab that stands out 1 m, 0.5 m above
 * it, whose upper side is left out; 5.14 the same before a black wall 3 m high, 6 m away. What slab, wall and ground
 * reflect is left out: they are black.
 *
 * <p>What reflects nothing matters to no mesh, so the reflectance is .001: interreflection adds at most that part.
 *
 * <p>References: the sky's luminance integrated over the opening as seen from the point, E = integral of L cos cos' dA /
 * d², by midpoints of 400 x 400 parts, with nothing where slab or wall is in the way or the direction is below the
 * horizon.
 */
@Tag("slow")
class CieSkyTest {

    private static final Surface BLACK = RoomScenes.grey("black", 0, 1e-3);
    private static final Surface OPEN = RoomScenes.grey("opening", 0, 0);
    private static final Vec3 UP = new Vec3(0, 0, 1);
    private static final Vec3 DEEP = new Vec3(0, 1, 0);
    private static final Vec3 SUN = new Vec3(1, 2, 2).unit();
    private static final int PARTS = 400;

    /** Where an opening lies: one corner and two edges at right angles to each other and to the normal. */
    private record Opening(Vec3 corner, Vec3 u, Vec3 v, Vec3 out) { }

    /** All geometries under one sky each, and all skies. */
    static List<CieCase> cases() {
        return List.of(roof(1, Light.Kind.SKY_OVERCAST), roof(4, Light.Kind.SKY_CLEAR), roof(4, Light.Kind.SKY_UNIFORM),
                window(Light.Kind.SKY_UNIFORM), window(Light.Kind.SKY_CLEAR), belowSlab(Light.Kind.SKY_OVERCAST),
                beforeWall(Light.Kind.SKY_OVERCAST));
    }

    private static CieCase window(Light.Kind sky) {
        return facade("5.11", sky, null, d -> true);
    }

    private static CieCase belowSlab(Light.Kind sky) {
        return facade("5.13", sky, new Vec3[] {new Vec3(-20, 5, 2.5), new Vec3(24, 5, 2.5), new Vec3(24, 4, 2.5),
            new Vec3(-20, 4, 2.5)}, ray -> !meets(ray, 2, 2.5, 1, 4, 5));
    }

    private static CieCase beforeWall(Light.Kind sky) {
        return facade("5.14", sky, new Vec3[] {new Vec3(-20, 10, 0), new Vec3(-20, 10, 3), new Vec3(24, 10, 3),
            new Vec3(24, 10, 0)}, ray -> !meets(ray, 1, 10, 2, 0, 3));
    }

    /** Whether a ray (origin, direction) meets a plane of an axis where another coordinate is in a range. */
    private static boolean meets(Vec3[] ray, int axis, double plane, int other, double low, double high) {
        double t = (plane - part(ray[0], axis)) / part(ray[1], axis);
        double at = part(ray[0], other) + t * part(ray[1], other);
        return t > 0 && at > low && at < high;
    }

    private static double part(Vec3 v, int axis) {
        return axis == 0 ? v.x() : axis == 1 ? v.y() : v.z();
    }

    private static CieCase roof(double side, Light.Kind sky) {
        double a = 2 - side / 2;
        double[] x = side == 4 ? new double[] {0, 4} : new double[] {0, a, 4 - a, 4};
        Scene room = new Cells(x, x, new double[] {0, 3}).room("5.9", (i, j, k) -> true,
                (i, j, k, face) -> face == 5 && (side == 4 || i == 1 && j == 1) ? OPEN : BLACK);
        return daylit("5.9, opening " + side + " m, " + sky, CiePhotometryTest.without(OPEN, room), sky,
                new Opening(new Vec3(a, a, 3), new Vec3(side, 0, 0), new Vec3(0, side, 0), UP), ray -> true);
    }

    private static CieCase facade(String name, Light.Kind sky, Vec3[] mask, Predicate<Vec3[]> free) {
        Scene room = new Cells(new double[] {0, 1, 3, 4}, new double[] {0, 4}, new double[] {0, 1, 2, 3}).room(name,
                (i, j, k) -> true, (i, j, k, face) -> face == 3 && i == 1 && k == 1 ? OPEN : BLACK);
        SceneBuilder builder = new SceneBuilder();
        for (int t = 0; t < room.triangles(); t++) {
            if (!room.surface(t).equals(OPEN)) {
                builder.polygon(BLACK, room.corner(t, 0), room.corner(t, 1), room.corner(t, 2));
            }
        }
        if (mask != null) {
            builder.polygon(BLACK, mask);
        }
        return daylit(name + ", " + sky, builder.scene(name), sky,
                new Opening(new Vec3(1, 4, 1), new Vec3(2, 0, 0), UP, DEEP), free);
    }

    private static CieCase daylit(String name, Scene room, Light.Kind sky, Opening opening, Predicate<Vec3[]> free) {
        double scale = 100 / sphere(sky);
        List<Measured> points = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            points.add(measured("A" + i, new Vec3(2, 0, 2.75 - 0.5 * i), DEEP, p -> scale * seen(sky, p, DEEP, opening,
                    free)));
        }
        for (int i = 0; i < 8; i++) {
            points.add(measured("G" + i, new Vec3(2, 0.25 + 0.5 * i, 0), UP, p -> scale * seen(sky, p, UP, opening, free)));
        }
        return new CieCase(name, room.with(room.surfaces(), List.of(Light.sky(sky, 100, UP, SUN)))
                .with(new Units(1, true)), points);
    }

    private static Measured measured(String name, Vec3 p, Vec3 n, ToDoubleFunction<Vec3> exact) {
        return new Measured(name, p, n, exact.applyAsDouble(p));
    }

    private static double seen(Light.Kind sky, Vec3 p, Vec3 n, Opening o, Predicate<Vec3[]> free) {
        double sum = 0;
        for (int i = 0; i < PARTS * PARTS; i++) {
            Vec3 q = o.corner.plus(o.u.times((i % PARTS + 0.5) / PARTS)).plus(o.v.times((i / PARTS + 0.5) / PARTS));
            Vec3 way = q.minus(p);
            Vec3 d = way.unit();
            if (d.z() > 0 && d.dot(n) > 0 && free.test(new Vec3[] {p, d})) {
                sum += luminance(sky, d) * d.dot(n) * d.dot(o.out) / way.dot(way);
            }
        }
        return sum * o.u.length() * o.v.length() / (PARTS * PARTS);
    }

    /** Relative: CIE standard general sky of types 5, 16 (overcast) and 12. */
    private static double luminance(Light.Kind sky, Vec3 d) {
        if (sky == Light.Kind.SKY_CLEAR) {
            double chi = Math.acos(Math.min(1, d.dot(SUN)));
            return (1 - Math.exp(-0.32 / d.z())) * (1 + 10 * (Math.exp(-3 * chi) - Math.exp(-1.5 * Math.PI))
                    + 0.45 * Math.cos(chi) * Math.cos(chi));
        }
        return sky == Light.Kind.SKY_OVERCAST ? (1 + 2 * d.z()) / 3 : 1;
    }

    /** Illuminance of a level place in the open: rings of 0.25 degrees. */
    private static double sphere(Light.Kind sky) {
        double sum = 0;
        double step = Math.PI / 720;
        for (int i = 0; i < 360; i++) {
            double sin = Math.sin((i + 0.5) * step);
            double cos = Math.cos((i + 0.5) * step);
            for (int k = 0; k < 1440; k++) {
                double turn = (k + 0.5) * step;
                sum += luminance(sky, new Vec3(sin * Math.cos(turn), sin * Math.sin(turn), cos)) * cos * sin;
            }
        }
        return sum * step * step;
    }

    @ParameterizedTest
    @MethodSource("cases")
    void everyPoint_isWithinTwoPerCentOfTheLargest(CieCase test) {
        CiePhotometryTest.check(test, Solve.byDefault(), 0.02);
    }

    /** For a quarter of an hour. */
    @Tag("thorough")
    @ParameterizedTest
    @MethodSource("cases")
    void everyPoint_isWithinHalfAPerCentWhereAFifthIsAsked(CieCase test) {
        CiePhotometryTest.check(test, Solve.byDefault().accurate(0.002), 0.005);
    }
}
