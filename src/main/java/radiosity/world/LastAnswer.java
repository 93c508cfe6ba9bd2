package radiosity.world;

import java.io.IOException;

/** How things stood when all partitions said it last, and how old that is. */
final class LastAnswer {

    /** So often at least it is asked within a round how things stand, for whoever watches; it costs time. */
    private static final double ANSWER_SECONDS = 4;

    private final World world;
    private final Agenda agenda;
    private final Pace pace;
    private Answer answer;
    /** Whether that is the answer to the last order. */
    private boolean isKnown = true;
    /** When it came, ns. */
    private long known;

    LastAnswer(World world, Agenda agenda, Pace pace) {
        this.world = world;
        this.agenda = agenda;
        this.pace = pace;
        known = world.now();
    }

    Answer get() {
        return answer;
    }

    /** Whether somebody who watches may want to know more by now. */
    boolean isOld() {
        return world.now() - known > ANSWER_SECONDS * 1e9;
    }

    /** Reads the first answer that was not read yet. */
    void read() throws IOException {
        answer = world.read(pace::took);
        known = world.now();
        isKnown = world.unread() == 0 && agenda.isBetweenRounds();
    }

    /** Reads all that are not read yet. */
    void catchUp() throws IOException {
        while (world.unread() > 0) {
            read();
        }
    }

    /** Nothing is unread. */
    void ask(Order question) throws IOException {
        answer = world.answer(question);
        isKnown = true;
        known = world.now();
    }

    /** Asks where the last order was not answered; nothing is unread. */
    void know() throws IOException {
        if (!isKnown) {
            ask(Order.plain(Order.Kind.ASK, 0));
        }
    }

    /** @param isAnswered whether the order that was begun now is the last one, and its answer was read */
    void begun(boolean isAnswered) {
        isKnown = isAnswered;
    }
}
