package radiosity.formfactor;

/**
 * A way to find what reaches a receiving point from a shooter (section 2.3 and 4.5.10 of the paper).
 *
 * <p>Implementations depend on their arguments only, so that a receiving point gets the same light from the same shot
 * whoever computes it.
 */
public interface FormFactorCalculator {

    /**
     * Finds what a point receives from a shooter: the integral over it of form factor times visibility times radiosity
     * (equation 3), as a sum over sample points.
     *
     * @param px         receiving point, of the scene brought to size 1, and so on
     * @param nx         its normal, length 1, and so on
     * @param key        what the receiving point is, whoever owns it
     * @param gathering  receives every sample point that is visible
     */
    void gather(float px, float py, float pz, float nx, float ny, float nz, long key, ShooterHierarchy shooter,
                GatherSink gathering);
}
