package radiosity.scene;

import java.util.Optional;

/**
 * A source of light without geometry: it casts no shadow, is not visible, and shoots before any patch.
 *
 * @param name      name in messages and layers
 * @param kind      kind of source
 * @param power     per channel, W/m² or lx: irradiance at normal incidence (distant); irradiance of a horizontal
 *                  surface from which the whole sky is visible (sky); irradiance at distance {@code range}, falling
 *                  with 1/r² (point, spot); exitance (area)
 * @param position  position of a point or spot light, centre of an area light, scene units
 * @param direction direction in which the light shines, in a clear sky away from the sun, of any length above 0; not
 *                  used by a point light without luminaire
 * @param right     half edge of an area light, scene units; for other lights a direction to its right, or zero
 * @param up        other half edge of an area light, scene units; for a sky, unit direction of its zenith
 * @param range     distance at which a point or spot light has the irradiance {@code power}, scene units, above 0
 * @param cone      half angle of a spot's cone, radians
 * @param edge      width of the soft edge inside that cone, radians; where it is wider than the cone, the power holds
 *                  nowhere, and the axis has the part cone / edge
 * @param luminaire for a point light: how its intensity depends on the direction, and the size of its opening
 */
public record Light(String name, Kind kind, Rgb power, Vec3 position, Vec3 direction, Vec3 right, Vec3 up,
                    double range, double cone, double edge, Optional<Luminaire> luminaire) {

    /** A light without luminaire. */
    public Light(String name, Kind kind, Rgb power, Vec3 position, Vec3 direction, Vec3 right, Vec3 up, double range,
                 double cone, double edge) {
        this(name, kind, power, position, direction, right, up, range, cone, edge, Optional.empty());
    }

    /** The kinds of lights. */
    public enum Kind {
        DISTANT, POINT, SPOT, AREA,
        /** Sky around and behind all triangles, with the same radiance in all directions. */
        SKY_UNIFORM,
        /** Sky three times as bright at the zenith as at the horizon (CIE standard overcast sky, CIE S 003, 1996). */
        SKY_OVERCAST,
        /** Sky brightest around the sun (CIE standard clear sky, low turbidity: type 12 of CIE S 011, 2003). */
        SKY_CLEAR;

        /** Whether the light comes from behind all triangles, and so reaches into no closed room. */
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
     * @param kind        one of the kinds of sky
     * @param illuminance illuminance of a horizontal surface from which the whole sky is visible, lx or W/m²
     * @param up          direction of the zenith, of any length above 0
     * @param sun         direction towards the sun, used for a clear sky only
     * @throws IllegalArgumentException where the sun of a clear sky is not above the horizon
     */
    public static Light sky(Kind kind, double illuminance, Vec3 up, Vec3 sun) {
        check("sky", kind != Kind.SKY_CLEAR || sun.dot(up) > 0, "a sun above the horizon", sun);
        Vec3 down = kind == Kind.SKY_CLEAR ? sun.unit().times(-1) : up.unit().times(-1);
        return new Light("sky", kind, Rgb.grey(illuminance), Vec3.ZERO, down, Vec3.ZERO, up.unit(), 1, 0, 0);
    }

    /**
     * The sun.
     *
     * @param towards     direction towards the sun, of any length above 0
     * @param illuminance illuminance of a surface that faces the sun, lx or W/m²
     */
    public static Light sun(Vec3 towards, double illuminance) {
        return new Light("sun", Kind.DISTANT, Rgb.grey(illuminance), Vec3.ZERO, towards.unit().times(-1), Vec3.ZERO,
                Vec3.ZERO, 1, 0, 0);
    }

    /**
     * Checks all values.
     *
     * @throws IllegalArgumentException where a power is negative or not finite, a vector is not finite, a used
     *                                  direction is zero, a used range is not above 0, or an angle is not in [0, pi]
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
