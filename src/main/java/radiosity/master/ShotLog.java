package radiosity.master;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import radiosity.master.host.Host;
import radiosity.master.host.HostCalls;
import radiosity.prediction.ShotsOnDemand;
import radiosity.protocol.BlockTakeover;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.protocol.Wire;
import radiosity.setup.InitialMesh;
import radiosity.util.ParallelFor;
import radiosity.worker.ShotHistory;

/**
 * What makes a lost block whole again: its state at the last checkpoint, every order since, and the questions that not
 * all hosts have answered; and when the next checkpoint is due. By prediction also what was shot so far, and which
 * hosts know it.
 */
final class ShotLog {

    /**
     * A checkpoint is taken when the rounds since the last one took this many times as long as it: 1 % of the time at
     * most, and what n hosts lose with one of them is an n-th of those rounds.
     */
    private static final double PATIENCE = 100;
    private static final double SECONDS = 0.02;
    /** What the first one is taken to cost, before which all is lost: in any case, and per patch, s. */
    private static final double FIRST_SECONDS = 0.001;
    private static final double SECONDS_PER_PATCH = 5e-7;
    /** Orders that are kept in memory for the next loss. */
    private static final long MOST_BYTES = 128L << 20;

    /** By id; empty before the first checkpoint, when all blocks are as in the initial mesh. */
    private List<byte[]> states = List.of();
    private final List<Entry> entries = new ArrayList<>();
    private long bytes;
    /** What a checkpoint takes, as far as is known, and the orders since the last one took; s. */
    private double cost;
    private double since;

    private final InitialMesh mesh;
    private final HostCalls calls;
    private final ShotHistory totals;

    private record Entry(Order order, Supplier<byte[]> encoded, long bytes) { }

    ShotLog(InitialMesh mesh, HostCalls calls) {
        this.mesh = mesh;
        this.calls = calls;
        totals = new ShotHistory(mesh.faces.channels());
        cost = Math.max(FIRST_SECONDS, mesh.patcher.patches() * SECONDS_PER_PATCH);
    }

    /** @param encoded what the hosts receive, or null where that is not the whole order */
    void add(Order order, byte[] encoded) {
        Entry entry = encoded == null
                ? new Entry(order, order::encode, order.shots().stream().mapToLong(Shot::bytes).sum())
                : new Entry(order, () -> encoded, encoded.length);
        entries.add(entry);
        bytes += entry.bytes;
    }

    /** All hosts have answered an order that changes nothing: it need not be done again. */
    void remove(Order answered) {
        for (int i = entries.size() - 1; i >= 0; i--) {
            if (entries.get(i).order == answered) {
                bytes -= entries.remove(i).bytes;
                return;
            }
        }
    }

    /** What it took the slowest host to do an order that was added, s. */
    void took(double seconds) {
        since += seconds;
    }

    boolean isCheckpointDue() {
        return since >= PATIENCE * cost || bytes > MOST_BYTES;
    }

    /** @param seconds that it took to get these states */
    void checkpoint(List<byte[]> now, double seconds) {
        checkpoint(now);
        cost = Math.max(SECONDS, seconds);
        since = 0;
    }

    /** States that were there already. */
    void checkpoint(List<byte[]> now) {
        states = List.copyOf(now);
        entries.clear();
        bytes = 0;
    }

    BlockTakeover adoption(List<Integer> blocks) {
        Map<Integer, byte[]> wanted = new TreeMap<>();
        for (int block : blocks) {
            wanted.put(block, states.isEmpty() ? BlockTakeover.INITIAL : states.get(block));
        }
        return new BlockTakeover(wanted, entries.stream().map(entry -> entry.encoded.get()).toList(), List.of());
    }

    /*---- What was shot so far ----*/

    /** A host that begins now knows all shots if there were none. */
    void welcome(Host host) {
        host.knows = totals.isEmpty();
    }

    /** Hosts that receive this order count its shots themselves. */
    void count(Order order) {
        if (mesh.predicts() && order.marks()) {
            totals.add(order.shots());
        }
    }

    /** Replaces what was counted. @param now what all have shot */
    void restart(List<Shot> now, List<Host> hosts) {
        totals.set(now);
        hosts.forEach(host -> host.knows = false);
    }

    /** Sends what was shot before to hosts that have come later. */
    void inform(List<Host> hosts) {
        List<Host> late = hosts.stream().filter(host -> !host.knows).toList();
        if (!late.isEmpty()) {
            byte[] all = Wire.bytes(out -> Wire.write(totals.all(), mesh.faces.channels(), out));
            calls.onAll(late, host -> host.know(all)).keySet().forEach(host -> host.knows = true);
        }
    }

    /**
     * What each shooter has shot; to be read before anybody shoots again.
     *
     * @param trees of all that shoots together: how they are divided
     */
    List<Shot> totals(List<Shot> trees, ParallelFor parallel) {
        return new ShotsOnDemand(trees.size(), i -> totals.of(trees.get(i)), parallel);
    }
}
