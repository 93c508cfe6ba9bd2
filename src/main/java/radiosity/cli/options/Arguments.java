package radiosity.cli.options;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Stack;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.TypeConversionException;

/** Helpers for options that take several arguments. */
final class Arguments {

    private Arguments() { }

    /** Fails if an option has been given already. */
    static void once(ArgSpec option) {
        if (option.getValue() != null) {
            throw wrong(option, "expected once, got twice");
        }
    }

    /**
     * Removes the next argument from the rest of the command line and returns it; fails where none is left or the next
     * one is an option.
     *
     * @param expected description of all arguments of the option, for the message
     * @param before   the arguments of the option so far
     */
    static String next(Stack<String> arguments, ArgSpec option, String expected, String... before) {
        if (arguments.isEmpty() || isOption(arguments.peek(), option)) {
            throw wrong(option, "expected " + expected + ", got "
                    + (before.length == 0 ? "nothing" : String.join(" ", before))
                    + (arguments.isEmpty() ? "" : " before " + arguments.peek()));
        }
        return arguments.pop();
    }

    /** The next two arguments, as {@link #next} returns each. */
    static String[] two(Stack<String> arguments, ArgSpec option, String expected) {
        String first = next(arguments, option, expected);
        return new String[] {first, next(arguments, option, expected, first)};
    }

    /** Whether a text is or resembles an option; {@code -1,2,3} and {@code -y=0.85} do not. */
    private static boolean isOption(String text, ArgSpec other) {
        return text.startsWith("--") || other.command().optionsMap().containsKey(text.replaceFirst("=.*", ""));
    }

    static <T> T convert(Values.Value<T> kind, String text, ArgSpec option) {
        try {
            return kind.convert(text);
        } catch (TypeConversionException e) {
            throw wrong(option, e.getMessage());
        }
    }

    /** Converts an argument to a path; fails where the system does not allow it, like question marks on Windows. */
    static Path path(String text, ArgSpec option) {
        try {
            return Path.of(text);
        } catch (InvalidPathException e) {
            throw wrong(option, "expected a path, got " + text + " (" + e.getReason() + ")");
        }
    }

    /** Whether an argument is the name of a scene or model, by its file name extension. */
    static boolean isModel(String text) {
        return text.toLowerCase(Locale.ROOT).matches(".*\\.(lws|lwo|gltf|glb|obj|mtl|scene)");
    }

    static Failure wrong(ArgSpec option, String what) {
        return Failure.commandLine(name(option), what);
    }

    /** Shortest name of an option, which is the paper's, or the label of a positional parameter. */
    static String name(ArgSpec argument) {
        return argument instanceof OptionSpec option ? option.shortestName() : argument.paramLabel();
    }
}
