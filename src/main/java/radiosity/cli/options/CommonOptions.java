package radiosity.cli.options;

import picocli.CommandLine.Option;

/** What all programs have. */
public final class CommonOptions {

    /** The group of the help in which they stand, with a command's own. */
    static final String GROUP = "Besides";

    @Option(names = "--debug", description = "Print where in the program an error came from.")
    boolean debug;

    @Option(names = "--help", usageHelp = true, description = "Print this help and exit.")
    boolean help;

    @Option(names = "--version", versionHelp = true, description = "Print the version and exit.")
    boolean version;
}
