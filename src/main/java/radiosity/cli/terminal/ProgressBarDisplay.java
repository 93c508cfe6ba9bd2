package radiosity.cli.terminal;

import java.io.PrintStream;
import java.util.function.IntSupplier;
import java.util.function.LongSupplier;
import radiosity.solution.Progress;

/** Shows progress on one line of a terminal, which is rewritten at every change and erased at the end. */
public final class ProgressBarDisplay implements ProgressDisplay {

    private static final long NANOSECONDS_BETWEEN = 100_000_000L;

    private final PrintStream err;
    private final IntSupplier width;
    private final ProgressText text;
    private final LongSupplier clock;
    private long drawn;
    /** Number of characters on the line. */
    private int shown;

    /**
     * @param width of the terminal, characters; asked for whenever the line is written
     * @param clock nanoseconds, as {@link System#nanoTime}
     */
    public ProgressBarDisplay(PrintStream err, IntSupplier width, ProgressText text, LongSupplier clock) {
        this.err = err;
        this.width = width;
        this.text = text;
        this.clock = clock;
    }

    @Override
    public synchronized void phase(String name) {
        text.phase(name);
        draw();
    }

    @Override
    public synchronized void part(String name, double done, double all) {
        text.part(name, done, all);
        drawSoon();
    }

    @Override
    public synchronized void show(Progress progress) {
        text.show(progress);
        drawSoon();
    }

    private void drawSoon() {
        if (clock.getAsLong() - drawn >= NANOSECONDS_BETWEEN) {
            draw();
        }
    }

    private void draw() {
        drawn = clock.getAsLong();
        int fits = width.getAsInt() - 1;
        String line = text.bar(fits);
        err.print("\r" + line + " ".repeat(Math.max(0, Math.min(fits, shown) - line.length())));
        err.flush();
        shown = line.length();
    }

    @Override
    public synchronized void message(String line) {
        clear();
        err.println(line);
        draw();
    }

    private void clear() {
        err.print("\r" + " ".repeat(Math.min(width.getAsInt() - 1, shown)) + "\r");
        err.flush();
        shown = 0;
    }

    @Override
    public synchronized void close() {
        clear();
    }
}
