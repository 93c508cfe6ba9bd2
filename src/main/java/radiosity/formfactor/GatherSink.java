package radiosity.formfactor;

/** Takes what a receiving point sees of shooters: of one node after another. */
public interface GatherSink {

    /**
     * A sample point that is visible.
     *
     * @param leaf element of the shooter's tree under it
     * @param a    weight of the element's corner 0, and so on
     */
    void add(ShooterHierarchy shooter, int leaf, double a, double b, double c);

    /** All sample points of a node are done: what was added since the last one counts so much. */
    void close(double scale);

    /** Adds irradiance, in W/m². */
    final class Irradiance implements GatherSink {

        private final double[] sum;
        private final int channels;
        /** Modified: irradiance of the present receiving point, one per channel, W/m². */
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
