package radiosity.master.balance;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * Blocks shared out to hosts, so that the slowest host is done as early as may be: one goes to another host, or two
 * change places, as long as that helps (after B. Kernighan, S. Lin, An efficient heuristic procedure for partitioning
 * graphs, 1970).
 *
 * <p>Each host is to have its share of what looks in each direction, too: who shoots in one round stands on few
 * surfaces, and reaches only what looks there.
 */
final class BlockAssignment {

    /** A step has to lower the goal by this part; all blocks are looked at so often at most. */
    private static final double WORTH = 1e-5;
    private static final int MOST_SWEEPS = 40;
    /** A move has to help the slowest host by this part of its time. */
    private static final double RELIEF = 2e-3;
    /** What it counts for that a host has its share of each direction. */
    private static final double SPREAD = 0.5;

    private final BlockCostModel.Work work;
    private final Borders borders;
    /** 1 per host. */
    private final double[] speed;
    /** Per host and direction: until it is done, s. */
    private final double[][] time;
    /** 1 per block: host, or -1. */
    private final int[] owner;
    /** What a host would need if all had alike and shared all borders: of all, and per direction. s */
    private final double mean;
    private final double[] meanFacing = new double[Borders.DIRECTIONS];

    /** @param owner 1 per block: number of a host, or -1; not modified */
    BlockAssignment(BlockCostModel.Work work, Borders borders, double[] speed, int[] owner) {
        this.borders = borders;
        this.work = work;
        this.speed = speed;
        time = new double[speed.length][Borders.DIRECTIONS];
        this.owner = new int[owner.length];
        Arrays.fill(this.owner, -1);
        double all = DoubleStream.of(speed).sum();
        for (int b = 0; b < owner.length; b++) {
            for (int d = 0; d < meanFacing.length; d++) {
                meanFacing[d] += borders.facing(b)[d] * work.seconds()[b] / all;
            }
            if (owner[b] >= 0) {
                give(b, owner[b]);
            }
        }
        mean = DoubleStream.of(meanFacing).sum();
    }

    int[] owners() {
        return owner.clone();
    }

    private double time(int host) {
        return DoubleStream.of(time[host]).sum();
    }

    /** What a host has to do, counted in receiving points that take as long as all on average. */
    double points(int host) {
        double points = IntStream.range(0, owner.length).mapToDouble(borders::points).sum();
        return points * time(host) / (mean * DoubleStream.of(speed).sum());
    }

    double slowest() {
        return time(slowestHost());
    }

    private int slowestHost() {
        int slowest = 0;
        for (int h = 1; h < speed.length; h++) {
            slowest = time(h) > time(slowest) ? h : slowest;
        }
        return slowest;
    }

    /** What the slowest host takes longer than all do on average, s. */
    double waiting() {
        double sum = 0;
        for (int h = 0; h < speed.length; h++) {
            sum += time(h);
        }
        return slowest() - sum / speed.length;
    }

    /** A block's time on a host that has not got it, beside what the host has, s. */
    private double added(int block, int host) {
        double seconds = work.seconds()[block];
        int[] beside = borders.beside(block);
        for (int i = 0; i < beside.length; i++) {
            seconds -= owner[beside[i]] == host ? work.saved()[block][i] : 0;
        }
        return Math.max(0, seconds) / speed[host];
    }

    private void take(int block) {
        int from = owner[block];
        owner[block] = -1;
        add(block, from, -added(block, from));
    }

    private void give(int block, int to) {
        add(block, to, added(block, to));
        owner[block] = to;
    }

    private void add(int block, int host, double seconds) {
        for (int d = 0; d < meanFacing.length; d++) {
            time[host][d] += borders.facing(block)[d] * seconds;
        }
    }

    /** Every block without an owner goes to whom it delays least, in their geometric order. */
    void deal() {
        for (int b = 0; b < owner.length; b++) {
            if (owner[b] < 0) {
                give(b, best(b));
            }
        }
    }

    void improve() {
        for (int sweep = 0; sweep < MOST_SWEEPS; sweep++) {
            boolean moved = false;
            for (int b = 0; b < owner.length; b++) {
                moved |= move(b);
            }
            if (!moved && !exchange()) {
                return;
            }
        }
    }

