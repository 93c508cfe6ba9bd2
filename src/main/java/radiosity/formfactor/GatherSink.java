package radiosity.formfactor;

/** Receives the visible sample points of a receiving point's shooters, node by node; for use by one thread. */
public interface GatherSink {

    /**
     * Adds a visible sample point.
     *
     * @param leaf element of the shooter's tree that contains the point
     * @param a    weights of the radiosities at the element's corners 0, 1 and 2: a, b, c
     */
    void add(ShooterHierarchy shooter, int leaf, double a, double b, double c);

    /** Ends a node: multiplies the weights of all sample points added since the last call by {@code scale}. */
    void close(double scale);

    /** Sums up irradiance, in W/m². */
    final class Irradiance implements GatherSink {

        /** One per channel: weighted radiosities of the present node, before scaling. */
        private final double[] sum;
        private final int channels;
        /** One per channel: irradiance, W/m², to which every node is added; callers may set it. */
        public final double[] value;

        public Irradiance(int channels) {
            this.channels = channels;
            sum = new double[channels];
            value = new double[channels];
        }

        @Override
        public void add(ShooterHierarchy shooter, int leaf, double a, double b, double c) {
            double[] u = shooter.radiosity;
            int at = 3 * channels * leaf;
            for (int i = 0; i < channels; i++) {
                sum[i] += a * u[at + i] + b * u[at + channels + i] + c * u[at + 2 * channels + i];
            }
        }

        @Override
        public void close(double scale) {
            for (int i = 0; i < channels; i++) {
                value[i] += scale * sum[i];
                sum[i] = 0;
            }
        }
    }
}
