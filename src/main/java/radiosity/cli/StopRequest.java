package radiosity.cli;

import java.util.function.Consumer;

/** Whether somebody wants the calculation to end after the current round. */
final class StopRequest {

    private volatile boolean made;
    private volatile Consumer<String> user = line -> { };

    /** @param to gets a line when the request is made: a round may take a while */
    void tell(Consumer<String> to) {
        user = to;
    }

    void make() {
        made = true;
        user.accept("stopping after this round, then saving");
    }

    boolean made() {
        return made;
    }
}
