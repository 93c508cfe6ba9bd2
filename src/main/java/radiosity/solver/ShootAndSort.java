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
 * Shooting and sorting (section 2.2 of the paper): whoever has most unshot flux shoots.
 *
 * <p>A round may hold several shots: a part of those already done and a part of all patches, so that the first are
 * single, or some that have about as much to shoot: patches of a lamp, of which none will have more by what another one
 * shoots. Rounds overlap: who shoots in one is chosen by what was known before the last, so nobody waits for anybody.
 */
final class ShootAndSort implements Planner {

    private static final int MOST_IN_ROUND = 64;
    private static final int SHOTS_PER_SHOT = 16;
    private static final int PATCHES_PER_SHOT = 32;
    /** The number of shooters that may shoot in any round, of which each has this part of the flux of the first. */
    private static final int MOST_ALIKE = 16;
    private static final double ALIKE = 0.5;
    /** Those are named that have this part of the flux of the last one that was chosen. */
    private static final double NAMED = 0.5;

    private final Order.Rules rules;
    private final int most;
    private final int mostAlike;
    /** How many were chosen so far. */
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

    /** Twice as many as two rounds may hold. */
    @Override
    public int wanted() {
        int next = Math.max(mostAlike, batch(shots));
        return 2 * (next + Math.max(mostAlike, batch(shots + next)));
    }

    /**
     * How many may shoot in the next round; follows from the scene and the number of shots done, so everybody agrees.
     */
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
