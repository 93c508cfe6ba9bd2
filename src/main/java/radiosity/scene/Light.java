package radiosity.scene;

import java.util.Optional;

/**
 * A source without geometry: it neither occludes nor shows, and shoots before any patch.
 *
 * @param name      for messages and layers
 * @param kind      what it is
 * @param power     distant: irradiance at normal incidence (W/m²); sky: of a level place that sees all of it; point
 *                  and spot: irradiance at distance
 *                  {@code range} (W/m²), falling with 1/r²; area: exitance (W/m²)
 * @param position  of a point, spot or (centre of) area light, scene units
 * @param direction unit direction in which it shines (not used by a point light)
 * @param right     half edge of an area light, scene units; of others a direction to its right, or zero
 * @param up        other half edge of an area light; of a sky, unit direction of its zenith
 * @param range     distance at which a point or spot light has its nominal irradiance, scene units, above 0
 * @param cone      half angle of a spot's cone, radians
 * @param edge      width of the soft edge inside that cone, radians
 * @param luminaire of a point light: how its intensity depends on the direction, and how large it is
 */
public record Light(String name, Kind kind, Rgb power, Vec3 position, Vec3 direction, Vec3 right, Vec3 up,
                    double range, double cone, double edge, Optional<Luminaire> luminaire) {

    /** A light that is no luminaire. */
    public Light(String name, Kind kind, Rgb power, Vec3 position, Vec3 direction, Vec3 right, Vec3 up, double range,
                 double cone, double edge) {
        this(name, kind, power, position, direction, right, up, range, cone, edge, Optional.empty());
    }

    /** The kinds of light that are evaluated. */
    public enum Kind {
        DISTANT, POINT, SPOT, AREA,
        /** Skies all around, behind everything: equally bright everywhere. */
        SKY_UNIFORM,
        /** Three times as bright above as at the horizon (CIE standard overcast sky, CIE S 003, 1996). */
        SKY_OVERCAST,
        /** Brightest about the sun (CIE standard clear sky, low turbidity: type 12 of CIE S 011, 2003). */
        SKY_CLEAR;

        /** Whether it comes from behind everything, and so into no closed room. */
        public boolean isOutside() {
            return this == DISTANT || isSky();
        }

        public boolean isSky() {
            return ordinal() >= SKY_UNIFORM.ordinal();
        }
    }

    /**
     * A sky.
     *
     * @param kind        one of the skies
     * @param illuminance of a level place from which all of it is seen, lx or W/m²
     * @param up          where its zenith is
     * @param sun         direction towards the sun, which must be above the horizon, for a clear sky; else not used
     */
    public static Light sky(Kind kind, double illuminance, Vec3 up, Vec3 sun) {
        check("sky", kind != Kind.SKY_CLEAR || sun.dot(up) > 0, "a sun above the horizon", sun);
        Vec3 down = kind == Kind.SKY_CLEAR ? sun.unit().times(-1) : up.unit().times(-1);
        return new Light("sky", kind, Rgb.grey(illuminance), Vec3.ZERO, down, Vec3.ZERO, up.unit(), 1, 0, 0);
    }

    /**
     * The sun.
     *
     * @param towards     direction towards it
     * @param illuminance of a place that faces it, lx or W/m²
     */
    public static Light sun(Vec3 towards, double illuminance) {
        return new Light("sun", Kind.DISTANT, Rgb.grey(illuminance), Vec3.ZERO, towards.unit().times(-1), Vec3.ZERO,
                Vec3.ZERO, 1, 0, 0);
    }

    /**
     * Checks itself.
     *
     * @throws IllegalArgumentException where a power is negative or no number, a vector is not finite, a direction that
     *                                  is used is zero, a range that is used is not above 0, or an angle is not in [0,
     *                                  pi]
     */
    public Light {
        check(name, power.isFinite() && Math.min(power.r(), Math.min(power.g(), power.b())) >= 0,
                "a power of at least 0",
                power);
        check(name, position.isFinite(), "a finite position", position);
        check(name, right.isFinite(), "a finite half edge", right);
        check(name, up.isFinite(), "a finite half edge", up);
        check(name, direction.isFinite() && (kind == Kind.POINT && luminaire.isEmpty() || direction.length() > 0),
                "a direction that is not zero",
                direction);
        check(name, Double.isFinite(range) && (range > 0 || kind != Kind.POINT && kind != Kind.SPOT), "a range above 0",
                range);
        check(name, cone >= 0 && cone <= Math.PI, "a cone's half angle from 0 to pi", cone);
        check(name, edge >= 0 && edge <= Math.PI, "a soft edge from 0 to pi", edge);
    }

    private static void check(String name, boolean isRight, String expected, Object got) {
        if (!isRight) {
            throw new IllegalArgumentException("light " + name + ": expected " + expected + ", got " + got);
        }
    }
}
