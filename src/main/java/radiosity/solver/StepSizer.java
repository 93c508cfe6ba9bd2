package radiosity.solver;

import radiosity.protocol.Order;

/**
 * Chooses the number of shots of a step such that a user who stops the calculation does not wait; the number has no
 * influence on the result.
 *
 * <p>The first step of a kind of round, and the first step after idle time, is one shot. Shots differ in duration; the
 * sizer remembers slow shots longer than fast ones.
 */
public final class StepSizer {

    /** Wanted duration of a step, s. */
    public static final double STEP_SECONDS = 0.25;
    /** Largest number of shots of a step over the number of the step before. */
    private static final int GROWTH = 4;
    /** First guess of the time for one entry of the coarse system, s. */
    private static final double ENTRY_SECONDS = 5e-8;
    /** Part of the estimated time per shot that is kept where a step was faster. */
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
     * The number of shots of the next step.
     *
     * @param now     kind of the present round
     * @param receive number of elements, or of entries of the coarse system per shot
     * @param left    number of shots left in the round
     * @return from 1 to {@code left}
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

    /** Notes that no step is under way. */
    void rest() {
        last = 0;
    }

    /** Notes the duration of a step, s. */
    void took(int shots, double seconds) {
        last = Math.max(1, shots);
        secondsPerShot = Math.max(seconds / last, MEMORY * secondsPerShot);
    }
}
