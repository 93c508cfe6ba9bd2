package radiosity.cli;

import java.io.PrintStream;
import radiosity.world.Progress;

/** Quiet mode ({@code -q}): messages only. */
final class NoProgress implements ProgressDisplay {

    private final PrintStream err;

    NoProgress(PrintStream err) {
        this.err = err;
    }

    @Override
    public void show(Progress progress) { }

    @Override
    public void message(String line) {
        err.println(line);
    }

    @Override
    public void close() { }
}
