package radiosity.cli.render;

/**
 * Chooses the accuracy that is asked for next within what is left of a time limit.
 *
 * <p>The time of a whole calculation is modelled as a power of 1 / error, and going on from a larger error as the
 * difference. The constants limit the extrapolation.
 */
public final class AccuracyChoice {

    /** Accuracy that is asked for first, a relative error as all accuracies here. */
    public static final double COARSEST = 0.2;
    /** Finest accuracy that is tried: a certificate cannot confirm finer ones. */
    public static final double FINEST = 1e-4;
    /** Part of the time left that a finer solution is predicted to take; the rest is for its refinement. */
    private static final double SHARE = 0.75;
    /** Largest and smallest ratio between an error and the accuracy that is asked for next. */
    private static final double MOST_GAIN = 3;
    private static final double LEAST_GAIN = 1.1;
    /** Exponent of 1 / error by which time grows at most: so does the number of rays. */
    private static final double POWER = 2;
    /** Exponent of 1 / error by which the number of elements grows; upper bound of the memory per element, bytes. */
    private static final double ELEMENTS_POWER = 1.5;
    private static final double ELEMENT_BYTES = 1000;

    /** Shortest time that a clock can measure reliably, s. */
    private static final double SHORTEST = 1e-3;

    private final double memory;
    private double error;
    private double seconds;
    private double elements;

    /** @param memory available to a calculation, bytes */
    public AccuracyChoice(double memory) {
        this.memory = memory;
    }

    /**
     * Records the present solution, for the next choice.
     *
     * @param error    relative error of the solution
     * @param seconds  wall time since the first shot
     * @param elements number of elements of the solution's mesh
     */
    public void reached(double error, double seconds, int elements) {
        this.error = error;
        this.seconds = Math.max(SHORTEST, seconds);
        this.elements = elements;
    }

    /**
     * The accuracy to ask for next.
     *
     * @param secondsLeft rest of the time limit, s; may be negative
     * @return 0 where no notably finer solution is possible in that time, or fits into memory
     */
    public double next(double secondsLeft) {
        if (seconds == 0) {
            return COARSEST;
        }
        double inTime = StrictMath.pow(1 + SHARE * Math.max(0, secondsLeft) / seconds, 1 / POWER);
        double most = Math.min(StrictMath.pow(memory / (ELEMENT_BYTES * elements), 1 / ELEMENTS_POWER),
                error / FINEST);
        double gain = Math.min(Math.min(most, MOST_GAIN), inTime);
        return gain >= LEAST_GAIN ? error / gain : 0;
    }
}
