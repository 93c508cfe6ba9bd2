package radiosity.master;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import radiosity.master.host.Host;
import radiosity.mesh.Block;
import radiosity.mesh.Patcher;
import radiosity.mesh.face.NodePath;
import radiosity.protocol.BlockWork;
import radiosity.protocol.Reply;
import radiosity.setup.InitialMesh;

/**
 * The assignment of blocks to hosts (section 4.3 of the paper). Belongs to the thread of the {@link RemoteWorld}.
 *
 * <p>Runs of neighbouring blocks, so that hosts share few vertices, are dealt by longest processing time first
 * (R. L. Graham, Bounds on multiprocessing timing anomalies, 1969). When hosts have waited for each other as long as
 * moving blocks takes, the slowest host gives its best-fitting block to the fastest host, repeatedly while that helps.
 */
final class BlockAssignment {

    /**
     * Number of runs of neighbouring blocks per host. With several runs each host has elements that face in every
     * direction: the shooters of one moment lie on few surfaces and reach only elements that face these.
     */
    private static final int RUNS = 8;
    /** Blocks move if the slowest host takes longer than the average host by more than this part. */
    private static final double WORTH = 0.03;
    /** Number of shooters after which a measured time has a weight of 1/e: a few shooters may all lie in one corner. */
    private static final double MEMORY = 1000;
    /** A block moves only if the slower of both hosts then takes less, by this part, than the slowest takes now. */
    private static final double RELIEF = 2e-3;
    /** Factor by which the weight of a host's measured work falls with each step. */
    private static final double KEPT = 0.95;
    /** Measured time of a host below which its speed is not judged, s: few shooters may be invisible to its blocks. */
    private static final double LEAST_SECONDS = 0.2;
    /** A host keeps its assumed speed within this factor: smaller differences are attributed to its blocks. */
    private static final double FACTOR = 2;
    /** Least assumed cost of moving blocks, and the assumed cost of the first time per patch of a host, s. */
    private static final double LEAST_COST = 0.005;
    private static final double FIRST_COST_PER_PATCH = 4e-6;

    /** 1 per block: its owner; null before blocks are dealt and where the owner is lost. */
    private final Host[] owner;
    /** 1 per block: number of receiving points; before it is known, number of patches. */
    private final double[] points;
    /** 1 per block, weighted sums of the last rounds: time on a host of speed 1, s; pairs of point and shooter. */
    private final double[] time;
    private final double[] pairs;
    /** Time that the average host has waited for the slowest one since blocks moved last, s. */
    private double waited;
    /**
     * Assumed cost of moving blocks, s: the time it took last, doubled whenever there was no block to move. An estimate
     * before the first move, in which hosts make their meshes anew; 0 before blocks are dealt.
     */
    private double cost;

    /** The move of a block from one host to another. */
    record Move(int block, Host from, Host to) { }

    BlockAssignment(InitialMesh mesh) {
        owner = new Host[mesh.blocks.size()];
        points = mesh.blocks.stream().mapToDouble(block -> patches(mesh.patcher, block)).toArray();
        time = new double[owner.length];
        pairs = new double[owner.length];
    }

    private static double patches(Patcher patcher, Block block) {
        double patches = 0;
        for (int i = 0; i < block.face().length; i++) {
            patches += 1L << 2 * (patcher.level(block.face()[i]) - NodePath.level(block.path()[i]));
        }
        return patches;
    }

    /*---- Who owns what ----*/

    /** The ids of a host's blocks, ascending; the ids of the blocks without an owner where {@code of} is null. */
    List<Integer> blocks(Host of) {
        List<Integer> blocks = new ArrayList<>();
        for (int b = 0; b < owner.length; b++) {
            if (owner[b] == of) {
                blocks.add(b);
            }
        }
        return blocks;
    }

    void give(int block, Host to) {
        owner[block] = to;
    }

    /** Leaves the blocks of a lost host without an owner. */
    void lose(Host host) {
        blocks(host).forEach(b -> owner[b] = null);
    }

    /**
     * Gives every block without an owner to one of the hosts.
     *
     * @return the ids of the blocks that were given
     */
    List<Integer> deal(List<Host> hosts) {
        if (cost == 0) {
            cost = Math.max(LEAST_COST, FIRST_COST_PER_PATCH * DoubleStream.of(points).sum() / hosts.size());
        }
        List<Integer> ownerless = blocks(null);
        double[] seconds = seconds();
        double[] load = load(hosts, seconds);
        int length = Math.max(1, ownerless.size() / (RUNS * hosts.size()));
        List<List<Integer>> runs = new ArrayList<>();
        for (int i = 0; i < ownerless.size(); i += length) {
            runs.add(ownerless.subList(i, Math.min(ownerless.size(), i + length)));
        }
        runs.sort(Comparator.comparingDouble(run -> -sum(run, seconds)));
        for (List<Integer> run : runs) {
            double all = sum(run, seconds);
            int first = 0;
            for (int h = 1; h < load.length; h++) {
                first = load[h] + all / hosts.get(h).speed < load[first] + all / hosts.get(first).speed ? h : first;
            }
            load[first] += all / hosts.get(first).speed;
            for (int b : run) {
                owner[b] = hosts.get(first);
            }
        }
        return ownerless;
    }

    private static double sum(List<Integer> blocks, double[] seconds) {
        return blocks.stream().mapToDouble(b -> seconds[b]).sum();
    }

