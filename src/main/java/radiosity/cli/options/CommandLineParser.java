package radiosity.cli.options;

import picocli.CommandLine;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.OverwrittenOptionException;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Reads a command line; whatever is wrong with it becomes one line. */
public final class CommandLineParser {

    private final CommandLine commandLine;

    /** @param options annotated; filled by {@link #parse} */
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
            return Failure.commandLine(unmatched.getUnmatched().get(0),
                    "expected an option that --help lists, got an unknown one");
        }
        ArgSpec option = option(e);
        return Failure.commandLine(Arguments.name(option), what(e, option));
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
