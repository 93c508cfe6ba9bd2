package radiosity.solver;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.List;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.protocol.Wire;

/** The chosen round, or the rest of it; where rounds overlap, also the shots of the round before. */
final class RoundQueue {

    private static final Choice NONE = new Choice(null, 0);

    private Choice present = NONE;
    /** Shots of the round that was begun last, as long as the next round may be chosen; else empty. */
    private List<Shot> begun = List.of();

    /** @param unsent unshot flux over emitted flux when the round was chosen */
    private record Choice(Order round, double unsent) {

        void write(DataOutputStream out) throws IOException {
            Wire.write(out, round == null ? new byte[0] : round.encode());
            out.writeDouble(unsent);
        }

        static Choice read(DataInputStream in) throws IOException {
            byte[] round = Wire.bytes(in);
            return new Choice(round.length == 0 ? null : Order.decode(round), in.readDouble());
        }
    }

    /** Whether no round, and no rest of a round, is in the queue. */
    boolean isEmpty() {
        return present.round == null;
    }

    /** Whether the last round was begun as a whole, and the next round was not begun. */
    boolean isBetweenRounds() {
        return isEmpty() || !present.round.begun();
    }

    /** Whether the queue holds a round, or the rest of a round, that changes elements. */
    boolean changes() {
        return !isEmpty() && present.round.changes();
    }

    /** The rest of the present round. */
    Order round() {
        return present.round;
    }

    /** Unshot flux over emitted flux when the present round was chosen. */
    double unsent() {
        return present.unsent;
    }

    /** Shots of the round that was chosen last. */
    List<Shot> shooters() {
        return isBetweenRounds() && !isEmpty() ? present.round.shots() : begun;
    }

    /** Adds a round to the empty queue. */
    void add(Order round, double unsent) {
        present = new Choice(round, unsent);
    }

    /**
     * Replaces the present round by the same round with its number.
     *
     * @param another whether the next round will be chosen before this one is carried out as a whole
     */
    void begin(Order round, boolean another) {
        present = new Choice(round, present.unsent);
        begun = another ? round.shots() : List.of();
    }

    /**
     * Removes shots that were begun from the present round.
     *
     * @param shots number of shots, from the first of the rest
     */
    void done(int shots) {
        present = shots < present.round.shots().size()
                ? new Choice(present.round.after(shots), present.unsent) : NONE;
    }

    /** Writes the rest of the present round; nothing of an order for rows, as a resumed calculation orders all rows. */
    void write(DataOutputStream out) throws IOException {
        (isEmpty() || present.round.kind() != Order.Kind.ROWS ? present : NONE).write(out);
    }

    void read(DataInputStream in) throws IOException {
        present = Choice.read(in);
    }
}
