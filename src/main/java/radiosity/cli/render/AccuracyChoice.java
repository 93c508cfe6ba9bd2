package radiosity.cli.render;

/**
 * Chooses the accuracy that is asked for next within what is left of a time limit.
 *
 * <p>The time to the first estimate of the error with an accuracy is modelled as a power of 1 / accuracy: if the time
 * limit comes later, that solution is kept, and the time until then is spent on refining it. The exponent is the one
 * observed between the last two accuracies, within bounds, and a constant before there are two; it is small where work
 * that does not depend on the accuracy dominates. The constants limit the extrapolation.
 *
 * <p>Where a scene begins with many elements, the first accuracy may be exceeded by far; a next one that is reached
 * already would teach nothing.
 */
public final class AccuracyChoice {

    /** Accuracy that is asked for first, a relative error as all accuracies here. */
    public static final double COARSEST = 0.2;
    /** Finest accuracy that is tried: a certificate cannot confirm finer ones. */
    public static final double FINEST = 1e-4;
    /** Part of the time left that the first estimate is predicted to take at most; the rest is for refining. */
    private static final double SHARE = 0.75;
    /** Largest and smallest ratio between an accuracy and the next one. */
    private static final double MOST_GAIN = 3;
    private static final double LEAST_GAIN = 1.25;
    /** Part of the time to the last first estimate below which the time left is too short for a finer solution. */
    private static final double LEAST_LEFT = 0.25;
    /** Time of the first calculation that is attributed to JVM warm-up, s; at most half of its time is. */
    private static final double WARM_UP = 1;
    /** Exponent after the first calculation, which work independent of the accuracy dominates; bounds of later ones. */
    private static final double FIRST_POWER = 0.7;
    private static final double LEAST_POWER = 1;
    private static final double MOST_POWER = 2;
    /** Added to the observed exponent, as the exponent grows with finer accuracy. */
    private static final double GROWING = 0.2;
    /** Exponent of 1 / accuracy by which the number of elements grows; upper bound of the memory per element, bytes. */
    private static final double ELEMENTS_POWER = 1.5;
    private static final double ELEMENT_BYTES = 1000;

    /** Shortest time that a clock can measure reliably, s. */
    private static final double SHORTEST = 1e-3;

    private final double memory;
    private double accuracy;
    private double seconds;
    private double elements;
    private double power = FIRST_POWER;

    /** @param memory available to a calculation, bytes */
    public AccuracyChoice(double memory) {
        this.memory = memory;
    }

    /**
     * Records the first estimate with an accuracy, for the next choice.
     *
     * @param accuracy relative error that was asked for, or reached where that is less
     * @param seconds  wall time to the estimate since the accuracy was asked for
     * @param elements number of elements of the mesh that reached the accuracy
     */
    public void took(double accuracy, double seconds, int elements) {
        double now = Math.max(SHORTEST, seconds);
        if (this.seconds == 0) {
            now = Math.max(now / 2, now - WARM_UP);
        } else {
            double seen = StrictMath.log(now / this.seconds) / StrictMath.log(this.accuracy / accuracy);
            power = Math.max(LEAST_POWER, Math.min(MOST_POWER, seen + GROWING));
        }
        this.accuracy = accuracy;
        this.seconds = now;
        this.elements = elements;
    }

    /**
     * The accuracy to ask for next.
     *
     * @param secondsLeft rest of the time limit, s; may be negative
     * @return 0 where hardly any time is left, or no notably finer calculation fits into memory
     */
    public double next(double secondsLeft) {
        if (seconds == 0) {
            return COARSEST;
        }
        double inTime = StrictMath.pow(Math.max(0, SHARE * secondsLeft) / seconds, 1 / power);
        double most = Math.min(StrictMath.pow(memory / (ELEMENT_BYTES * elements), 1 / ELEMENTS_POWER),
                accuracy / FINEST);
        boolean isWorthwhile = secondsLeft >= LEAST_LEFT * seconds && most >= LEAST_GAIN;
        return isWorthwhile ? accuracy / Math.min(most, Math.max(LEAST_GAIN, Math.min(MOST_GAIN, inTime))) : 0;
    }
}
