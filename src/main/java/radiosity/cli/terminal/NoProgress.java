package radiosity.cli.terminal;

import java.io.PrintStream;
import radiosity.solution.Progress;

/** Display of quiet mode ({@code -q}): prints messages only. */
public final class NoProgress implements ProgressDisplay {

    private final PrintStream err;

    public NoProgress(PrintStream err) {
        this.err = err;
    }

    @Override
    public void phase(String name) { }

    @Override
    public void part(String name, double done, double all) { }

    @Override
    public void show(Progress progress) { }

    @Override
    public void message(String line) {
        err.println(line);
    }

    @Override
    public void close() { }
}
