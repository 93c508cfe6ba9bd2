package radiosity.cli.render;

import java.util.function.Consumer;
import radiosity.cli.options.Failure;

/** What the user should know before a render; with {@code --strict} it ends the program instead. */
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

    /** For a warning that has been found not to be an error. */
    public void print(String warning) {
        user.accept("warning: " + warning);
    }
}
