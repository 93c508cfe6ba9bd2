package radiosity.cli.terminal;

import java.io.IOException;
import org.jline.terminal.Attributes;
import org.jline.terminal.Terminal;
import org.jline.terminal.TerminalBuilder;

/**
 * Waits for any key on the terminal (section C.2 of the paper). Standard input that is no terminal is not read.
 *
 * <p>Ctrl-C stays what it is: only line editing and echo are switched off meanwhile.
 */
public final class KeyListener implements AutoCloseable {

    private static final long WAIT_MILLISECONDS = 100;

    private final Runnable pressed;
    private final Thread thread = new Thread(this::openTerminal, "key listener");
    private volatile boolean closed;

    /** @param pressed called once, on a thread of its own */
    public KeyListener(Runnable pressed) {
        this.pressed = pressed;
        thread.setDaemon(true);
    }

    /** Begins to wait; returns at once. */
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
            // the terminal has gone away, and with it the keys
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
     * Returns when the terminal is as it was.
     *
     * <p>On Ctrl-C the terminal library gives it back itself, and the thread may then wait for a whole line; so it is
     * not waited for without end.
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
