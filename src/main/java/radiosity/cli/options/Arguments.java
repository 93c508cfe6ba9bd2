package radiosity.cli.options;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Stack;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.TypeConversionException;

/** What options that take several arguments share. */
final class Arguments {

    private Arguments() { }

    /** Fails where an option that takes several arguments has been given already. */
    static void once(ArgSpec option) {
        if (option.getValue() != null) {
            throw wrong(option, "expected once, got twice");
        }
    }

    /** The next argument, removed from the rest of the command line. */
    static String next(Stack<String> arguments, ArgSpec option, String expected) {
        if (arguments.isEmpty()) {
            throw wrong(option, "expected " + expected + ", got nothing");
        }
        return arguments.pop();
    }

    static <T> T convert(Values.Value<T> kind, String text, ArgSpec option) {
        try {
            return kind.convert(text);
        } catch (TypeConversionException e) {
            throw wrong(option, e.getMessage());
        }
    }

    /** A path as this system takes it: on Windows without question marks, say. */
    static Path path(String text, ArgSpec option) {
        try {
            return Path.of(text);
        } catch (InvalidPathException e) {
            throw wrong(option, "expected a path, got " + text + " (" + e.getReason() + ")");
        }
    }

    /** Whether a text is a name of a scene, by its ending. */
    static boolean isModel(String text) {
        return text.toLowerCase(Locale.ROOT).matches(".*\\.(lws|lwo|gltf|glb|obj|mtl|scene)");
    }

    static Failure wrong(ArgSpec option, String what) {
        return Failure.commandLine(name(option), what);
    }

    /** The paper's name of an option, or what stands for it in the help. */
    static String name(ArgSpec argument) {
        return argument instanceof OptionSpec option ? option.shortestName() : argument.paramLabel();
    }
}
