package radiosity.cli.terminal;

import java.util.function.Consumer;

/** Whether somebody wants the calculation to end after the current round. */
public final class StopRequest {

    private volatile boolean made;
    private volatile Consumer<String> user = line -> { };

    /** @param to gets a line when the request is made: a round may take a while */
    public void tell(Consumer<String> to) {
        user = to;
    }

    public void make() {
        made = true;
        say("stopping after this round, then saving");
    }

    /** A message about the stop. */
    public void say(String line) {
        user.accept(line);
    }

    public boolean made() {
        return made;
    }
}
