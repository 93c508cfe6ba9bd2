package radiosity.cli.terminal;

import java.util.function.Consumer;

/** Whether somebody wants the calculation to end after the current round, or pictures not to be drawn. */
public final class StopRequest {

    private volatile boolean made;
    private volatile String answer = "stopping after this round, then saving";
    private volatile Consumer<String> user = line -> { };

    /** @param to gets a line when the request is made: a round may take a while */
    public void tell(Consumer<String> to) {
        user = to;
    }

    public void make() {
        made = true;
        say(answer);
    }

    /** From now on something else is under way: what was asked before has been done, and a request means that. */
    public void renew(String newAnswer) {
        answer = newAnswer;
        made = false;
    }

    /** A message about the stop. */
    public void say(String line) {
        user.accept(line);
    }

    public boolean made() {
        return made;
    }
}
