package radiosity.protocol;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Blocks for a new owner: what they were at a checkpoint, and what was done since.
 *
 * @param states by id; empty for one that is as in the initial mesh
 * @param orders to be done again on all of them, in their order; some are answered
 * @param leave  blocks that it gives up
 */
public record BlockTakeover(Map<Integer, byte[]> states, List<byte[]> orders, List<Integer> leave) {

    /** What stands for a block as it is in the initial mesh. */
    public static final byte[] INITIAL = new byte[0];

    /** Whether all states are given: as the log has them, either all are or none. */
    public boolean isWhole() {
        return states.values().stream().noneMatch(state -> state.length == 0);
    }

    public boolean isUpToDate() {
        return orders.isEmpty() && isWhole();
    }

    /** Writes more bytes than one array may hold, where states are large. */
    public void write(DataOutputStream out) throws IOException {
        out.writeInt(states.size());
        for (Map.Entry<Integer, byte[]> state : states.entrySet()) {
            out.writeInt(state.getKey());
            Wire.write(out, state.getValue());
        }
        out.writeInt(orders.size());
        for (byte[] order : orders) {
            Wire.write(out, order);
        }
        out.writeInt(leave.size());
        for (int block : leave) {
            out.writeInt(block);
        }
    }

    public static BlockTakeover read(DataInputStream in) throws IOException {
        Map<Integer, byte[]> states = new TreeMap<>();
        for (int n = Wire.count(in, 2 * Integer.BYTES); n > 0; n--) {
            states.put(in.readInt(), Wire.bytes(in));
        }
        List<byte[]> orders = new ArrayList<>();
        for (int n = Wire.count(in, Integer.BYTES); n > 0; n--) {
            orders.add(Wire.bytes(in));
        }
        List<Integer> leave = new ArrayList<>();
        for (int n = Wire.count(in, Integer.BYTES); n > 0; n--) {
            leave.add(in.readInt());
        }
        return new BlockTakeover(states, orders, leave);
    }
}
