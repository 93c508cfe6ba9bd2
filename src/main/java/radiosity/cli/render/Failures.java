package radiosity.cli.render;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import radiosity.cli.options.Failure;

/** The failures of several outputs, each of which is tried whatever became of those before it. */
public final class Failures {

    private final List<Exception> failures = new ArrayList<>();

    /** What writes one output. */
    public interface Output {
        void write() throws IOException;
    }

    /** @return whether it was written */
    public boolean tried(Output output) {
        try {
            output.write();
            return true;
        } catch (Failure | IOException e) {
            failures.add(e);
            return false;
        }
    }

    /**
     * Fails where an output did.
     *
     * @throws Failure with the message of each failed output on a line of its own, and the first one's exit code
     */
    public void check() {
        if (!failures.isEmpty()) {
            throw Failure.several(failures);
        }
    }
}
