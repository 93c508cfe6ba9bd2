package radiosity.solver;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.List;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.protocol.Wire;

/** The round that was chosen, or what is left of it; where rounds overlap, also who shoots in the one before. */
final class RoundQueue {

    private static final Choice NONE = new Choice(null, 0);

    private Choice present = NONE;
    /** Who shoots in the round that was begun last, as long as another one may be chosen. */
    private List<Shot> begun = List.of();

    /** @param unsent what was left to shoot when it was chosen, relative to what was emitted */
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

    /** Whether it is not known what comes next. */
    boolean isEmpty() {
        return present.round == null;
    }

    /** Whether all of the last round was begun, and nothing of the next one. */
    boolean isBetweenRounds() {
        return isEmpty() || !present.round.begun();
    }

    /** Whether there is a round that changes elements, or the rest of one. */
    boolean changes() {
        return !isEmpty() && present.round.changes();
    }

    /** What is left of the present round. */
    Order round() {
        return present.round;
    }

    /** What was left to shoot when the present round was chosen, relative to what was emitted. */
    double unsent() {
        return present.unsent;
    }

    /** Who shoots in the last round that was chosen. */
    List<Shot> shooters() {
        return isBetweenRounds() && !isEmpty() ? present.round.shots() : begun;
    }

    /** Takes a round; there is none left. */
    void add(Order round, double unsent) {
        present = new Choice(round, unsent);
    }

    /**
     * @param round   the present one, as it is carried out
     * @param another whether another one will be chosen before all of it is done
     */
    void begin(Order round, boolean another) {
        present = new Choice(round, present.unsent);
        begun = another ? round.shots() : List.of();
    }

    /** @param shots number of shots of those left that are under way now */
    void done(int shots) {
        present = shots < present.round.shots().size()
                ? new Choice(present.round.after(shots), present.unsent) : NONE;
    }

    /** Rows are left out: whoever goes on later has none, and asks for all of them. */
    void write(DataOutputStream out) throws IOException {
        (isEmpty() || present.round.kind() != Order.Kind.ROWS ? present : NONE).write(out);
    }

    void read(DataInputStream in) throws IOException {
        present = Choice.read(in);
    }
}
