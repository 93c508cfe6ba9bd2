package radiosity.cli.terminal;

import java.util.function.DoubleSupplier;
import radiosity.solution.Progress;

/** From the start of the process to the end of the time that the user gives it. */
public final class TimeCourse implements ProgressEstimate {

    private final double seconds;
    private final DoubleSupplier gone;
    private String label = "";

    /**
     * @param seconds above 0
     * @param gone    seconds since the process began
     */
    public TimeCourse(double seconds, DoubleSupplier gone) {
        this.seconds = seconds;
        this.gone = gone;
    }

    /** Seconds; negative when the time is over. */
    public double left() {
        return seconds - gone.getAsDouble();
    }

    @Override
    public double done(Progress now) {
        return Math.min(1, gone.getAsDouble() / seconds);
    }

    @Override
    public double left(Progress now) {
        return Math.max(0, left());
    }

    @Override
    public double asked() {
        return Double.NaN;
    }

    /** @param accuracy that is being calculated with, as the user would write it */
    public void at(String accuracy) {
        label = "at " + accuracy + ": ";
    }

    @Override
    public String label() {
        return label;
    }
}
