package radiosity.cli;

import java.io.PrintStream;
import java.util.function.Consumer;

/** What the user should know before a render; with {@code --strict} it ends the program instead. */
final class Warnings implements Consumer<String> {

    private final PrintStream err;
    private final boolean strict;

    Warnings(PrintStream err, boolean strict) {
        this.err = err;
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
    void print(String warning) {
        err.println("warning: " + warning);
    }
}
