package radiosity.protocol;

import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.util.BitSet;
import radiosity.mesh.RadiosityNodes;

/**
 * A block as bytes. For each subtree, nodes in preorder: for an inner one the number under which it was split; for an
 * element -1, then what it has shot at its corners, and for each corner whose vertex was not met before a byte of flags
 * (buried, set aside), what it has received, and where it gathers anew what was set aside.
 */
public final class BlockState {

    private static final int BURIED = 1;
    private static final int SET_ASIDE = 2;

    private BlockState() { }

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
        int channels = nodes.channels();
        for (int i = 0; i < 3 * channels; i++) {
            out.writeDouble(nodes.light().shot(node, i / channels, i % channels));
        }
        for (int k = 0; k < 3; k++) {
            int v = nodes.corner(node, k);
            if (!met.get(v)) {
                met.set(v);
                out.writeByte((nodes.isBuried(v) ? BURIED : 0) | (nodes.isSetAside() ? SET_ASIDE : 0));
                for (int c = 0; c < channels; c++) {
                    out.writeDouble(nodes.light().irradiance()[channels * v + c]);
                }
                for (int c = 0; c < channels && nodes.isSetAside(); c++) {
                    out.writeDouble(nodes.shown(v, c));
                }
            }
        }
    }

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
    }

    private static void grow(RadiosityNodes nodes, int node, int share, BitSet met, ByteBuffer in) {
        if (share >= 0) {
            int first = nodes.isElement(node) ? nodes.split(node, share) : nodes.child(node);
            for (int k = 0; k < 4; k++) {
                grow(nodes, first + k, in.getInt(), met, in);
            }
            return;
        }
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
                    nodes.bury(v);
                }
                for (int c = 0; c < channels; c++) {
                    nodes.light().irradiance()[channels * v + c] = in.getDouble();
                }
                for (int c = 0; c < channels && (flags & SET_ASIDE) != 0; c++) {
                    nodes.setAside(v, c, in.getDouble());
                }
            }
        }
    }
}
