package radiosity.cli.options;

/** Exit codes of the programs. */
public final class ExitCode {

    /** The work is done, also where a key press ended it early. */
    public static final int DONE = 0;
    /** The program failed for a reason that concerns neither the command line nor a file. */
    public static final int FAILED = 1;
    /** The command line is wrong or contradicts itself. */
    public static final int COMMAND_LINE = 2;
    /** A file cannot be read or written, or there was a warning under {@code --strict}. */
    public static final int FILE = 3;
    /** None of the hosts could be used. */
    static final int NO_WORKER = 4;

    /** The work is done, but less exactly than {@code --accuracy} asks for. */
    public static final int NOT_ACCURATE = 5;

    private ExitCode() { }
}
