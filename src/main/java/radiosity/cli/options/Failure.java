package radiosity.cli.options;

import java.util.List;
import java.util.stream.Collectors;

/** Ends a program with one line, <i>where: expected X, got Y</i>, and an {@link ExitCode}. */
public final class Failure extends RuntimeException {

    private final int exitCode;

    private Failure(int exitCode, String message, Throwable cause) {
        super(message, cause);
        this.exitCode = exitCode;
    }

    public static Failure commandLine(String where, String what) {
        return new Failure(ExitCode.COMMAND_LINE, where + ": " + what, null);
    }

    public static Failure failed(String where, String what) {
        return new Failure(ExitCode.FAILED, where + ": " + what, null);
    }

    public static Failure file(Object where, String what, Throwable cause) {
        return new Failure(ExitCode.FILE, where + ": " + what, cause);
    }

    /** Fails where an option is given together with another that it excludes. */
    static void excludes(String option, String other, boolean areBothGiven) {
        if (areBothGiven) {
            throw commandLine(option, "expected without " + other + ", got both");
        }
    }

    /** Fails where an option is given without another that it needs. */
    static void needs(String option, String other, boolean isOtherMissing) {
        if (isOtherMissing) {
            throw commandLine(option, "expected with " + other + ", got it without");
        }
    }

    /** Failure of a render that is done and saved, but less exact than was asked for. */
    public static Failure notAccurate(String line) {
        return new Failure(ExitCode.NOT_ACCURATE, line, null);
    }

    /** Failure for a reason that concerns neither the command line nor a file. */
    public static Failure failed(String line, Throwable cause) {
        return new Failure(ExitCode.FAILED, line, cause);
    }

    /** A warning that counts as an error ({@code --strict}). */
    public static Failure strict(String warning) {
        return new Failure(ExitCode.FILE, warning, null);
    }

    /**
     * Combines several failures, each with a line of its own.
     *
     * @param failures at least one; the exit code is that of the first failure
     */
    public static Failure several(List<Exception> failures) {
        String lines = failures.stream().map(ErrorReport::line).collect(Collectors.joining(System.lineSeparator()));
        return new Failure(ErrorReport.exitCode(failures.get(0)), lines, failures.get(0));
    }

    /** This failure with more at the end of its line. */
    public Failure and(String more) {
        return new Failure(exitCode, getMessage() + "; " + more, getCause());
    }

    public int exitCode() {
        return exitCode;
    }
}
