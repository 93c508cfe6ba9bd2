package radiosity.cli;

import java.util.function.DoubleSupplier;
import radiosity.world.Progress;

/** From the start of the process to the end of the time that the user gives it. */
final class TimeCourse implements Course {

    private final double seconds;
    private final DoubleSupplier gone;
    private String label = "";

    /**
     * @param seconds above 0
     * @param gone    seconds since the process began
     */
    TimeCourse(double seconds, DoubleSupplier gone) {
        this.seconds = seconds;
        this.gone = gone;
    }

    /** Seconds; negative when the time is over. */
    double left() {
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

    /** @param accuracy that is being calculated with, as the user would write it */
    void at(String accuracy) {
        label = "at " + accuracy + ": ";
    }

    @Override
    public String label() {
        return label;
    }
}
