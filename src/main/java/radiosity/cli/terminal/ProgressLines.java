package radiosity.cli.terminal;

import java.io.PrintStream;
import java.util.function.LongSupplier;
import radiosity.solution.Progress;

/** Plain lines, not more than one a second, where there is no terminal: for log files. */
public final class ProgressLines implements ProgressDisplay {

    private static final long SECOND = 1_000_000_000L;

    private final PrintStream err;
    private final ProgressText text;
    private final LongSupplier clock;
    private long printed;
    private Progress shown;
    private Progress latest;

    /** @param clock nanoseconds, as {@link System#nanoTime} */
    public ProgressLines(PrintStream err, ProgressText text, LongSupplier clock) {
        this.err = err;
        this.text = text;
        this.clock = clock;
        printed = clock.getAsLong() - SECOND;
    }

    @Override
    public void show(Progress progress) {
        latest = progress;
        if (clock.getAsLong() - printed >= SECOND) {
            print();
        }
    }

    private void print() {
        printed = clock.getAsLong();
        shown = latest;
        err.println(text.of(latest));
    }

    @Override
    public void message(String line) {
        err.println(line);
    }

    /** The last line is always printed. */
    @Override
    public void close() {
        if (latest != shown) {
            print();
        }
    }
}
