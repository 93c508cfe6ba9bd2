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
import radiosity.partition.GhostReport;
import radiosity.partition.GhostVertices;
import radiosity.partition.PartitionImpl;
import radiosity.protocol.BlockTakeover;
import radiosity.protocol.BlockWork;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.protocol.Wire;
import radiosity.setup.InitialMesh;

/** The blocks that a host owns in a session: a {@link PartitionImpl} that is made anew when they become others. */
final class HostedBlocks {

    private final InitialMesh mesh;
    private final int threads;
    private final Set<Integer> owned = new TreeSet<>();
    private PartitionImpl partition;
    private final ShotHistory totals;
    /** Orders that were not done yet where other hosts gather. */
    private final List<byte[]> owed = new ArrayList<>();
    private byte[] given = {};

    HostedBlocks(InitialMesh mesh, int threads) {
        this.mesh = mesh;
        this.threads = threads;
        totals = new ShotHistory(mesh.faces.channels());
        partition = of(owned, true);
    }

    private PartitionImpl of(Set<Integer> ids, boolean restored) {
        return new PartitionImpl(mesh, ids.stream().map(this::known).toList(), threads, restored);
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

    /**
     * Does on the newcomers what was done since their states were taken, then joins them with the others.
     *
     * @return what the newcomers answer to the orders that are to be answered
     */
    List<byte[]> take(BlockTakeover adoption) throws IOException {
        settle();
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
        int silent = adoption.orders().size() - adoption.said();
        for (int i = 0; i < adoption.orders().size(); i++) {
            Order order = Order.decode(adoption.orders().get(i));
            byte[] answer = newcomers.round(i < silent ? order.naming(-1) : order);
            if (i >= silent) {
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

    /** Takes what was shot so far for what is told. */
    void know(List<Shot> shot) {
        totals.set(shot);
    }

    byte[] round(byte[] bytes) throws IOException {
        DataInputStream in = Wire.input(bytes);
        Order order = Order.decode(in);
        given = new byte[0];
        if (in.available() > 0 && partition.take(in)) {
            owed.clear();
        }
        byte[] answer = order.gathers() ? gather(order, bytes) : ask(order);
        if (partition.isShared() && (mesh.hasSeams() || order.most() == Order.GIVE)) {
            given = partition.border().give();
        }
        return answer;
    }

    private byte[] gather(Order order, byte[] bytes) throws IOException {
        if (mesh.predicts() && order.kind() == Order.Kind.SHOOT) {
            totals.add(order.shots());
        }
        if (!partition.isShared()) {
            return partition.round(whole(order));
        }
        if (partition.takes(order)) {
            owed.add(bytes);
        }
        if (mesh.hasSeams()) {
            return partition.round(order);
        }
        Order now = whole(order);
        byte[] nothing = partition.round(now.naming(-1));
        return order.isAnswered() ? ask(Order.plain(Order.Kind.ASK, order.most()).from(order.least())) : nothing;
    }

    /** With what was shot, where the order says by whom only. */
    private Order whole(Order order) {
        return order.kind() == Order.Kind.GATHER ? order.shooting(totals.of(order.shots())) : order;
    }

    private byte[] ask(Order order) throws IOException {
        if (order.most() != Order.GIVE && !(mesh.hasSeams() && order.kind() == Order.Kind.ASK)) {
            settle();
        }
        return partition.round(order);
    }

    /** For other hosts: what this one has gathered for them up to the last order. */
    byte[] given() {
        return given;
    }

    /** Gathers where others should have gathered and nothing was heard of it. */
    private void settle() throws IOException {
        for (byte[] order : owed) {
            partition.gatherAt(whole(Order.decode(order)), partition.border().taken());
        }
        owed.clear();
    }

    /** See {@link GhostVertices#name}. */
    byte[] border(boolean anew) throws IOException {
        settle();
        return partition.nameBorder(anew);
    }

    /** @return what it leaves to the master: a {@link GhostReport}, or nothing */
    byte[] share(DataInputStream roles) throws IOException {
        partition.border().agree(roles);
        return mesh.hasSeams() ? partition.leaveSeam() : new byte[0];
    }

    byte[] block(int id) throws IOException {
        settle();
        return partition.block(id);
    }
}
