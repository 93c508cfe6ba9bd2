package radiosity.solver;

import radiosity.protocol.Order;

/**
 * How many shots to do at a time, so that a user who wants to stop does not wait; without influence on the result.
 *
 * <p>The first of a kind of round is done alone, and where nobody is at work, so that all begin soon. Shots are not
 * alike: of those before, the slow ones are remembered.
 */
public final class StepSizer {

    /** How long a step is to take, s: a stop is not much farther away. */
    public static final double STEP_SECONDS = 0.25;
    /** A step holds at most this many times the shots of the last one. */
    private static final int GROWTH = 4;
    /** What an entry of the coarse system is taken to need at first, s; other kinds of round may need anything. */
    private static final double ENTRY_SECONDS = 5e-8;
    /** How much of a slow step is remembered from one step to the next. */
    private static final double MEMORY = 0.8;

    private final double stepSeconds;
    private Order.Kind kind;
    private int elements;
    private int last;
    private double secondsPerShot;

    StepSizer(double stepSeconds) {
        this.stepSeconds = stepSeconds;
    }

    /**
     * How many of the shots that are left to do next.
     *
     * @param now     kind of the present round
     * @param receive elements that there are, or entries of the coarse system per shot
     */
    int size(Order.Kind now, int receive, int left) {
        if (now != kind) {
            kind = now;
            last = now == Order.Kind.ROWS ? left : 0;
            secondsPerShot = now == Order.Kind.ROWS ? ENTRY_SECONDS * receive : 0;
            elements = receive;
        }
        secondsPerShot *= (double) receive / Math.max(1, elements);
        elements = receive;
        double most = secondsPerShot == 0 ? 1 : Math.min(GROWTH * (double) last, stepSeconds / secondsPerShot);
        return (int) Math.max(1, Math.min(left, most));
    }

    /** Nothing is under way. */
    void rest() {
        last = 0;
    }

    /** Takes into account how long a step took; several may have been under way. */
    void took(int shots, double seconds) {
        last = Math.max(1, shots);
        secondsPerShot = Math.max(seconds / last, MEMORY * secondsPerShot);
    }
}
