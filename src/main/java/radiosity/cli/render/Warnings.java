package radiosity.cli.render;

import java.util.function.Consumer;
import radiosity.cli.options.Failure;

/** Passes warnings to the user; with {@code --strict}, a warning ends the program instead. */
public final class Warnings implements Consumer<String> {

    private final Consumer<String> user;
    private final boolean strict;

    public Warnings(Consumer<String> user, boolean strict) {
        this.user = user;
        this.strict = strict;
    }

    @Override
    public void accept(String warning) {
        if (strict) {
            throw Failure.strict(warning);
        }
        print(warning);
    }

    /** Prints a warning of a scene reader, which has applied {@code --strict} itself. */
    public void print(String warning) {
        user.accept("warning: " + warning);
    }
}
