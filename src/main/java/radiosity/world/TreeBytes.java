package radiosity.world;

import java.io.DataInputStream;
import java.io.DataOutput;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.BitSet;
import radiosity.patch.PatchTree;

/**
 * A {@link PatchTree} as bytes: face, path, number of nodes, a bit for each that is divided, then the radiosities of
 * its elements, in the shortest {@link Numbers} that lose nothing, or not at all. Most of what goes between hosts is
 * this.
 *
 * <p>What the four parts of a triangle have in common, the middles of its edges, is written once where it is the same.
 */
final class TreeBytes {

    /** What the smallest takes: one element that is grey. */
    static final int LEAST = 4 + 8 + 4 + 1 + 1;

    private TreeBytes() { }

    static void write(PatchTree tree, int channels, DataOutput out) throws IOException {
        writeShape(tree, out);
        double[] radiosity = tree.radiosity();
        int[] same = same(tree.child());
        boolean once = isSame(radiosity, same, channels);
        Numbers numbers = Numbers.of(radiosity);
        out.writeByte(numbers.form().ordinal());
        out.writeBoolean(once);
        out.writeShort(numbers.exponent());
        ByteBuffer bytes = ByteBuffer.allocate(corners(tree.child(), same, once) * channels * numbers.bytes());
        for (int corner = 0; corner < same.length; corner++) {
            for (int c = 0; c < channels && isWritten(corner, tree.child(), same, once); c++) {
                numbers.put(radiosity[channels * corner + c], bytes);
            }
        }
        out.write(bytes.array());
    }

    /** Without radiosities. */
    static void writeTree(PatchTree tree, DataOutput out) throws IOException {
        writeShape(tree, out);
        out.writeByte(Numbers.Form.NONE.ordinal());
    }

    private static void writeShape(PatchTree tree, DataOutput out) throws IOException {
        int[] child = tree.child();
        BitSet divided = new BitSet();
        for (int i = 0; i < child.length; i++) {
            divided.set(i, child[i] >= 0);
        }
        out.writeInt(tree.face());
        out.writeLong(tree.path());
        out.writeInt(child.length);
        out.write(Arrays.copyOf(divided.toByteArray(), bytes(child.length)));
    }

    private static int bytes(int bits) {
        return (bits + Byte.SIZE - 1) / Byte.SIZE;
    }

    static PatchTree read(DataInputStream in, int channels) throws IOException {
        int face = in.readInt();
        long path = in.readLong();
        int[] child = children(in);
        int form = in.readByte();
        double[] radiosity = form == Numbers.Form.NONE.ordinal() ? new double[0]
                : radiosity(in, child, channels, form);
        return new PatchTree(face, path, child, radiosity);
    }

    private static double[] radiosity(DataInputStream in, int[] child, int channels, int form) throws IOException {
        int[] same = same(child);
        boolean once = in.readBoolean();
        Numbers numbers = Numbers.of(form, in.readShort());
        double[] radiosity = new double[channels * same.length];
        int written = corners(child, same, once);
        ByteBuffer bytes = ByteBuffer.wrap(Wire.exactly(in, written * channels * numbers.bytes()));
        for (int corner = 0; corner < same.length; corner++) {
            for (int c = 0; c < channels && isWritten(corner, child, same, once); c++) {
                radiosity[channels * corner + c] = numbers.get(bytes);
            }
        }
        for (int corner = 0; corner < same.length && once; corner++) {
            System.arraycopy(radiosity, channels * same[corner], radiosity, channels * corner, channels);
        }
        return radiosity;
    }

    /*---- Corners that elements have in common ----*/

    /**
     * 3 per node: the corner that stands for it, one of the part in the middle or itself. Parts are numbered as
     * {@link radiosity.patch.RadiosityNodes#split} does.
     */
    private static int[] same(int[] child) {
        int[] same = new int[3 * child.length];
        Arrays.setAll(same, i -> i);
        for (int first : child) {
            for (int k = 0; k < 3 && first >= 0 && child[first + 3] < 0 && child[first + k] < 0; k++) {
                same[3 * (first + k) + (k + 1) % 3] = 3 * (first + 3) + (k + 2) % 3;
                same[3 * (first + k) + (k + 2) % 3] = 3 * (first + 3) + (k + 1) % 3;
            }
        }
        return same;
    }

    private static boolean isSame(double[] radiosity, int[] same, int channels) {
        for (int i = 0; i < radiosity.length; i++) {
            if (radiosity[i] != radiosity[channels * same[i / channels] + i % channels]) {
                return false;
            }
        }
        return true;
    }

    private static boolean isWritten(int corner, int[] child, int[] same, boolean once) {
        return child[corner / 3] < 0 && (!once || same[corner] == corner);
    }

    /** How many are written. */
    private static int corners(int[] child, int[] same, boolean once) {
        int count = 0;
        for (int corner = 0; corner < same.length; corner++) {
            count += isWritten(corner, child, same, once) ? 1 : 0;
        }
        return count;
    }

    /** Breadth first: the next node that is divided has the next four as its children. */
    private static int[] children(DataInputStream in) throws IOException {
        int nodes = in.readInt();
        if (nodes < 1 || nodes > Byte.SIZE * (long) in.available()) {
            throw new IOException("shot: expected nodes in " + in.available() + " bytes, got " + nodes);
        }
        BitSet divided = BitSet.valueOf(Wire.exactly(in, bytes(nodes)));
        if (4L * divided.cardinality() != nodes - 1 || divided.length() > nodes) {
            throw new IOException("shot: expected a tree whose divided nodes have four children each, got " + nodes
                    + " nodes with " + divided.cardinality() + " divided");
        }
        int[] child = new int[nodes];
        int next = 1;
        for (int i = 0; i < nodes; i++) {
            child[i] = divided.get(i) ? next : -1;
            next += divided.get(i) ? 4 : 0;
            if (i + 1 < nodes && i + 1 >= next) {
                throw new IOException("shot: expected node " + (i + 1) + " to be a child, got none above it");
            }
        }
        return child;
    }
}
