package radiosity.solver;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.List;
import java.util.function.BooleanSupplier;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;

/**
 * Shooting and sorting (section 2.2 of the paper): the patch with most unshot flux shoots.
 *
 * <p>A round may hold several shots: a part of the number of shots done and of the number of patches, so that the first
 * rounds are single shots; or patches with about the same unshot flux, like those of a lamp. Rounds overlap: the shots
 * of a round are chosen by the answer to the round before the last, so that no host waits for another.
 */
final class ShootAndSort implements Planner {

    private static final int MOST_IN_ROUND = 64;
    private static final int SHOTS_PER_SHOT = 16;
    private static final int PATCHES_PER_SHOT = 32;
    /** Number of shots that any round may hold where their unshot flux is similar. */
    private static final int MOST_ALIKE = 16;
    /** Unshot flux over that of the round's first shot from which on a shot is similar. */
    private static final double ALIKE = 0.5;
    /** Unshot flux over that of the round's last shot from which on partitions name a candidate. */
    private static final double NAMED = 0.5;

    private final Order.Rules rules;
    private final int most;
    private final int mostAlike;
    /** Number of shots chosen so far. */
    private int shots;

    ShootAndSort(long patches, int channels) {
        most = (int) Math.min(MOST_IN_ROUND, patches / PATCHES_PER_SHOT);
        mostAlike = Math.max(1, Math.min(MOST_ALIKE, most));
        rules = Order.Rules.exact(channels);
    }

    @Override
    public Order next(Answer last, double unsent, BooleanSupplier goOn) {
        if (last.candidates.isEmpty()) {
            return null;
        }
        int size = Math.min(last.candidates.size(), Math.max(batch(shots), alike(last.candidates)));
        List<Shot> best = last.candidates.subList(0, size);
        shots += size;
        return new Order(Order.Kind.SHOOT, best, rules,
                new Order.Question.Candidates(wanted(), NAMED * best.get(size - 1).flux()));
    }

    @Override
    public boolean looksAhead() {
        return true;
    }

    private int alike(List<Shot> candidates) {
        double least = ALIKE * candidates.get(0).flux();
        return (int) candidates.stream().limit(mostAlike).takeWhile(shot -> shot.flux() >= least).count();
    }

    /** Twice the number of shots that two rounds may hold. */
    @Override
    public int wanted() {
        int next = Math.max(mostAlike, batch(shots));
        return 2 * (next + Math.max(mostAlike, batch(shots + next)));
    }

    /** Largest number of shots of the next round; depends on the scene and the number of shots chosen alone. */
    private int batch(int shots) {
        return Math.max(1, Math.min(most, shots / SHOTS_PER_SHOT));
    }

    @Override
    public void write(DataOutput out) throws IOException {
        out.writeInt(shots);
    }

    @Override
    public void read(DataInput in) throws IOException {
        shots = in.readInt();
    }
}
