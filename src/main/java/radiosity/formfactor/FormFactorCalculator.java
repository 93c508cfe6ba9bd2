package radiosity.formfactor;

/**
 * Computes the light that a receiving point receives from a shooter (section 2.3 and 4.5.10 of the paper).
 *
 * <p>The result depends only on the arguments, so that a receiving point gets the same light from the same shot on
 * every host and thread.
 */
public interface FormFactorCalculator {

    /**
     * Integrates form factor times visibility times radiosity over a shooter (equation 3), as a sum over sample points.
     *
     * @param px        coordinates of the receiving point in the scene brought to size 1: px, py, pz
     * @param nx        normal of the receiving point, length 1: nx, ny, nz
     * @param key       key of the receiving point, the same on every host; sample points follow from it
     * @param gathering receives every visible sample point, node by node
     */
    void gather(float px, float py, float pz, float nx, float ny, float nz, long key, ShooterHierarchy shooter,
                GatherSink gathering);
}