    /** 1 per block: time per shooter on a host of speed 1, s; in arbitrary units before anything was measured. */
    private double[] seconds() {
        double all = DoubleStream.of(time).sum();
        double mean = all > 0 ? all / DoubleStream.of(pairs).sum() : 1;
        double[] seconds = new double[owner.length];
        Arrays.setAll(seconds, b -> (pairs[b] > 0 ? time[b] / pairs[b] : mean) * points[b]);
        return seconds;
    }

    /** 1 per host: time that its blocks take per shooter, s. */
    private double[] load(List<Host> hosts, double[] seconds) {
        return hosts.stream().mapToDouble(host -> sum(blocks(host), seconds) / host.speed).toArray();
    }

    /*---- What hosts do ----*/

    /** Learns from the replies of all hosts to a step in which this number of shots was gathered. */
    void add(Map<Host, Reply> replies, int shots) {
        replies.forEach((host, reply) -> add(host, reply, shots));
        judge(replies.keySet());
    }

    private void add(Host host, Reply reply, int shots) {
        List<Integer> blocks = blocks(host);
        double cpu = reply.work().stream().mapToDouble(BlockWork::seconds).sum();
        double kept = StrictMath.exp(-shots / MEMORY);
        double done = 0;
        for (int i = 0; i < Math.min(blocks.size(), reply.work().size()); i++) {
            int b = blocks.get(i);
            BlockWork work = reply.work().get(i);
            double pairsOfBlock = (double) work.gathered() * shots;
            points[b] = work.points();
            if (cpu > 0 && pairsOfBlock > 0) {
                time[b] = kept * time[b] + work.seconds() / cpu * reply.seconds() * host.speed;
                pairs[b] = kept * pairs[b] + pairsOfBlock;
            }
            done += pairsOfBlock;
        }
        if (done > 0) {
            host.pairs = KEPT * host.pairs + done;
            host.seconds = KEPT * host.seconds + reply.seconds();
        }
    }

    /** Corrects the assumed speeds of hosts by the measured ones, which are scaled to the same sum. */
    private void judge(Collection<Host> hosts) {
        if (hosts.stream().anyMatch(host -> host.seconds < LEAST_SECONDS)) {
            return;
        }
        double unit = hosts.stream().mapToDouble(Host::pairsPerSecond).sum()
                / hosts.stream().mapToDouble(host -> host.speed).sum();
        for (Host host : hosts) {
            double factor = host.pairsPerSecond() / unit / host.speed;
            if (factor > FACTOR || factor < 1 / FACTOR) {
                host.speed *= factor;
                blocks(host).forEach(b -> time[b] *= factor);
            }
        }
    }

    /** The speed assumed of a newcomer: the mean of the other hosts' speeds, or its own where it is the only host. */
    double speed(List<Host> others, Host newcomer) {
        return others.stream().mapToDouble(host -> host.speed).average().orElse(newcomer.speed);
    }

    /*---- Moving blocks ----*/

    /** Notes that all hosts have waited until the slowest was done. */
    void settle(Collection<Host> hosts) {
        waited += behind(hosts);
        hosts.forEach(host -> host.load.sinceWait = 0);
    }

    /** Time by which the slowest host has taken longer than the average since all hosts last waited, s. */
    private static double behind(Collection<Host> hosts) {
        double slowest = hosts.stream().mapToDouble(host -> host.load.sinceWait).max().orElse(0);
        return slowest - hosts.stream().mapToDouble(host -> host.load.sinceWait).average().orElse(0);
    }

    /** Whether hosts have waited for the slowest one as long as moving blocks takes. */
    boolean isDue(Collection<Host> hosts) {
        return waited + behind(hosts) >= cost;
    }

    /**
     * Notes that blocks have moved, or that there was no block to move.
     *
     * @param seconds time that moving took; 0 where there was no block to move
     */
    void moved(double seconds) {
        cost = seconds > 0 ? Math.max(LEAST_COST, seconds) : 2 * cost;
        waited = 0;
    }

    /** The moves that relieve the slowest hosts; empty where these would gain too little. */
    List<Move> moves(List<Host> hosts) {
        double[] seconds = seconds();
        double[] load = load(hosts, seconds);
        if (DoubleStream.of(load).max().orElse(0) <= (1 + WORTH) * DoubleStream.of(load).average().orElse(0)) {
            return List.of();
        }
        Host[] after = owner.clone();
        for (Move move = relief(hosts, seconds, load, after); move != null;
                move = relief(hosts, seconds, load, after)) {
            after[move.block] = move.to;
            load[hosts.indexOf(move.from)] -= seconds[move.block] / move.from.speed;
            load[hosts.indexOf(move.to)] += seconds[move.block] / move.to.speed;
        }
        return IntStream.range(0, owner.length).filter(b -> owner[b] != after[b])
                .mapToObj(b -> new Move(b, owner[b], after[b])).toList();
    }

    /** The best move of a block from the slowest host to the fastest; null where no move helps enough. */
    private static Move relief(List<Host> hosts, double[] seconds, double[] load, Host[] owner) {
        int slow = 0;
        int fast = 0;
        for (int h = 1; h < load.length; h++) {
            slow = load[h] > load[slow] ? h : slow;
            fast = load[h] < load[fast] ? h : fast;
        }
        Move best = null;
        double least = (1 - RELIEF) * load[slow];
        for (int b = 0; b < owner.length; b++) {
            if (owner[b] == hosts.get(slow)) {
                double slower = Math.max(load[slow] - seconds[b] / hosts.get(slow).speed,
                        load[fast] + seconds[b] / hosts.get(fast).speed);
                if (slower < least) {
                    least = slower;
                    best = new Move(b, hosts.get(slow), hosts.get(fast));
                }
            }
        }
        return best;
    }
}
