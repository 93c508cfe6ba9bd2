package radiosity.cli.options;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import radiosity.master.host.NoWorkerException;
import radiosity.scene.SceneFormatException;
import radiosity.util.NoNumberException;
import radiosity.util.TooLargeException;

/** Turns the error that ended a program into a message for the user and an {@link ExitCode}. */
public final class ErrorReport {

    private final PrintStream err;
    private final boolean debug;

    /** @param debug whether to print stack traces */
    ErrorReport(PrintStream err, boolean debug) {
        this.err = err;
        this.debug = debug;
    }

    int of(Throwable error) {
        err.println(line(error));
        if (debug) {
            error.printStackTrace(err);
        }
        return exitCode(error);
    }

    static int exitCode(Throwable error) {
        if (error instanceof Failure failure) {
            return failure.exitCode();
        }
        if (error instanceof NoWorkerException) {
            return ExitCode.NO_WORKER;
        }
        return error instanceof IOException ? ExitCode.FILE : ExitCode.FAILED;
    }

    /** The message of an error for the user. */
    public static String line(Throwable error) {
        if (error instanceof OutOfMemoryError) {
            return outOfMemory();
        }
        if (error instanceof Failure || error instanceof SceneFormatException || error instanceof NoWorkerException
                || error instanceof NoNumberException || error instanceof TooLargeException) {
            return error.getMessage();
        }
        if (error instanceof FileSystemException problem) {
            return problem.getFile() + ": expected to be read and written, got " + reason(problem);
        }
        return "internal error: " + error.toString().replaceAll("\\s*\\R\\s*", " ")
                + "; please report it with the output of --debug";
    }

    /** The message for a full heap (section C.7 of the paper). */
    private static String outOfMemory() {
        long mebibytes = Runtime.getRuntime().maxMemory() >> 20;
        return "memory: expected more than " + mebibytes + " MiB; give, say, JAVA_OPTS=-Xmx" + 2 * mebibytes
                + "m, or a larger -pa";
    }

    /** Why a file cannot be used, without the file's name; "none" where there is no such file. */
    public static String reason(IOException e) {
        if (e instanceof NoSuchFileException) {
            return "none";
        }
        String reason = e instanceof FileSystemException problem ? problem.getReason() : e.getMessage();
        return reason == null ? e.getClass().getSimpleName() : reason;
    }
}
