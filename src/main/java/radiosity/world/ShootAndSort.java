package radiosity.world;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * Shooting and sorting (section 2.2 of the paper): whoever has most unshot flux shoots.
 *
 * <p>A round may hold several shots: as many as a sixteenth of those already done, so that the first are single and
 * later ones do not wait for each other.
 */
final class ShootAndSort implements Planner {

    private static final int MOST_IN_ROUND = 256;
    private static final int SHOTS_PER_SHOT = 16;

    private final double[] weight;
    private int shots;

    ShootAndSort(int channels) {
        weight = new double[channels];
        Arrays.fill(weight, 1);
    }

    @Override
    public Order next(Answer last, double unsent, BooleanSupplier goOn) {
        int size = Math.min(last.candidates.size(), batch(shots));
        return size == 0 ? null : Order.of(Order.Kind.SHOOT, last.candidates.subList(0, size),
                Double.POSITIVE_INFINITY, weight, 0, batch(shots + size));
    }

    @Override
    public void shot(int patches) {
        shots += patches;
    }

    /** How many may shoot in the next round; follows from the number of shots done, so that everybody agrees. */
    private static int batch(int shots) {
        return Math.max(1, Math.min(MOST_IN_ROUND, shots / SHOTS_PER_SHOT));
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
