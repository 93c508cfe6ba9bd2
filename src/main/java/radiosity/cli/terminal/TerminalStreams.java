package radiosity.cli.terminal;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.jline.terminal.spi.SystemStream;
import org.jline.terminal.spi.TerminalProvider;

/** Tells which of the standard streams are a terminal. */
public final class TerminalStreams {

    private static final int USUAL_WIDTH = 80;
    private static final TerminalProvider PROVIDER = provider();

    private TerminalStreams() { }

    /**
     * JLine's provider; null where the machine has no native library for it, so that no stream counts as a terminal.
     */
    private static TerminalProvider provider() {
        try {
            return TerminalProvider.load("jni");
        } catch (IOException | LinkageError e) {
            return null;
        }
    }

    private static boolean is(SystemStream stream) {
        try {
            return PROVIDER != null && PROVIDER.isSystemStream(stream);
        } catch (LinkageError e) {
            return false;
        }
    }

    /** Whether a user sees the error stream, which then is a terminal. */
    public static boolean seen() {
        return is(SystemStream.Error);
    }

    /** Width of the error stream's terminal, characters; only to be called where the error stream is a terminal. */
    public static int width() {
        int width = PROVIDER.systemStreamWidth(SystemStream.Error);
        return width > 0 ? width : USUAL_WIDTH;
    }

    /** Whether key presses reach this program: not in the background, where reading the terminal would stop it. */
    static boolean keys() {
        return is(SystemStream.Input) && foreground();
    }

    private static boolean foreground() {
        try {
            Process ps = new ProcessBuilder("ps", "-o", "stat=", "-p", Long.toString(ProcessHandle.current().pid()))
                    .redirectErrorStream(true).start();
            String state = new String(ps.getInputStream().readAllBytes(), StandardCharsets.US_ASCII);
            return ps.waitFor() != 0 || state.contains("+");
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        } catch (IOException e) {
            return true;
        }
    }
}
