package radiosity.cli.options;

import java.util.Comparator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.OverwrittenOptionException;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Parses a command line; any error in the command line becomes a {@link Failure} of one line. */
public final class CommandLineParser {

    private static final int MOST_SIMILAR = 2;

    private final CommandLine commandLine;

    /** @param options object with picocli annotations, filled by {@link #parse} */
    public CommandLineParser(Object options) {
        commandLine = new CommandLine(options)
                .setPosixClusteredShortOptionsAllowed(false)
                .setAbbreviatedOptionsAllowed(false)
                .setExpandAtFiles(false)
                .setUsageHelpWidth(100);
    }

    public ParseResult parse(String... arguments) {
        try {
            return commandLine.parseArgs(arguments);
        } catch (ParameterException e) {
            throw failure(e);
        }
    }

    public String help() {
        return HelpText.of(commandLine);
    }

    private static Failure failure(ParameterException e) {
        if (e.getCause() instanceof Failure own) {
            return own;
        }
        if (e instanceof UnmatchedArgumentException unmatched) {
            return unknown(unmatched.getUnmatched().get(0), unmatched.getCommandLine());
        }
        ArgSpec option = option(e);
        return Failure.commandLine(Arguments.name(option), what(e, option));
    }

    private static Failure unknown(String text, CommandLine commandLine) {
        if (!text.startsWith("-")) {
            return Failure.commandLine(text, "expected options that --help lists and no file, got one");
        }
        String written = text.replaceFirst("=.*", "");
        String similar = commandLine.getCommandSpec().options().stream().flatMap(option -> Stream.of(option.names()))
                .filter(name -> isSimilar(name, written)).sorted(Comparator.comparingInt(name -> edits(name, written)))
                .limit(MOST_SIMILAR).collect(Collectors.joining(" or "));
        return Failure.commandLine(text, "expected an option that --help lists, got an unknown one"
                + (similar.isEmpty() ? "" : "; did you mean " + similar + "?"));
    }

    private static boolean isSimilar(String name, String written) {
        return edits(name, written) <= written.length() / 3
                || name.startsWith("--") && written.length() > 4 && name.contains(written.replaceFirst("^-+", ""));
    }

    /** Least number of single-letter insertions, deletions, replacements and swaps of neighbours between two texts. */
    private static int edits(String a, String b) {
        int[][] edits = new int[a.length() + 1][b.length() + 1];
        for (int i = 0; i <= a.length(); i++) {
            for (int j = 0; j <= b.length(); j++) {
                edits[i][j] = i == 0 || j == 0 ? i + j : Math.min(Math.min(edits[i - 1][j], edits[i][j - 1]) + 1,
                        edits[i - 1][j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1));
                if (i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2) && a.charAt(i - 2) == b.charAt(j - 1)) {
                    edits[i][j] = Math.min(edits[i][j], edits[i - 2][j - 2] + 1);
                }
            }
        }
        return edits[a.length()][b.length()];
    }

    private static ArgSpec option(ParameterException e) {
        if (e instanceof OverwrittenOptionException twice) {
            return twice.getOverwritten();
        }
        return e instanceof MissingParameterException missing ? missing.getMissing().get(0) : e.getArgSpec();
    }

    private static String what(ParameterException e, ArgSpec option) {
        if (e instanceof OverwrittenOptionException) {
            return "expected once, got twice";
        }
        if (e.getCause() instanceof TypeConversionException wrong && option.arity().max() > 0) {
            return wrong.getMessage();
        }
        String got = e instanceof MissingParameterException ? "nothing" : e.getValue();
        return "expected " + expected(option) + ", got " + got;
    }

    private static String expected(ArgSpec option) {
        if (option.arity().max() == 0) {
            return "no value";
        }
        return option.converters().length > 0 && option.converters()[0] instanceof Values.Value<?> kind
                ? kind.expected() : option.paramLabel();
    }
}
