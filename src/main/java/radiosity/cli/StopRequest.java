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
        say("stopping after this round, then saving");
    }

    /** A message about the stop. */
    void say(String line) {
        user.accept(line);
    }

    boolean made() {
        return made;
    }
}
