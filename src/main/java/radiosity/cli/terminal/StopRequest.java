package radiosity.cli.terminal;

import java.util.function.Consumer;

/** The user's request to end the calculation after the current round, or to leave out unfinished pictures. */
public final class StopRequest {

    private static final String STOPPING = "stopping after this round, then saving";

    private volatile boolean made;
    private volatile boolean everMade;
    private volatile String answer = STOPPING;
    private volatile Consumer<String> user = line -> { };

    /** @param to receives a line when the request is made, as the current round may take a while */
    public void tell(Consumer<String> to) {
        user = to;
    }

    public void make() {
        everMade = true;
        made = true;
        say(answer);
    }

    /** Says that a calculation begins, which the next request ends; a request that is already made stays. */
    public void begin() {
        answer = STOPPING;
    }

    /**
     * Clears the request, which has been fulfilled, when other work begins; {@link #everMade} stays true.
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

    /** Whether a request was made since the program began, cleared or not: no further calculation is to begin. */
    public boolean everMade() {
        return everMade;
    }
}
