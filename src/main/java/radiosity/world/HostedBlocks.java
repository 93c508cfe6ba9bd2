package radiosity.world;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.Set;
import radiosity.patch.Block;

/** The blocks that a host owns in a session: a {@link PartitionImpl} that is made anew when they become others. */
final class HostedBlocks {

    private final InitialMesh mesh;
    private final int threads;
    private Set<Integer> owned = new TreeSet<>();
    private PartitionImpl partition;
    private final Totals totals;

    HostedBlocks(InitialMesh mesh, int threads) {
        this.mesh = mesh;
        this.threads = threads;
        totals = new Totals(mesh.faces.channels());
        partition = of(owned);
    }

    private PartitionImpl of(Set<Integer> ids) {
        return new PartitionImpl(mesh, ids.stream().map(this::known).toList(), threads);
    }

    private Block known(int id) {
        if (id < 0 || id >= mesh.blocks.size()) {
            throw new IllegalArgumentException("block: expected an id below " + mesh.blocks.size() + ", got " + id);
        }
        return mesh.blocks.get(id);
    }

    /** @param cpu processor time since the last report, s */
    List<BlockWork> work(double cpu) {
        return List.of(partition.costs().report(cpu));
    }

    /** Does on the newcomers what was done since their states were taken, then joins them with the others. */
    void take(Adoption adoption) throws IOException {
        PartitionImpl newcomers = of(new TreeSet<>(adoption.states().keySet()));
        adoption.states().forEach((id, state) -> restore(newcomers, id, state));
        for (byte[] order : adoption.orders()) {
            newcomers.round(Order.decode(order).naming(0));
        }
        Map<Integer, byte[]> states = states(owned, partition);
        states.putAll(states(adoption.states().keySet(), newcomers));
        join(states, states.size() == adoption.states().size() ? newcomers : null);
    }

    void drop(Set<Integer> ids) {
        Map<Integer, byte[]> states = states(owned, partition);
        states.keySet().removeAll(ids);
        join(states, null);
    }

    private static Map<Integer, byte[]> states(Set<Integer> ids, PartitionImpl from) {
        Map<Integer, byte[]> states = new TreeMap<>();
        ids.forEach(id -> states.put(id, from.block(id)));
        return states;
    }

    /** @param ready a partition that has these states already, or null */
    private void join(Map<Integer, byte[]> states, PartitionImpl ready) {
        owned = new TreeSet<>(states.keySet());
        partition = ready != null ? ready : of(owned);
        if (ready == null) {
            states.forEach((id, state) -> restore(partition, id, state));
        }
    }

    private static void restore(PartitionImpl to, int id, byte[] state) {
        if (state.length > 0) {
            to.restore(id, state);
        }
    }

    /** Takes what was shot so far for what is told. */
    void know(List<Shot> shot) {
        totals.set(shot);
    }

    byte[] round(byte[] bytes) throws IOException {
        Order order = Order.decode(bytes);
        if (order.kind() == Order.Kind.GATHER) {
            return partition.round(order.shooting(totals.of(order.shots())));
        }
        if (mesh.predicts() && order.kind() == Order.Kind.SHOOT) {
            totals.add(order.shots());
        }
        return partition.round(order);
    }

    byte[] block(int id) {
        return partition.block(id);
    }
}
