package radiosity.master;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
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
 * The log from which a lost block is rebuilt: the states of all blocks at the last checkpoint, every order since that
 * changes elements, and the questions that not all hosts have answered. Decides when the next checkpoint is due. With
 * the predicting schedule the log also keeps all light ever shot, and which hosts have that light.
 */
final class ShotLog {

    /**
     * A checkpoint is taken when the rounds since the last one took this many times as long as a checkpoint takes. So
     * checkpoints take 1 % of the time, and n hosts that lose one of them repeat an n-th of these rounds.
     */
    private static final double PATIENCE = 100;
    /** Least assumed time of a checkpoint after the first, s. */
    private static final double SECONDS = 0.02;
    /** Assumed time of the first checkpoint, s: at least, and per patch. Until then a lost block repeats all work. */
    private static final double FIRST_SECONDS = 0.001;
    private static final double SECONDS_PER_PATCH = 5e-7;
    /** Bytes of logged orders above which a checkpoint is due. */
    private static final long MOST_BYTES = 128L << 20;

    /** State of each block, by id; empty before the first checkpoint: the blocks are then as in the initial mesh. */
    private List<byte[]> states = List.of();
    private final List<Entry> entries = new ArrayList<>();
    private long bytes;
    /** Expected time of a checkpoint, and time that the orders since the last one took; s. */
    private double cost;
    private double since;

    private final InitialMesh mesh;
    private final HostCalls calls;
    private final ShotHistory totals;
    /** The hosts that have all light ever shot. */
    private final Set<Host> informed = new HashSet<>();

    private record Entry(Order order, Supplier<byte[]> encoded, long bytes) { }

    ShotLog(InitialMesh mesh, HostCalls calls) {
        this.mesh = mesh;
        this.calls = calls;
        totals = new ShotHistory(mesh.faces.channels());
        cost = Math.max(FIRST_SECONDS, mesh.patcher.patches() * SECONDS_PER_PATCH);
    }

    /** @param encoded the order as hosts receive it; null if hosts receive it without radiosities */
    void add(Order order, byte[] encoded) {
        Entry entry = encoded == null
                ? new Entry(order, order::encode, order.shots().stream().mapToLong(Shot::bytes).sum())
                : new Entry(order, () -> encoded, encoded.length);
        entries.add(entry);
        bytes += entry.bytes;
    }

    /** Removes an order that changes no element and that all hosts have answered: it need not be carried out again. */
    void remove(Order answered) {
        for (int i = entries.size() - 1; i >= 0; i--) {
            if (entries.get(i).order == answered) {
                bytes -= entries.remove(i).bytes;
                return;
            }
        }
    }

    /** Notes the time that the slowest host took for an order, s. */
    void took(double seconds) {
        since += seconds;
    }

    boolean isCheckpointDue() {
        return since >= PATIENCE * cost || bytes > MOST_BYTES;
    }

    /** Starts the log anew from the states of all blocks, by id, which took this time to fetch from hosts, s. */
    void checkpoint(List<byte[]> now, double seconds) {
        checkpoint(now);
        cost = Math.max(SECONDS, seconds);
        since = 0;
    }

    /** Starts the log anew from the states of all blocks, by id. */
    void checkpoint(List<byte[]> now) {
        states = List.copyOf(now);
        entries.clear();
        bytes = 0;
    }

    /** The message with which a host makes blocks its own: their states in the log, and all logged orders. */
    BlockTakeover adoption(List<Integer> blocks) {
        Map<Integer, byte[]> wanted = new TreeMap<>();
        for (int block : blocks) {
            wanted.put(block, states.isEmpty() ? BlockTakeover.INITIAL : states.get(block));
        }
        return new BlockTakeover(wanted, entries.stream().map(entry -> entry.encoded.get()).toList(), List.of());
    }

    /*---- The light that was ever shot ----*/

    /** Notes that a host has joined: it has all light ever shot only if nothing was shot yet. */
    void welcome(Host host) {
        if (totals.isEmpty()) {
            informed.add(host);
        }
    }

    /** Adds the shots of an order to the light ever shot; the hosts that receive the order do the same. */
    void count(Order order) {
        if (mesh.predicts() && order.marks()) {
            totals.add(order.shots());
        }
    }

    /** Replaces the light ever shot by these totals of all shooters; hosts do not have them yet. */
    void restart(List<Shot> now) {
        totals.set(now);
        informed.clear();
    }

    /** Forgets a host that was lost or has left. */
    void forget(Host host) {
        informed.remove(host);
    }

    /** Sends all light ever shot to the hosts that do not have it. */
    void inform(List<Host> hosts) {
        List<Host> late = hosts.stream().filter(host -> !informed.contains(host)).toList();
        if (!late.isEmpty()) {
            byte[] all = Wire.bytes(out -> Wire.write(totals.all(), mesh.faces.channels(), out));
            informed.addAll(calls.onAll(late, host -> host.know(all)).keySet());
        }
    }

    /**
     * The total that each shooter has shot. The list is filled while it is read: read it before the next shot.
     *
     * @param trees the shooters' trees as their elements are divided, without radiosities
     */
    List<Shot> totals(List<Shot> trees, ParallelFor parallel) {
        return new ShotsOnDemand(trees.size(), i -> totals.of(trees.get(i)), parallel);
    }
}
