package radiosity.master.balance;

import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import radiosity.protocol.BlockWork;

/** How long each block will take in the next round, on a host of speed 1: from what it took in the last ones. */
public final class BlockCostModel {

    /** So many shooters later, what was measured counts for an e-th; the last ones may all stand in one corner. */
    private static final double MEMORY = 1000;
    /**
     * What a point counts for that two blocks have, where it is gathered at once anyway: patches between hosts are work
     * for the master, so neighbours go to one host where that costs little balance.
     */
    private static final double NEAR = 0.25;

    private final Borders borders;
    private final boolean isShared;
    /** 1 per block: what it holds. */
    private final double[] points;
    private final double[] fresh;
    /** 1 per block, of the last rounds: time, s, and for how many pairs of point and shooter. */
    private final double[] time;
    private final double[] pairs;

    /** @param isShared whether one host gathers at a point of two */
    public BlockCostModel(Borders borders, boolean isShared) {
        this.isShared = isShared;
        this.borders = borders;
        points = new double[borders.blocks()];
        fresh = new double[points.length];
        time = new double[points.length];
        pairs = new double[points.length];
        for (int b = 0; b < points.length; b++) {
            points[b] = borders.points(b);
        }
    }

    /** What a block holds after a round. */
    void hold(int block, BlockWork work) {
        points[block] = work.points();
        fresh[block] = work.fresh();
    }

    /**
     * @param seconds  on a host of speed 1
     * @param shooters who shot in that time
     */
    void learn(int block, double seconds, double pairsDone, int shooters) {
        if (pairsDone > 0) {
            double kept = StrictMath.exp(-shooters / MEMORY);
            time[block] = kept * time[block] + seconds;
            pairs[block] = kept * pairs[block] + pairsDone;
        }
    }

    /** Its host turns out so many times as fast as was thought. */
    void rescale(List<Integer> blocks, double factor) {
        blocks.forEach(b -> time[b] *= factor);
    }

    /**
     * What lies ahead for each shooter.
     *
     * @param seconds 1 per block: time on a host of speed 1; only relative where nothing was measured yet
     * @param saved   per block and neighbour: by how much both take less where they have one owner, s
     */
    record Work(double[] seconds, double[][] saved) { }

    /** @param gather whether only those points gather that the last split made */
    Work next(boolean gather) {
        double all = DoubleStream.of(time).sum();
        double mean = all > 0 ? all / DoubleStream.of(pairs).sum() : 1;
        double[] seconds = new double[time.length];
        for (int b = 0; b < seconds.length; b++) {
            seconds[b] = (pairs[b] > 0 ? time[b] / pairs[b] : mean) * (gather ? fresh[b] : points[b]);
        }
        double[][] saved = new double[seconds.length][];
        for (int b = 0; b < seconds.length; b++) {
            int[] beside = borders.beside(b);
            saved[b] = new double[beside.length];
            for (int i = 0; i < beside.length; i++) {
                saved[b][i] = borders.shared(b)[i] * saved(b, beside[i], seconds);
            }
        }
        return isShared ? new Work(halved(seconds, saved), lessened(saved)) : new Work(seconds, saved);
    }

    /** Where one of two owners gathers, each does half of it. */
    private static double[] halved(double[] seconds, double[][] saved) {
        double[] less = seconds.clone();
        for (int b = 0; b < less.length; b++) {
            less[b] -= (1 - NEAR) / 2 * DoubleStream.of(saved[b]).sum();
        }
        return less;
    }

    private static double[][] lessened(double[][] saved) {
        return Arrays.stream(saved).map(some -> DoubleStream.of(some).map(s -> NEAR * s).toArray())
                .toArray(double[][]::new);
    }

    /** Per point that two blocks have in common in the initial mesh; a mesh that was divided has more on a border. */
    private double saved(int b, int c, double[] seconds) {
        double finer = Math.max(1, Math.min(points[b] / borders.points(b), points[c] / borders.points(c)));
        return Math.sqrt(finer) * Math.min(seconds[b] / points[b], seconds[c] / points[c]);
    }

    /** Whether times were measured, and are not only relative. */
    boolean isMeasured() {
        return DoubleStream.of(pairs).sum() > 0;
    }
}
