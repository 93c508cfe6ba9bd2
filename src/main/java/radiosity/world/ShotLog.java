package radiosity.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;

/** What makes a lost block whole again: its state at the last checkpoint and every order since. */
final class ShotLog {

    /** By id; empty before the first checkpoint, when all blocks are as in the initial mesh. */
    private List<byte[]> states = List.of();
    private final List<Supplier<byte[]>> orders = new ArrayList<>();
    private long bytes;

    /** @param encoded what the hosts were told, or null where that is not all */
    void add(Order order, byte[] encoded) {
        orders.add(encoded == null ? order::encode : () -> encoded);
        bytes += encoded == null ? order.shots().stream().mapToLong(Shot::bytes).sum() : encoded.length;
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

    /** @param said how many of the last orders are to be answered again */
    Adoption adoption(List<Integer> blocks, int said) {
        Map<Integer, byte[]> wanted = new TreeMap<>();
        for (int block : blocks) {
            wanted.put(block, states.isEmpty() ? Adoption.INITIAL : states.get(block));
        }
        return new Adoption(wanted, orders.stream().map(Supplier::get).toList(), said, List.of());
    }
}
