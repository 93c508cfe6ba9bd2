package radiosity.cli.terminal;

import java.util.function.Consumer;

/** The user's request to end the calculation after the current round, or to leave out unfinished pictures. */
public final class StopRequest {

    private volatile boolean made;
    private volatile String answer = "stopping after this round, then saving";
    private volatile Consumer<String> user = line -> { };

    /** @param to receives a line when the request is made, as the current round may take a while */
    public void tell(Consumer<String> to) {
        user = to;
    }

    public void make() {
        made = true;
        say(answer);
    }

    /**
     * Clears the request, which has been fulfilled, when other work begins.
     *
     * @param newAnswer line for the user when the next request is made
     */
    public void renew(String newAnswer) {
        answer = newAnswer;
        made = false;
    }

    /** Sends a line about the stop to the user. */
    public void say(String line) {
        user.accept(line);
    }

    public boolean made() {
        return made;
    }
}
