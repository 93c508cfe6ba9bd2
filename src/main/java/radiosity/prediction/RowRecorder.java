package radiosity.prediction;

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

    private final RadiosityNodes nodes;
    private int[] node = new int[64];
    /** 3 per sample point: form factors to the corners of its element. */
    private float[] weight = new float[3 * 64];
    private int size;
    /** Number of sample points whose weights are scaled already. */
    private int closed;

    /** @param nodes the coarse mesh, to which all recorded elements belong */
    public RowRecorder(RadiosityNodes nodes) {
        this.nodes = nodes;
    }

    @Override
    public void add(ShooterHierarchy shooter, int leaf, double a, double b, double c) {
        if (size == node.length) {
            node = Arrays.copyOf(node, 2 * size);
            weight = Arrays.copyOf(weight, 6 * size);
        }
        node[size] = nodes.find(shooter.face(leaf), shooter.path(leaf));
        weight[3 * size] = (float) a;
        weight[3 * size + 1] = (float) b;
        weight[3 * size + 2] = (float) c;
        size++;
    }

    @Override
    public void close(double scale) {
        for (int i = 3 * closed; i < 3 * size; i++) {
            weight[i] *= (float) scale;
        }
        closed = size;
    }

    /**
     * The row as bytes: key of the receiving vertex, whether that is buried, the number of entries, then per entry its
     * node and the form factors to the node's three corners.
     *
     * @param vertex a vertex of the coarse mesh
     */
    public byte[] row(int vertex) {
        ByteBuffer bytes = ByteBuffer.allocate(ArraySize.of("bytes of a row of the coarse system",
                CoarseRows.ROW_BYTES + (long) size * entryBytes(nodes)));
        bytes.putLong(nodes.points().key(vertex)).put((byte) (nodes.points().isBuried(vertex) ? 1 : 0)).putInt(size);
        for (int i = 0; i < size; i++) {
            if (isWide(nodes)) {
                bytes.putInt(node[i]);
            } else {
                bytes.putChar((char) node[i]);
            }
            for (int k = 0; k < 3; k++) {
                bytes.putFloat(weight[3 * i + k]);
            }
        }
        return bytes.array();
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
