package radiosity.protocol;

import java.io.DataInputStream;
import java.io.DataOutput;
import java.io.IOException;
import java.nio.ByteBuffer;
import radiosity.mesh.PatchTree;
import radiosity.util.ArraySize;

/**
 * A {@link PatchTree} as bytes: face, path, number of nodes, one bit per node that says whether the node is divided,
 * then the radiosities of the elements in the shortest of {@link ShortestNumbers}, or none. Most of the bytes between
 * hosts are of this kind.
 *
 * <p>The four parts of a triangle share the middles of its edges: if the parts have equal radiosities at all of these
 * corners, each middle is written once.
 */
final class TreeBytes {

    /** Stands for a corner of an inner node. */
    private static final int INNER = -1;
    /** Bytes of face, path and number of nodes. */
    private static final int HEAD = 4 + 8 + 4;
    /** Bytes of the smallest tree: one element without radiosities. */
    static final int LEAST = 4 + 8 + 4 + 1 + 1;

    private TreeBytes() { }

    /** Writes a tree, which may have no radiosities. */
    static void write(PatchTree tree, int channels, DataOutput out) throws IOException {
        writeShape(tree, out);
        double[] radiosity = tree.radiosity();
        if (radiosity.length == 0) {
            out.writeByte(ShortestNumbers.NONE.form);
            return;
        }
        int[] same = same(tree.child());
        boolean once = isSame(radiosity, same, channels);
        Quantizer units = Quantizer.of(radiosity, channels);
        ShortestNumbers numbers = ShortestNumbers.of(radiosity, units);
        out.writeByte(numbers.form);
        out.writeBoolean(once);
        if (numbers == ShortestNumbers.BYTES) {
            units.write(out);
        }
        ByteBuffer bytes = ByteBuffer.allocate(ArraySize.of("bytes of the radiosities of a patch",
                corners(same, once), channels, numbers.bytes));
        for (int corner = 0; corner < same.length; corner++) {
            if (isWritten(corner, same, once)) {
                for (int c = 0; c < channels; c++) {
                    numbers.put(radiosity[channels * corner + c], units.at(corner / 3, c), bytes);
                }
            }
        }
        out.write(bytes.array());
    }

    private static void writeShape(PatchTree tree, DataOutput out) throws IOException {
        int[] child = tree.child();
        ByteBuffer shape = ByteBuffer.allocate(HEAD + bytes(child.length));
        shape.putInt(tree.face()).putLong(tree.path()).putInt(child.length);
        for (int i = 0; i < child.length; i += Byte.SIZE) {
            int divided = 0;
            for (int bit = 0; bit < Byte.SIZE && i + bit < child.length; bit++) {
                divided |= child[i + bit] >= 0 ? 1 << bit : 0;
            }
            shape.put((byte) divided);
        }
        out.write(shape.array());
    }

    private static int bytes(int bits) {
        return (bits + Byte.SIZE - 1) / Byte.SIZE;
    }

    static PatchTree read(DataInputStream in, int channels) throws IOException {
        ByteBuffer head = ByteBuffer.wrap(Wire.exactly(in, HEAD));
        int face = head.getInt();
        long path = head.getLong();
        int[] child = children(in, head.getInt());
        ShortestNumbers numbers = ShortestNumbers.of(in.readByte());
        double[] radiosity = numbers == ShortestNumbers.NONE ? new double[0] : radiosity(in, child, channels, numbers);
        return new PatchTree(face, path, child, radiosity);
    }

    private static double[] radiosity(DataInputStream in, int[] child, int channels, ShortestNumbers numbers)
            throws IOException {
        int[] same = same(child);
        boolean once = in.readBoolean();
        Quantizer units = numbers == ShortestNumbers.BYTES ? Quantizer.read(in, child.length, channels)
                : Quantizer.none(child.length, channels);
        double[] radiosity = new double[ArraySize.of("radiosities of a patch", channels, same.length)];
        ByteBuffer bytes = ByteBuffer.wrap(Wire.exactly(in, (long) corners(same, once) * channels * numbers.bytes));
        for (int corner = 0; corner < same.length; corner++) {
            if (isWritten(corner, same, once)) {
                for (int c = 0; c < channels; c++) {
                    radiosity[channels * corner + c] = numbers.get(units.at(corner / 3, c), bytes);
                }
            }
        }
        for (int corner = 0; corner < same.length && once; corner++) {
            if (same[corner] != INNER && same[corner] != corner) {
                System.arraycopy(radiosity, channels * same[corner], radiosity, channels * corner, channels);
            }
        }
        return radiosity;
    }

    /*---- Corners that elements have in common ----*/

    /**
     * 3 per node, one per corner: the corner with which it shares a written value, which is a corner of its middle
     * sibling or itself; {@link #INNER} for inner nodes. Children are numbered as by
     * {@link radiosity.mesh.RadiosityNodes#split}.
     */
    private static int[] same(int[] child) {
        int[] same = new int[3 * child.length];
        for (int corner = 0; corner < same.length; corner++) {
            same[corner] = child[corner / 3] < 0 ? corner : INNER;
        }
        for (int first : child) {
            for (int k = 0; k < 3 && first >= 0 && child[first + 3] < 0 && child[first + k] < 0; k++) {
                same[3 * (first + k) + (k + 1) % 3] = 3 * (first + 3) + (k + 2) % 3;
                same[3 * (first + k) + (k + 2) % 3] = 3 * (first + 3) + (k + 1) % 3;
            }
        }
        return same;
    }

    /** Whether all corners have the radiosity of the corner with which they would share a value. */
    private static boolean isSame(double[] radiosity, int[] same, int channels) {
        for (int corner = 0; corner < same.length; corner++) {
            for (int c = 0; c < channels && same[corner] != INNER && same[corner] != corner; c++) {
                if (radiosity[channels * corner + c] != radiosity[channels * same[corner] + c]) {
                    return false;
                }
            }
        }
        return true;
    }

    private static boolean isWritten(int corner, int[] same, boolean once) {
        return same[corner] == corner || !once && same[corner] != INNER;
    }

    /** Number of corners whose radiosities are written. */
    private static int corners(int[] same, boolean once) {
        int count = 0;
        for (int corner = 0; corner < same.length; corner++) {
            count += isWritten(corner, same, once) ? 1 : 0;
        }
        return count;
    }

    /** Reads a bit per node, breadth first: each divided node has the next four nodes as its children. */
    private static int[] children(DataInputStream in, int nodes) throws IOException {
        if (nodes < 1 || nodes > Byte.SIZE * (long) in.available()) {
            throw new IOException("shot: expected nodes in " + in.available() + " bytes, got " + nodes);
        }
        byte[] divided = Wire.exactly(in, bytes(nodes));
        int[] child = new int[nodes];
        long next = 1;
        for (int i = 0; i < Byte.SIZE * divided.length; i++) {
            boolean isDivided = (divided[i / Byte.SIZE] >> i % Byte.SIZE & 1) == 1;
            if (i < nodes) {
                child[i] = isDivided ? (int) next : -1;
            }
            next += isDivided ? 4 : 0;
            if (i + 1 < nodes && i + 1 >= next || next > nodes) {
                throw new IOException("shot: expected a tree whose divided nodes have four children each, got " + nodes
                        + " nodes of which node " + i + " has or lacks some");
            }
        }
        return child;
    }
}