    /** The same with few moves: the slowest host gives a block away, or changes one, as long as that helps it. */
    void relieve() {
        double before = Double.POSITIVE_INFINITY;
        for (int turn = 0; turn < owner.length && slowest() < (1 - RELIEF) * before; turn++) {
            before = slowest();
            relieve(slowestHost());
        }
    }

    private void relieve(int host) {
        double least = 0;
        int[] trade = null;
        for (int[] one : trades(host)) {
            double change = change(one[0], one[1], one[2]);
            if (change < least) {
                least = change;
                trade = one;
            }
        }
        if (trade != null) {
            trade(trade[0], trade[1], host, trade[2]);
        }
    }

    /** What a host may give away: a block, one that it takes for it or -1, and to whom. */
    private List<int[]> trades(int host) {
        List<int[]> trades = new ArrayList<>();
        for (int other = 0; other < speed.length; other++) {
            for (int b = 0; b < owner.length && other != host; b++) {
                if (owner[b] == host) {
                    trades.add(new int[] {b, -1, other});
                }
            }
            int[] pair = other == host ? null : levelling(host, other);
            if (pair != null) {
                trades.add(pair);
            }
        }
        return trades;
    }

    /**
     * Of a block of each of two hosts those that would level their times best, borders aside; null where there are
     * none.
     */
    private int[] levelling(int host, int other) {
        double wanted = (time(host) - time(other)) / (1 / speed[host] + 1 / speed[other]);
        int[] best = null;
        double least = wanted;
        for (int b = 0; b < owner.length; b++) {
            for (int c = 0; owner[b] == host && c < owner.length; c++) {
                double off = Math.abs(work.seconds()[b] - work.seconds()[c] - wanted);
                if (owner[c] == other && off < least) {
                    least = off;
                    best = new int[] {b, c, other};
                }
            }
        }
        return best;
    }

    /** @param c block that is taken for b, or below 0 for none */
    private double change(int b, int c, int other) {
        int host = owner[b];
        double before = goal(host) + goal(other);
        trade(b, c, host, other);
        double after = goal(host) + goal(other);
        trade(b, c, other, host);
        return after - before;
    }

    private void trade(int b, int c, int hostOfB, int hostOfC) {
        if (c >= 0) {
            swap(b, hostOfC, c, hostOfB);
        } else {
            take(b);
            give(b, hostOfC);
        }
    }

    /** What is made small. */
    private double goal(int host) {
        double load = time(host) / mean;
        double goal = load * load * (load * load);
        for (int d = 0; d < meanFacing.length; d++) {
            goal += meanFacing[d] > 0 ? SPREAD * time[host][d] * time[host][d] / (meanFacing[d] * mean) : 0;
        }
        return speed[host] * goal;
    }

    private int best(int block) {
        int best = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int h = 0; h < speed.length; h++) {
            double before = goal(h);
            give(block, h);
            double change = goal(h) - before;
            take(block);
            if (change < (1 - WORTH) * least) {
                best = h;
                least = change;
            }
        }
        return best;
    }

    private boolean move(int block) {
        int from = owner[block];
        take(block);
        int to = best(block);
        give(block, to);
        return to != from;
    }

    /** A block of the slowest host changes places with one of another. */
    private boolean exchange() {
        int slowest = slowestHost();
        for (int b = 0; b < owner.length; b++) {
            for (int c = 0; owner[b] == slowest && c < owner.length; c++) {
                if (owner[c] != slowest && exchange(b, c)) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean exchange(int b, int c) {
        int from = owner[b];
        int to = owner[c];
        double before = goal(from) + goal(to);
        swap(b, to, c, from);
        if (goal(from) + goal(to) < (1 - WORTH) * before) {
            return true;
        }
        swap(b, from, c, to);
        return false;
    }

    private void swap(int b, int hostOfB, int c, int hostOfC) {
        take(b);
        take(c);
        give(b, hostOfB);
        give(c, hostOfC);
    }
}
