package radiosity.worker;

import java.io.DataInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import radiosity.mesh.Block;
import radiosity.partition.GhostVertices;
import radiosity.partition.PartitionImpl;
import radiosity.protocol.BlockTakeover;
import radiosity.protocol.BlockWork;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.setup.InitialMesh;
import radiosity.util.ParallelFor;

/** The blocks that a host owns in a session: a {@link PartitionImpl} that is replaced when the blocks change. */
final class HostedBlocks {

    private final InitialMesh mesh;
    private final int threads;
    private final Set<Integer> owned = new TreeSet<>();
    private PartitionImpl partition;
    private final ShotHistory totals;
    /** Orders whose ghost values have not come: they are not carried out yet at vertices where other hosts gather. */
    private final List<Order> withoutGhosts = new ArrayList<>();
    /** The ghost values for other hosts that the last order has asked for; or empty. */
    private byte[] given = {};

    HostedBlocks(InitialMesh mesh, int threads) {
        this.mesh = mesh;
        this.threads = threads;
        totals = new ShotHistory(mesh.faces.channels());
        partition = of(owned, true);
    }

    /** @param restored whether the states of all these blocks will be restored */
    private PartitionImpl of(Set<Integer> ids, boolean restored) {
        return new PartitionImpl(mesh, ids.stream().map(this::known).toList(), new ParallelFor(threads), restored);
    }

    private Block known(int id) {
        if (id < 0 || id >= mesh.blocks.size()) {
            throw new IllegalArgumentException("block: expected an id below " + mesh.blocks.size() + ", got " + id);
        }
        return mesh.blocks.get(id);
    }

    /** The work on each block since the last report, in which the host's processor time was {@code cpu}, s. */
    List<BlockWork> work(double cpu) {
        return List.of(partition.costs().report(cpu));
    }

    /**
     * Gives up some blocks and makes others this host's own: carries out on these the orders given since their states
     * were saved, then joins them with the blocks that the host has.
     *
     * @return the answers of the new blocks to those of the orders that ask for one
     */
    List<byte[]> take(BlockTakeover adoption) throws IOException {
        gatherMissing();
        List<byte[]> answers = new ArrayList<>();
        owned.removeAll(adoption.leave());
        Map<Integer, byte[]> states = states(owned, partition);
        owned.addAll(adoption.states().keySet());
        if (adoption.isUpToDate()) {
            states.putAll(adoption.states());
        } else {
            PartitionImpl newcomers = upToDate(adoption, answers);
            if (states.isEmpty()) {
                partition = newcomers;
                return answers;
            }
            states.putAll(states(adoption.states().keySet(), newcomers));
        }
        partition = of(owned, true);
        states.forEach(partition::restore);
        return answers;
    }

    private PartitionImpl upToDate(BlockTakeover adoption, List<byte[]> answers) throws IOException {
        boolean restored = adoption.isWhole();
        PartitionImpl newcomers = of(adoption.states().keySet(), restored);
        if (restored) {
            adoption.states().forEach(newcomers::restore);
        }
        for (byte[] bytes : adoption.orders()) {
            Order order = Order.decode(bytes);
            byte[] answer = newcomers.round(order);
            if (order.isAnswered()) {
                answers.add(answer);
            }
        }
        return newcomers;
    }

    private static Map<Integer, byte[]> states(Set<Integer> ids, PartitionImpl from) {
        Map<Integer, byte[]> states = new TreeMap<>();
        ids.forEach(id -> states.put(id, from.block(id)));
        return states;
    }

    /** Replaces the light ever shot. */
    void know(List<Shot> shot) {
        totals.set(shot);
    }

    /** Carries out an order, which is followed in the stream by the ghost values for this host, if any. */
    byte[] round(DataInputStream in) throws IOException {
        Order order = Order.decode(in);
        if (in.available() > 0 && partition.takeGhosts(in)) {
            withoutGhosts.clear();
        }
        if (mesh.predicts() && order.marks()) {
            totals.add(order.shots());
        }
        byte[] answer = order.gathers() ? gather(order) : answer(order);
        given = order.givesGhosts() ? partition.ghosts().give() : new byte[0];
        return answer;
    }

    private byte[] gather(Order order) {
        Order whole = whole(order);
        if (partition.ghosts().isTaking()) {
            withoutGhosts.add(whole);
        }
        return partition.round(whole);
    }

    private byte[] answer(Order order) {
        if (!order.givesGhosts() && order.kind() != Order.Kind.REST) {
            gatherMissing();
        }
        return partition.round(order);
    }

    /** The order with its radiosities, which hosts are not sent where they are all light ever shot. */
    private Order whole(Order order) {
        return order.kind().gathersTotals() ? order.shooting(totals.of(order.shots())) : order;
    }

    /** The ghost values for other hosts that the last order has asked for; else empty. */
    byte[] given() {
        return given;
    }

    /** Gathers at the vertices where other hosts gather, for all orders whose ghost values have not come. */
    private void gatherMissing() {
        withoutGhosts.forEach(partition::gatherAtGhosts);
        withoutGhosts.clear();
    }

    /** See {@link GhostVertices#name}. */
    byte[] border() {
        gatherMissing();
        return partition.ghosts().name();
    }

    /** See {@link GhostVertices#agree}. */
    void share(DataInputStream roles) throws IOException {
        partition.ghosts().agree(roles);
    }

    byte[] block(int id) {
        gatherMissing();
        return partition.block(id);
    }
}
