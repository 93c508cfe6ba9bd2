package radiosity.cli.options;

/** What a program returns to its caller. */
public final class ExitCode {

    /** The work is done, also when a key ended it early. */
    public static final int DONE = 0;
    /** It failed for a reason that is neither the command line's nor a file's. */
    public static final int FAILED = 1;
    /** The command line asks for something that cannot be meant. */
    public static final int COMMAND_LINE = 2;
    /** A file cannot be read or written. */
    public static final int FILE = 3;
    /** None of the hosts could be used. */
    static final int NO_WORKER = 4;

    /** The work is done, but not as exactly as {@code --accuracy} asked for. */
    public static final int NOT_ACCURATE = 5;

    private ExitCode() { }
}
