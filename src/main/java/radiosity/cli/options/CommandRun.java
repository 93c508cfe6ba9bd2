package radiosity.cli.options;

import picocli.CommandLine.ParseResult;

/** One run of a program: reads its command line, answers --help and --version, and says in one line what went wrong. */
public final class CommandRun {

    /** What a program does. */
    public interface Work {
        void run() throws Exception;
    }

    private CommandRun() { }

    /**
     * Runs a program.
     *
     * @param options   annotated; filled before the work begins
     * @param common    among them
     * @param arguments of the command line
     * @return its {@link ExitCode}
     */
    public static int of(Object options, CommonOptions common, Work work, String... arguments) {
        try {
            CommandLineParser parser = new CommandLineParser(options);
            ParseResult parsed = parser.parse(arguments);
            if (parsed.isUsageHelpRequested()) {
                System.out.print(parser.help());
            } else if (parsed.isVersionHelpRequested()) {
                System.out.println(Version.text());
            } else {
                work.run();
            }
            return ExitCode.DONE;
        } catch (Exception | OutOfMemoryError | StackOverflowError e) {
            return new ErrorReport(System.err, common.debug).of(e);
        }
    }
}
