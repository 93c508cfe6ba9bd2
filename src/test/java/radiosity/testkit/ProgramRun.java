package radiosity.testkit;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import radiosity.cli.RadiosityRenderer;

/**
 * A run of RadiosityRenderer in this process.
 *
 * @param exitCode what it returned
 * @param out      what it printed
 * @param err      what it printed as errors, warnings and progress
 */
public record ProgramRun(int exitCode, String out, String err) {

    public static ProgramRun of(Object... arguments) {
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
            return new ProgramRun(RadiosityRenderer.run(words), "", "").with(newOut, newErr);
        } finally {
            System.setOut(out);
            System.setErr(err);
        }
    }

    private ProgramRun with(ByteArrayOutputStream newOut, ByteArrayOutputStream newErr) {
        return new ProgramRun(exitCode, newOut.toString(StandardCharsets.UTF_8),
                newErr.toString(StandardCharsets.UTF_8));
    }
}
