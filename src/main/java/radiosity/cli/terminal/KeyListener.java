package radiosity.cli.terminal;

import java.io.IOException;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.jline.terminal.Attributes;
import org.jline.terminal.Terminal;
import org.jline.terminal.TerminalBuilder;

/**
 * Waits for any key on the terminal (section C.2 of the paper). Standard input that is no terminal is not read.
 *
 * <p>Ctrl-C still interrupts the program: only line editing and echo are switched off while the listener waits.
 */
public final class KeyListener implements AutoCloseable {

    private static final long WAIT_MILLISECONDS = 100;

    private final Runnable pressed;
    private final Thread thread = new Thread(this::openTerminal, "key listener");
    private volatile boolean closed;

    /** JLine's messages are for programmers: an unknown kind of terminal has keys as any other. */
    private static final Logger JLINE = Logger.getLogger("org.jline");

    static {
        JLINE.setLevel(Level.OFF);
    }

    /** @param pressed called on the first key, on the listener's own thread */
    public KeyListener(Runnable pressed) {
        this.pressed = pressed;
        thread.setDaemon(true);
    }

    /** Starts to wait for a key; returns at once. */
    public void listen() {
        thread.start();
    }

    private void openTerminal() {
        if (!TerminalStreams.keys()) {
            return;
        }
        try (Terminal terminal = TerminalBuilder.builder().provider("jni").dumb(false).nativeSignals(false).build()) {
            Attributes before = terminal.enterRawMode();
            try {
                await(terminal);
            } finally {
                terminal.setAttributes(before);
            }
        } catch (IOException | IllegalStateException e) {
            // the terminal has gone away: no key can be pressed
        }
    }

    private void await(Terminal terminal) throws IOException {
        while (!closed) {
            if (terminal.reader().read(WAIT_MILLISECONDS) >= 0) {
                pressed.run();
                return;
            }
        }
    }

    /**
     * Stops waiting and restores the terminal.
     *
     * <p>On Ctrl-C the terminal library restores the terminal itself, and the listener's thread may then wait for a
     * whole line of input; therefore this method waits for the thread for a limited time only.
     */
    @Override
    public void close() {
        closed = true;
        try {
            thread.join(5 * WAIT_MILLISECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
