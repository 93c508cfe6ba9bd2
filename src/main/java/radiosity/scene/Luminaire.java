package radiosity.scene;

/**
 * What a luminaire adds to a point light. The luminaire's axis <i>down</i> is the light's direction, and the light's
 * power holds in the direction of the largest intensity.
 *
 * @param intensity intensity by direction
 * @param zero      unit direction in which the plane of horizontal angle 0 lies, at right angles to {@code down}
 * @param length    length of the luminous opening along {@code zero}, scene units, at least 0
 * @param width     width of the luminous opening across {@code zero}, scene units, at least 0
 */
public record Luminaire(LuminousIntensity intensity, Vec3 zero, double length, double width) {

    /**
     * Checks all values.
     *
     * @throws IllegalArgumentException where all intensities are 0, {@code zero} is zero or not finite, or the opening
     *                                  is negative or not finite
     */
    public Luminaire {
        if (!(zero.length() > 0) || !zero.isFinite() || !(length >= 0 && width >= 0)
                || !Double.isFinite(length + width) || !(intensity.max() > 0)) {
            throw new IllegalArgumentException("luminaire: expected light, a direction and an opening of at least 0,"
                    + " got " + intensity.max() + " cd, " + zero + ", " + length + " x " + width);
        }
    }
}
