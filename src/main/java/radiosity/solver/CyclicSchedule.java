package radiosity.solver;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.Comparator;
import java.util.List;
import java.util.function.BooleanSupplier;
import radiosity.mesh.PatchTree;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;

/**
 * Gathering and shooting without sorting (section 2.2 of the paper): every patch has its turn, in the order of the
 * scene.
 *
 * <p>Shooting is one patch after another, each with what it has by then. Where every patch gathers what all others
 * have, all have shot at once what they had: a sweep of gathering is one round here. For small scenes: the shots of
 * all patches that have light are looked at in every round.
 */
final class CyclicSchedule implements Planner {

    private static final Comparator<Shot> BY_PLACE = Comparator.<Shot>comparingInt(shot -> top(shot).face())
            .thenComparingLong(shot -> top(shot).path());

    private final Order.Rules rules;
    private final boolean gathers;
    /** Who shot last. */
    private int face = -1;
    private long path;

    /** @param gathers whether all shoot at once */
    CyclicSchedule(int channels, boolean gathers) {
        this.gathers = gathers;
        rules = Order.Rules.exact(channels);
    }

    private static PatchTree top(Shot shot) {
        return shot.trees().get(0);
    }

    @Override
    public Order next(Answer last, double unsent, BooleanSupplier goOn) {
        List<Shot> turns = last.candidates.stream().sorted(BY_PLACE).toList();
        if (turns.isEmpty()) {
            return null;
        }
        return new Order(Order.Kind.SHOOT, gathers ? turns : List.of(turn(turns)), rules,
                Order.Question.candidates(Integer.MAX_VALUE));
    }

    /** The first after the last one; round again at the end. */
    private Shot turn(List<Shot> inOrder) {
        Shot next = inOrder.stream().filter(shot -> top(shot).face() > face
                || top(shot).face() == face && top(shot).path() > path).findFirst().orElse(inOrder.get(0));
        face = top(next).face();
        path = top(next).path();
        return next;
    }

    @Override
    public void write(DataOutput out) throws IOException {
        out.writeInt(face);
        out.writeLong(path);
    }

    @Override
    public void read(DataInput in) throws IOException {
        face = in.readInt();
        path = in.readLong();
    }
}
