package radiosity.testkit;

/**
 * How far a solution is from the truth on a set of points, as {@code truth/score.py} has it. Relative to the weighted
 * mean of the true radiosities of the set.
 *
 * @param points how many
 * @param mean   weighted mean of the truth, W/m²
 * @param rmse   root of the weighted mean squared error / mean
 * @param bias   weighted mean error / mean
 * @param max    largest error / mean
 * @param noise  root of the weighted mean squared standard error of the truth / mean
 */
public record Score(int points, double mean, double rmse, double bias, double max, double noise) {

    /** What is missing: a set without points, or without light. */
    public static final Score NONE = new Score(0, 0, Double.NaN, Double.NaN, Double.NaN, Double.NaN);

    /** One channel of a set. */
    public static Score channel(TruthFile truth, PointSet set, int channel, double[] found) {
        Sums sums = new Sums();
        truth.add(sums, set, channel, found, 1);
        return sums.score();
    }

    /** The row <i>rgb</i>: all channels, each divided by its own mean. */
    public static Score rgb(TruthFile truth, PointSet set, double[] found) {
        Sums pooled = new Sums();
        for (int c = 0; c < 3; c++) {
            double mean = channel(truth, set, c, found).mean();
            if (mean > 0) {
                truth.add(pooled, set, c, found, mean);
            }
        }
        return pooled.score();
    }

    /** Sums over points. */
    static final class Sums {

        private int points;
        private double weight;
        private double truth;
        private double error;
        private double squaredError;
        private double squaredNoise;
        private double largest;

        void add(double w, double expected, double found, double noise) {
            double d = found - expected;
            points++;
            weight += w;
            truth += w * expected;
            error += w * d;
            squaredError += w * d * d;
            squaredNoise += w * noise * noise;
            largest = Math.max(largest, Math.abs(d));
        }

        private Score score() {
            double mean = truth / weight;
            return points == 0 || mean <= 0 ? NONE : new Score(points, mean, Math.sqrt(squaredError / weight) / mean,
                    error / weight / mean, largest / mean, Math.sqrt(squaredNoise / weight) / mean);
        }
    }
}
