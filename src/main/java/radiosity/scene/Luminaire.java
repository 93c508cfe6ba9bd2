package radiosity.scene;

/**
 * What a luminaire adds to a point light, which shines down its direction with its power where it is brightest.
 *
 * @param intensity by the direction
 * @param zero      unit direction in which the plane of horizontal angle 0 lies, at right angles to the light's
 * @param length    of the luminous opening along that direction, scene units, at least 0
 * @param width     of the luminous opening across, scene units, at least 0
 */
public record Luminaire(LuminousIntensity intensity, Vec3 zero, double length, double width) {

    /**
     * Checks itself.
     *
     * @throws IllegalArgumentException where it is dark, the direction is zero, or the opening is negative
     */
    public Luminaire {
        if (!(zero.length() > 0) || !zero.isFinite() || !(length >= 0 && width >= 0)
                || !Double.isFinite(length + width) || !(intensity.max() > 0)) {
            throw new IllegalArgumentException("luminaire: expected light, a direction and an opening of at least 0,"
                    + " got " + intensity.max() + " cd, " + zero + ", " + length + " x " + width);
        }
    }
}
