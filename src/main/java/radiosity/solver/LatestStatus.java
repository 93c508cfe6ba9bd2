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
 * The latest answers of all partitions, added up, and their age.
 *
 * <p>Two answers are kept. The newest answer is for progress and saving, at any time. The answer after the last whole
 * round decides the next round: which answer that is depends on the rounds alone, never on the time of a question.
 */
final class LatestStatus {

    /** Age of the newest answer from which on a step within a round asks for another, s; an answer costs time. */
    private static final double ANSWER_SECONDS = 4;

    private final World world;
    private final StepSizer sizer;
    /** Pending answers, in the order of their orders. */
    private final Deque<Unread> unread = new ArrayDeque<>();
    private Answer newest;
    private Answer afterRound;
    /** Whether partitions answer the last order. */
    private boolean isLastAnswered;
    /** Time at which the newest answer came, by the world's clock, ns. */
    private long known;

    private record Unread(Order order, World.Begun begun) { }

    LatestStatus(World world, StepSizer sizer) {
        this.world = world;
        this.sizer = sizer;
        known = world.now();
    }

    /** The newest answer; null before the first question. */
    Answer newest() {
        return newest;
    }

    /** The answer to the last whole round whose answer was read, or to a later question; null before the first. */
    Answer afterRound() {
        return afterRound;
    }

    /** Whether the newest answer is too old for a progress display. */
    boolean isOld() {
        return world.now() - known > ANSWER_SECONDS * 1e9;
    }

    /** Notes an order, or a step of a round, that was begun; its answer is read later. */
    void begun(Order order, World.Begun begun) {
        isLastAnswered = order.isAnswered();
        if (isLastAnswered) {
            unread.add(new Unread(order, begun));
        }
    }

    /** Waits for the first pending answer and reads that answer. */
    private void read() throws IOException {
        Unread first = unread.remove();
        newest = first.begun.answer(sizer::took);
        known = world.now();
        if (!first.order.more()) {
            afterRound = newest;
        }
    }

    /** Waits for all pending answers and reads them. */
    void catchUp() throws IOException {
        while (!unread.isEmpty()) {
            read();
        }
    }

    /** Reads pending answers up to, and without, the answer to the last whole round. */
    void catchUpToRoundBefore() throws IOException {
        while (unread.stream().filter(one -> !one.order.more()).count() > 1) {
            read();
        }
    }

    /** Asks a question between rounds, where no answer is pending, and waits for the answer. */
    void ask(Order question) throws IOException {
        query(question);
        afterRound = newest;
    }

    /** Asks the first question, before any order. */
    void askFirst(Order question) throws IOException {
        query(question);
        afterRound = afterRound == null ? newest : afterRound;
    }

    /** Waits for the answer to the last order; asks a question where partitions do not answer that order. */
    void know() throws IOException {
        catchUp();
        if (!isLastAnswered) {
            query(Order.asking(Order.Kind.ASK, 0));
        }
    }

    private void query(Order question) throws IOException {
        newest = world.answer(question);
        isLastAnswered = true;
        known = world.now();
    }

    /**
     * Writes the answer that decides the next round, for a resumed calculation.
     *
     * @param chosen shots of the round that was chosen already; the written answer has no candidates for them
     */
    void write(DataOutputStream out, List<Shot> chosen) throws IOException {
        afterRound.without(chosen, world.mesh.faces, world.mesh.fluxScale()).write(out);
    }

    void read(DataInputStream in) throws IOException {
        afterRound = new Answer(world.mesh.faces, world.mesh.fluxScale());
        afterRound.read(in);
    }
}
