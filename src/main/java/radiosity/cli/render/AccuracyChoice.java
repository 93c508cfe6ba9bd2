package radiosity.cli.render;

/**
 * Which accuracy to try next in what is left of a time limit.
 *
 * <p>Time grows as a power of accuracy, slowly where what does not depend on it takes most of it. The power is that
 * between the last two calculations, or a usual one, and is trusted only so far beyond them. The figures here decide
 * how much of the time is made use of; each was chosen from what {@code docs/ACCURACY.md} has.
 */
public final class AccuracyChoice {

    /** Where to begin: coarser ones are no quicker. Part of 1, as all accuracies here. */
    public static final double COARSEST = 0.5;
    /** Finer ones are beyond what is certified. */
    public static final double FINEST = 1e-4;
    /** What a finer calculation may take of the time that is left: predictions err. */
    private static final double SHARE = 0.75;
    /** How much finer the next one may be, and must be. */
    private static final double MOST_GAIN = 5;
    private static final double LEAST_GAIN = 1.15;
    /** Of the first calculation's time, what the JVM takes to get warm, s; but not more than half. */
    private static final double WARM_UP = 1;
    /** Powers of time in accuracy: after the coarsest one, where what does not depend on it takes most; and finer. */
    private static final double FIRST_POWER = 0.7;
    private static final double LEAST_POWER = 1;
    private static final double MOST_POWER = 2;
    /** It grows as accuracy does. */
    private static final double GROWING = 0.2;
    /** The number of elements grows with this power, and each takes at most this number of bytes. */
    private static final double ELEMENTS_POWER = 1.5;
    private static final double ELEMENT_BYTES = 1000;

    /** What clocks can tell, s. */
    private static final double SHORTEST = 1e-3;

    private final double memory;
    private double accuracy;
    private double seconds;
    private double elements;
    private double power = FIRST_POWER;

    /** @param memory bytes that there are */
    public AccuracyChoice(double memory) {
        this.memory = memory;
    }

    /** Takes into account how long a calculation took. */
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

    /** What to calculate with next; 0 where nothing finer can be expected to be done in time. */
    public double next(double secondsLeft) {
        if (seconds == 0) {
            return COARSEST;
        }
        double gain = StrictMath.pow(Math.max(0, SHARE * secondsLeft) / seconds, 1 / power);
        double fits = StrictMath.pow(memory / (ELEMENT_BYTES * elements), 1 / ELEMENTS_POWER);
        gain = Math.min(Math.min(gain, MOST_GAIN), Math.min(fits, accuracy / FINEST));
        return gain < LEAST_GAIN ? 0 : accuracy / gain;
    }
}
