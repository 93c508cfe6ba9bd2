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
 * its elements, as floats where that loses nothing, or not at all. Most of what goes between hosts is this.
 */
final class TreeBytes {

    /** What the smallest takes: one element that is grey. */
    static final int LEAST = 4 + 8 + 4 + 1 + 1;

    /** How radiosities are written. */
    private enum Values { DOUBLES, FLOATS, NONE }

    private TreeBytes() { }

    static void write(PatchTree tree, int channels, DataOutput out) throws IOException {
        writeShape(tree, out);
        boolean exact = true;
        for (double u : tree.radiosity()) {
            exact &= (float) u == u;
        }
        out.writeByte((exact ? Values.FLOATS : Values.DOUBLES).ordinal());
        out.write(values(tree, 3 * channels, exact));
    }

    /** Without radiosities. */
    static void writeTree(PatchTree tree, DataOutput out) throws IOException {
        writeShape(tree, out);
        out.writeByte(Values.NONE.ordinal());
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

    private static byte[] values(PatchTree tree, int perNode, boolean floats) {
        int[] child = tree.child();
        ByteBuffer values = ByteBuffer.allocate((child.length - child.length / 4) * perNode * size(floats));
        for (int i = 0; i < perNode * child.length; i++) {
            if (child[i / perNode] >= 0) {
                continue;
            }
            if (floats) {
                values.putFloat((float) tree.radiosity()[i]);
            } else {
                values.putDouble(tree.radiosity()[i]);
            }
        }
        return values.array();
    }

    private static int size(boolean floats) {
        return floats ? Float.BYTES : Double.BYTES;
    }

    static PatchTree read(DataInputStream in, int channels) throws IOException {
        int face = in.readInt();
        long path = in.readLong();
        int[] child = children(in);
        int values = in.readByte();
        if (values == Values.NONE.ordinal()) {
            return new PatchTree(face, path, child, new double[0]);
        }
        return new PatchTree(face, path, child, radiosity(in, child, channels, values == Values.FLOATS.ordinal()));
    }

    private static double[] radiosity(DataInputStream in, int[] child, int channels, boolean floats) throws IOException {
        int perNode = 3 * channels;
        double[] radiosity = new double[perNode * child.length];
        ByteBuffer values = ByteBuffer.wrap(Wire.exactly(in, (child.length - child.length / 4) * perNode * size(floats)));
        for (int i = 0; i < radiosity.length; i++) {
            if (child[i / perNode] < 0) {
                radiosity[i] = floats ? values.getFloat() : values.getDouble();
            }
        }
        return radiosity;
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
