package radiosity.cli.options;

import picocli.CommandLine.Option;

/** Options of all programs. */
public final class CommonOptions {

    /** Heading in the help of these options and of the options of a program that belong to no other group. */
    static final String GROUP = "Besides";

    @Option(names = "--debug", description = "Print where in the program an error came from.")
    boolean debug;

    @Option(names = "--help", usageHelp = true, description = "Print this help and exit.")
    boolean help;

    @Option(names = "--version", versionHelp = true, description = "Print the version and exit.")
    boolean version;
}
