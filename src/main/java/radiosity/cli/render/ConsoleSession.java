package radiosity.cli.render;

import java.io.PrintStream;
import radiosity.cli.terminal.KeyListener;
import radiosity.cli.terminal.ProgressDisplay;
import radiosity.cli.terminal.StopRequest;
import radiosity.solution.Progress;

/** The terminal during a render: displays progress and messages, and turns any key press into a stop request. */
public final class ConsoleSession implements ProgressDisplay {

    private final PrintStream err;
    private final KeyListener keys;
    private volatile ProgressDisplay display;

    public ConsoleSession(PrintStream err, ProgressDisplay display, StopRequest stop) {
        this.err = err;
        this.display = display;
        keys = new KeyListener(stop::make);
        stop.tell(this::message);
    }

    /** Starts to listen for keys; called at most once. */
    void begin() {
        keys.listen();
    }

    @Override
    public void phase(String name) {
        display.phase(name);
    }

    @Override
    public void part(String name, double done, double all) {
        display.part(name, done, all);
    }

    @Override
    public void show(Progress progress) {
        display.show(progress);
    }

    @Override
    public void message(String line) {
        display.message(line);
    }

    @Override
    public void close() {
        keys.close();
        display.close();
        display = err::println;
    }
}
