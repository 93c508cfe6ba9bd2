package radiosity.formfactor;

/**
 * A way to find what reaches a receiving point from a shooter (section 2.3 and 4.5.10 of the paper).
 *
 * <p>Implementations depend on their arguments only, so that a receiving point gets the same light from the same shot
 * whoever computes it.
 */
public interface FormFactorCalculator {

    /**
     * Adds the irradiance at a point that is due to a shooter: the integral over it of form factor times visibility
     * times radiosity (equation 3).
     *
     * @param px         receiving point, of the scene brought to size 1, and so on
     * @param nx         its normal, length 1, and so on
     * @param key        what the receiving point is, whoever owns it
     * @param irradiance modified: W/m², one per channel
     */
    void gather(float px, float py, float pz, float nx, float ny, float nz, long key, Shooter shooter,
                double[] irradiance);
}
