package radiosity.solver;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;

/**
 * How things stood when all partitions said it last, and how old that is.
 *
 * <p>There are two answers. The newest one is for whoever watches or saves, at any time. The one after the last whole
 * round is what the next round is chosen by: which one that is depends on the rounds alone, never on when somebody
 * looked.
 */
final class LatestStatus {

    /** So often at least it is asked within a round how things stand, for whoever watches; it costs time. */
    private static final double ANSWER_SECONDS = 4;

    private final World world;
    private final StepSizer sizer;
    /** Answers to orders of this calculation that nobody has read, in the order of the orders. */
    private final Deque<Unread> unread = new ArrayDeque<>();
    private Answer newest;
    private Answer afterRound;
    /** Whether the last order is one that is answered. */
    private boolean isLastAnswered;
    /** When the newest answer came, ns. */
    private long known;

    private record Unread(Order order, World.Begun begun) { }

    LatestStatus(World world, StepSizer sizer) {
        this.world = world;
        this.sizer = sizer;
        known = world.now();
    }

    /** The newest answer that was read; null before the first question. */
    Answer newest() {
        return newest;
    }

    /**
     * The answer to the last whole round of those that were read, or to a question since; null before the first one.
     */
    Answer afterRound() {
        return afterRound;
    }

    /** Whether somebody who watches may want to know more by now. */
    boolean isOld() {
        return world.now() - known > ANSWER_SECONDS * 1e9;
    }

    /** Takes over an order, or a step of a round, that was begun; its answer is read later. */
    void begun(Order order, World.Begun begun) {
        isLastAnswered = order.isAnswered();
        if (isLastAnswered) {
            unread.add(new Unread(order, begun));
        }
    }

    /** Reads the first answer that was not read yet. */
    private void read() throws IOException {
        Unread first = unread.remove();
        newest = first.begun.answer(sizer::took);
        known = world.now();
        if (!first.order.more()) {
            afterRound = newest;
        }
    }

    /** Waits for all answers, and reads them. */
    void catchUp() throws IOException {
        while (!unread.isEmpty()) {
            read();
        }
    }

    /** Reads all answers but the one to the last whole round, and those after it. */
    void catchUpToRoundBefore() throws IOException {
        while (unread.stream().filter(one -> !one.order.more()).count() > 1) {
            read();
        }
    }

    /** Asks between rounds, and waits for the answer; all answers have been read. */
    void ask(Order question) throws IOException {
        look(question);
        afterRound = newest;
    }

    /** Asks how things stand, before anything else is done. */
    void askFirst(Order question) throws IOException {
        look(question);
        afterRound = afterRound == null ? newest : afterRound;
    }

    /**
     * Makes the newest answer the one to the last order: waits for it, or asks where the last order was not answered.
     */
    void know() throws IOException {
        catchUp();
        if (!isLastAnswered) {
            look(Order.asking(Order.Kind.ASK, 0));
        }
    }

    private void look(Order question) throws IOException {
        newest = world.answer(question);
        isLastAnswered = true;
        known = world.now();
    }

    /**
     * Writes what the next round is chosen by, for whoever goes on later.
     *
     * @param chosen who shoots in a round that was chosen, but is not part of the answer
     */
    void write(DataOutputStream out, List<Shot> chosen) throws IOException {
        afterRound.without(chosen, world.mesh.faces, world.mesh.fluxScale()).write(out);
    }

    void read(DataInputStream in) throws IOException {
        afterRound = new Answer(world.mesh.faces, world.mesh.fluxScale());
        afterRound.read(in);
    }
}
