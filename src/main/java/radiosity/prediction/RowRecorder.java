package radiosity.prediction;

import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import radiosity.formfactor.GatherSink;
import radiosity.formfactor.ShooterHierarchy;
import radiosity.mesh.RadiosityNodes;
import radiosity.util.ArraySize;

/**
 * Records the elements that one receiving point sees and their weights, instead of summing up light: a row of a
 * {@link CoarseSystem}. For use by one thread.
 */
public final class RowRecorder implements GatherSink {

    private ShooterHierarchy[] shooter = new ShooterHierarchy[64];
    private int[] leaf = new int[64];
    private double[] weight = new double[3 * 64];
    private int size;
    /** Number of sample points whose weights are scaled already. */
    private int closed;

    @Override
    public void add(ShooterHierarchy from, int element, double a, double b, double c) {
        if (size == leaf.length) {
            shooter = Arrays.copyOf(shooter, 2 * size);
            leaf = Arrays.copyOf(leaf, 2 * size);
            weight = Arrays.copyOf(weight, 6 * size);
        }
        shooter[size] = from;
        leaf[size] = element;
        weight[3 * size] = a;
        weight[3 * size + 1] = b;
        weight[3 * size + 2] = c;
        size++;
    }

    @Override
    public void close(double scale) {
        for (int i = 3 * closed; i < 3 * size; i++) {
            weight[i] *= scale;
        }
        closed = size;
    }

    /**
     * Writes the number of entries, then per entry its node and the form factors to the node's three corners.
     *
     * @param nodes the coarse mesh, to which all recorded elements belong
     */
    public void write(RadiosityNodes nodes, DataOutputStream out) throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(ArraySize.of("bytes of a row of the coarse system",
                Integer.BYTES + (long) size * entryBytes(nodes))).putInt(size);
        for (int i = 0; i < size; i++) {
            int node = nodes.find(shooter[i].face(leaf[i]), shooter[i].path(leaf[i]));
            if (isWide(nodes)) {
                bytes.putInt(node);
            } else {
                bytes.putChar((char) node);
            }
            for (int k = 0; k < 3; k++) {
                bytes.putFloat((float) weight[3 * i + k]);
            }
        }
        out.write(bytes.array());
    }

    /** Number of bytes of a written entry. */
    static int entryBytes(RadiosityNodes nodes) {
        return (isWide(nodes) ? Integer.BYTES : Character.BYTES) + 3 * Float.BYTES;
    }

    private static boolean isWide(RadiosityNodes nodes) {
        return nodes.nodes() > Character.MAX_VALUE;
    }

    /** Reads the node of an entry; throws an exception where the node is no element of the mesh. */
    static int node(RadiosityNodes nodes, ByteBuffer in) throws IOException {
        int node = isWide(nodes) ? in.getInt() : in.getChar();
        if (node < 0 || node >= nodes.nodes() || !nodes.isElement(node)) {
            throw new IOException("row: expected an element, got node " + node + " of " + nodes.nodes());
        }
        return node;
    }
}
