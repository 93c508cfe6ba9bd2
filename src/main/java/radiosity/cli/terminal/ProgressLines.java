package radiosity.cli.terminal;

import java.io.PrintStream;
import java.util.function.LongSupplier;
import radiosity.solution.Progress;

/** Prints progress as plain lines, for log files: a line for each longer phase, and at most one line a second. */
public final class ProgressLines implements ProgressDisplay {

    private static final long SECOND = 1_000_000_000L;
    /** Phases shorter than this get no line: a file that cannot be read is reported by its error alone. */
    private static final long SHORT_MILLISECONDS = 400;

    private final PrintStream err;
    private final ProgressText text;
    private final LongSupplier clock;
    private long printed;
    /** Whether the latest progress has not been printed. */
    private boolean isDue;
    /** The thread that prints the current phase if the phase lasts long enough; null for none. */
    private Thread waiting;
    /** Name of the task of the last call of {@link #part}. */
    private String part = "";

    /** @param clock nanoseconds, as {@link System#nanoTime} */
    public ProgressLines(PrintStream err, ProgressText text, LongSupplier clock) {
        this.err = err;
        this.text = text;
        this.clock = clock;
        printed = clock.getAsLong() - SECOND;
    }

    @Override
    public synchronized void phase(String name) {
        close();
        text.phase(name);
        waiting = new Thread(this::printPhase, "progress");
        waiting.setDaemon(true);
        waiting.start();
    }

    private void printPhase() {
        try {
            Thread.sleep(SHORT_MILLISECONDS);
        } catch (InterruptedException e) {
            return;
        }
        synchronized (this) {
            if (waiting == Thread.currentThread()) {
                err.println(text.line());
            }
        }
    }

    /** Prints the first line of a task after a second. */
    @Override
    public synchronized void part(String name, double done, double all) {
        waiting = null;
        text.part(name, done, all);
        if (!part.equals(name)) {
            part = name;
            printed = clock.getAsLong();
        } else if (clock.getAsLong() - printed >= SECOND) {
            printed = clock.getAsLong();
            print();
        }
    }

    @Override
    public synchronized void show(Progress progress) {
        waiting = null;
        text.show(progress);
        isDue = true;
        if (clock.getAsLong() - printed >= SECOND) {
            printed = clock.getAsLong();
            print();
        }
    }

    private void print() {
        err.println(text.line());
        isDue = false;
    }

    @Override
    public void message(String line) {
        err.println(line);
    }

    /** Prints the latest progress if it has not been printed. */
    @Override
    public synchronized void close() {
        waiting = null;
        if (isDue) {
            print();
        }
    }
}
