package radiosity.cli.options;

import picocli.CommandLine.ParseResult;

/** Runs a program: parses its command line, answers --help and --version, and reports an error in one line. */
public final class CommandRun {

    /** The work of a program. */
    public interface Work {
        void run() throws Exception;
    }

    private CommandRun() { }

    /**
     * Runs a program.
     *
     * @param options   object with picocli annotations, filled before the work begins
     * @param common    the part of {@code options} that all programs share
     * @param arguments the command line
     * @return the {@link ExitCode}
     */
    public static int of(Object options, CommonOptions common, Work work, String... arguments) {
        try {
            CommandLineParser parser = new CommandLineParser(options);
            ParseResult parsed = parser.parse(arguments);
            if (parsed.isUsageHelpRequested()) {
                System.out.print(parser.help());
            } else if (parsed.isVersionHelpRequested()) {
                System.out.println(version());
            } else {
                work.run();
            }
            return ExitCode.DONE;
        } catch (Exception | OutOfMemoryError | StackOverflowError e) {
            return new ErrorReport(System.err, common.debug).of(e);
        }
    }

    /** Name and version of the program; the version is read from the jar's manifest. */
    private static String version() {
        String version = CommandRun.class.getPackage().getImplementationVersion();
        return "radiosity " + (version == null ? "(not from a jar)" : version);
    }
}
