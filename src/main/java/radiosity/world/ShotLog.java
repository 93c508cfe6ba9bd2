package radiosity.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** What makes a lost block whole again: its state at the last checkpoint and every order since. */
final class ShotLog {

    /** By id; empty before the first checkpoint, when all blocks are as in the initial mesh. */
    private List<byte[]> states = List.of();
    private final List<byte[]> orders = new ArrayList<>();
    private long bytes;

    void add(byte[] order) {
        orders.add(order);
        bytes += order.length;
    }

    void checkpoint(List<byte[]> now) {
        states = List.copyOf(now);
        orders.clear();
        bytes = 0;
    }

    /** Bytes of the orders since the checkpoint. */
    long bytes() {
        return bytes;
    }

    Adoption adoption(List<Integer> blocks) {
        Map<Integer, byte[]> wanted = new TreeMap<>();
        for (int block : blocks) {
            wanted.put(block, states.isEmpty() ? Adoption.INITIAL : states.get(block));
        }
        return new Adoption(wanted, List.copyOf(orders));
    }
}
