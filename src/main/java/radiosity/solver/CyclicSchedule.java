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
 * Gathering and shooting without sorting (section 2.2 of the paper): patches shoot in the order of the scene.
 *
 * <p>Shooting: one patch per round, with the unshot radiosity that the patch has at its turn. Gathering: all patches
 * shoot in one round, as all patches gathering from all others is the same exchange. For small scenes: in every round
 * partitions answer with all patches that have unshot flux.
 */
final class CyclicSchedule implements Planner {

    private static final Comparator<Shot> BY_PLACE = Comparator.<Shot>comparingInt(shot -> top(shot).face())
            .thenComparingLong(shot -> top(shot).path());

    private final Order.Rules rules;
    private final boolean gathers;
    /** Face and path of the patch that shot last. */
    private int face = -1;
    private long path;

    /** @param gathers whether all patches shoot in one round */
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

    /** The shot of the patch after the last shooter; of the first patch where there is none. */
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
