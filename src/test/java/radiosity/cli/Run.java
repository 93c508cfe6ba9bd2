package radiosity.cli;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/**
 * A run of RadiosityRenderer in this process.
 *
 * @param exitCode what it returned
 * @param out      what it printed
 * @param err      what it printed as errors, warnings and progress
 */
record Run(int exitCode, String out, String err) {

    static Run of(Object... arguments) {
        String[] words = new String[arguments.length];
        for (int i = 0; i < words.length; i++) {
            words[i] = arguments[i].toString();
        }
        PrintStream out = System.out;
        PrintStream err = System.err;
        ByteArrayOutputStream newOut = new ByteArrayOutputStream();
        ByteArrayOutputStream newErr = new ByteArrayOutputStream();
        try {
            System.setOut(new PrintStream(newOut, true, StandardCharsets.UTF_8));
            System.setErr(new PrintStream(newErr, true, StandardCharsets.UTF_8));
            return new Run(RadiosityRenderer.run(words), "", "").with(newOut, newErr);
        } finally {
            System.setOut(out);
            System.setErr(err);
        }
    }

    private Run with(ByteArrayOutputStream newOut, ByteArrayOutputStream newErr) {
        return new Run(exitCode, newOut.toString(StandardCharsets.UTF_8), newErr.toString(StandardCharsets.UTF_8));
    }
}
