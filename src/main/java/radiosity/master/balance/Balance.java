package radiosity.master.balance;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import radiosity.master.host.Host;
import radiosity.protocol.BlockWork;
import radiosity.protocol.Order;
import radiosity.protocol.Reply;

/** What rounds tell about blocks and hosts, and whether moving blocks pays. */
public final class Balance {

    /** What a host did in a round counts for when the next one is over. */
    private static final double KEPT = 0.95;
    /** Less time says nothing about a host's speed: who shoots in a few rounds may not be seen from its blocks. */
    private static final double LEAST_SECONDS = 0.2;
    /** A host is as fast as was thought within this factor: blocks differ too, and theirs is measured on its own. */
    private static final double FACTOR = 2;
    /** Blocks move when hosts have waited for each other so many times as long as a move takes, or will. */
    private static final double PATIENCE = 1;
    private static final double FIRST_COST = 0.005;
    /** What a second that will be waited by the forecast counts for, which is often wrong. */
    private static final double TRUST = 0.25;
    /** What a move is taken to cost before the first one: per patch of the scene, s. */
    private static final double FIRST_COST_PER_PATCH = 4e-6;

    private final BlockCostModel forecast;
    private final Dealing dealing;
    private final AmortizedTrigger waiting;
    private final int clusters;
    /** The last round that was looked ahead at. */
    private int looked;

    /** @param clusters that may shoot in a round */
    public Balance(BlockCostModel forecast, Dealing dealing, long patches, int clusters) {
        this.clusters = clusters;
        waiting = new AmortizedTrigger(PATIENCE, FIRST_COST, Math.max(FIRST_COST, patches * FIRST_COST_PER_PATCH));
        this.forecast = forecast;
        this.dealing = dealing;
    }

    /** @param shots of a round, or of a part of one, that hosts have done */
    public void add(Map<Host, Reply> replies, int shots) {
        replies.forEach((host, reply) -> note(host, reply, shots));
        judge(replies.keySet());
    }

    /** All hosts have waited for the slowest. */
    public void settle(Collection<Host> hosts) {
        waiting.add(behind(hosts));
        hosts.forEach(host -> host.load.sinceWait = 0);
    }

    /** How much longer the slowest has taken since the last wait than all on average, s. */
    private static double behind(Collection<Host> hosts) {
        double slowest = hosts.stream().mapToDouble(host -> host.load.sinceWait).max().orElse(0);
        return slowest - hosts.stream().mapToDouble(host -> host.load.sinceWait).average().orElse(0);
    }

    private void note(Host host, Reply reply, int shooters) {
        List<Integer> blocks = dealing.blocks(host);
        double cpu = reply.work().stream().mapToDouble(BlockWork::seconds).sum();
        double pairs = 0;
        for (int i = 0; i < Math.min(blocks.size(), reply.work().size()); i++) {
            BlockWork work = reply.work().get(i);
            double pairsOfBlock = (double) work.told() * shooters;
            pairs += pairsOfBlock;
            forecast.hold(blocks.get(i), work);
            if (cpu > 0) {
                forecast.learn(blocks.get(i), work.seconds() / cpu * reply.seconds() * host.speed, pairsOfBlock,
                        shooters);
            }
        }
        if (pairs > 0) {
            host.pairs = KEPT * host.pairs + pairs;
            host.seconds = KEPT * host.seconds + reply.seconds();
        }
    }

    /** Speeds are relative: those of all together stay what they are. */
    private void judge(Collection<Host> hosts) {
        if (hosts.stream().anyMatch(host -> host.seconds < LEAST_SECONDS)) {
            return;
        }
        double unit = hosts.stream().mapToDouble(Host::pace).sum() / hosts.stream().mapToDouble(host -> host.speed)
                .sum();
        for (Host host : hosts) {
            double factor = host.pace() / unit / host.speed;
            if (factor > FACTOR || factor < 1 / FACTOR) {
                host.speed *= factor;
                forecast.rescale(dealing.blocks(host), factor);
            }
        }
    }

    /** What to expect of a newcomer: as much as of the others. */
    public double speed(List<Host> others, Host newcomer) {
        return others.stream().mapToDouble(host -> host.speed).average().orElse(newcomer.speed);
    }

    /** Whether moving blocks may pay before this order: for what was waited so far, or for what lies ahead. */
    public boolean isDue(Order order, List<Host> hosts) {
        if (order.number() != looked && order.gathers() && forecast.isMeasured()) {
            looked = order.number();
            int shooters = order.more() ? Math.max(order.shots().size(), clusters) : order.shots().size();
            double ahead = shooters * dealing.waiting(hosts, order.kind() == Order.Kind.GATHER);
            return waiting.isDue(behind(hosts) + TRUST * ahead);
        }
        return waiting.isDue(behind(hosts));
    }

    public void moved(double seconds) {
        waiting.done(seconds);
    }

    /** It was due, and there was nothing to be moved. */
    public void notMoved() {
        waiting.inVain();
    }
}
