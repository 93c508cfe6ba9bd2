package radiosity.cli.render;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import radiosity.cli.options.Failure;

/** Collects the failures of several outputs, so that every output is attempted whatever became of earlier outputs. */
public final class Failures {

    private final List<Exception> failures = new ArrayList<>();

    /** Writes one output. */
    public interface Output {
        void write() throws IOException;
    }

    /** Attempts an output and keeps its failure; returns whether the output was written. */
    public boolean tried(Output output) {
        try {
            output.write();
            return true;
        } catch (RuntimeException | IOException e) {
            failures.add(e);
            return false;
        }
    }

    /**
     * Fails if any output failed.
     *
     * @throws Failure with the message of each failed output on a line of its own, and the exit code of the first one
     */
    public void check() {
        if (!failures.isEmpty()) {
            throw Failure.several(failures);
        }
    }
}
