package radiosity.protocol;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Blocks for a new owner: their states at the last checkpoint, and the orders given since.
 *
 * @param states state of each block by its id; empty for a block that is as in the initial mesh
 * @param orders orders to carry out again on all of these blocks, in this order; some of them ask for answers
 * @param leave  ids of the blocks that the receiver of this message gives up
 */
public record BlockTakeover(Map<Integer, byte[]> states, List<byte[]> orders, List<Integer> leave) {

    /** The state of a block that is as in the initial mesh. */
    public static final byte[] INITIAL = new byte[0];

    /** Whether no block is as in the initial mesh; states from one log are either all given or all empty. */
    public boolean isWhole() {
        return states.values().stream().noneMatch(state -> state.length == 0);
    }

    public boolean isUpToDate() {
        return orders.isEmpty() && isWhole();
    }

    /** Writes to a stream, as large states may be more bytes than one array can hold. */
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
