package radiosity.protocol;

import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.util.BitSet;
import java.util.List;
import radiosity.mesh.Block;
import radiosity.mesh.Patcher;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.ReceivingPoints;

/**
 * Writes the state of a block as bytes and restores it. The state lists the nodes of each subtree in preorder. An inner
 * node is the number of the split that divided it. An element is -1, the radiosity that it has shot at its corners, and
 * for each corner whose vertex was not listed before: a byte of flags (1 buried, 2 set aside, 4 times how bright), the
 * vertex's irradiance, and with the second flag the irradiance that was set aside while the vertex gathers anew. All
 * values are W/m².
 */
public final class BlockState {

    private static final int BURIED = 1;
    private static final int SET_ASIDE = 2;
    private static final int BRIGHT = 4;

    private BlockState() { }

    /** The nodes of a block with the light of its state, see {@link #restore}. */
    public static RadiosityNodes nodes(Patcher mesh, Block block, byte[] state) {
        RadiosityNodes nodes = new RadiosityNodes(mesh, List.of(block));
        restore(nodes, nodes.tops(), state);
        return nodes;
    }

    /** @param tops top nodes of the block's subtrees, in the block's order */
    public static byte[] write(RadiosityNodes nodes, int[] tops) {
        BitSet met = new BitSet(nodes.vertices());
        return Wire.bytes(out -> {
            for (int top : tops) {
                write(nodes, top, met, out);
            }
        });
    }

    private static void write(RadiosityNodes nodes, int node, BitSet met, DataOutputStream out)
            throws IOException {
        out.writeInt(nodes.isElement(node) ? -1 : nodes.dividedWith(node));
        if (!nodes.isElement(node)) {
            for (int k = 0; k < 4; k++) {
                write(nodes, nodes.child(node) + k, met, out);
            }
            return;
        }
        ReceivingPoints points = nodes.points();
        int channels = nodes.channels();
        for (int i = 0; i < 3 * channels; i++) {
            out.writeDouble(nodes.light().shot(node, i / channels, i % channels));
        }
        for (int k = 0; k < 3; k++) {
            int v = nodes.corner(node, k);
            if (!met.get(v)) {
                met.set(v);
                out.writeByte((points.isBuried(v) ? BURIED : 0) | (points.isSetAside() ? SET_ASIDE : 0)
                        | BRIGHT * points.bright(v));
                for (int c = 0; c < channels; c++) {
                    out.writeDouble(nodes.light().irradiance()[channels * v + c]);
                }
                for (int c = 0; c < channels && points.isSetAside(); c++) {
                    out.writeDouble(points.shown(v, c));
                }
            }
        }
    }

    /**
     * Restores a block whose subtrees are as in the initial mesh, or are divided no deeper than in the state.
     *
     * @param nodes modified: divided as in the state, with the light of the state
     * @param tops  top nodes of the block's subtrees, in the block's order
     * @throws UncheckedIOException where the state is too short or too long
     */
    public static void restore(RadiosityNodes nodes, int[] tops, byte[] state) {
        BitSet met = new BitSet(nodes.vertices());
        ByteBuffer in = ByteBuffer.wrap(state);
        try {
            for (int top : tops) {
                grow(nodes, top, in.getInt(), met, in);
            }
        } catch (BufferUnderflowException e) {
            throw new UncheckedIOException(new EOFException("block: expected more than " + state.length + " bytes"));
        }
        if (in.hasRemaining()) {
            throw new UncheckedIOException(new IOException("block: expected " + in.position() + " bytes, got "
                    + state.length));
        }
    }

    private static void grow(RadiosityNodes nodes, int node, int share, BitSet met, ByteBuffer in) {
        if (share >= 0) {
            int first = nodes.isElement(node) ? nodes.split(node, share) : nodes.child(node);
            for (int k = 0; k < 4; k++) {
                grow(nodes, first + k, in.getInt(), met, in);
            }
            return;
        }
        ReceivingPoints points = nodes.points();
        int channels = nodes.channels();
        for (int i = 0; i < 3 * channels; i++) {
            nodes.light().setShot(node, i / channels, i % channels, in.getDouble());
        }
        for (int k = 0; k < 3; k++) {
            int v = nodes.corner(node, k);
            if (!met.get(v)) {
                met.set(v);
                int flags = in.get();
                if ((flags & BURIED) != 0) {
                    points.bury(v);
                }
                points.setBright(v, flags / BRIGHT & Patcher.MOST_SLACK);
                for (int c = 0; c < channels; c++) {
                    nodes.light().irradiance()[channels * v + c] = in.getDouble();
                }
                for (int c = 0; c < channels && (flags & SET_ASIDE) != 0; c++) {
                    points.setAside(v, c, in.getDouble());
                }
            }
        }
    }
}
