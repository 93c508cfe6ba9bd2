package radiosity.prediction;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.RepresentativeFaces;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.mesh.room.ClosedRooms;
import radiosity.util.LongIndex;
import radiosity.util.ParallelFor;

/** What each vertex of a coarse mesh sees of its patches: the rows of a {@link CoarseSystem}. */
public final class CoarseRows {

    /** What an empty row takes on the wire. */
    private static final int ROW_BYTES = 13;

    /** Rows that a thread takes at a time. */
    private static final int RUN = 64;
    private static final int EQUATIONS = 1024;

    private final Faces faces;
    private final RadiosityNodes nodes;
    private final ParallelFor parallel;
    private final int channels;
    /** Number of a vertex by its key. */
    private final LongIndex index;
    /** Per vertex: the patches that it sees, as far as they are known. */
    private final int[][] column;
    /** Per vertex: weights of the three corners of each of them. */
    private final float[][] entry;
    /** Shots of which the rows are known. */
    private int taken;
    /** Per vertex: up to which of them its own row is; several partitions may have it, and say the same. */
    private final int[] parts;
    /** Per vertex: the one that stands for it. */
    private final int[] unknown;

    /** @param nodes the coarse mesh; vertices that partitions report as buried are marked in it */
    CoarseRows(RadiosityNodes nodes, RepresentativeFaces representatives, ParallelFor parallel) {
        this.nodes = nodes;
        this.parallel = parallel;
        unknown = IntStream.range(0, nodes.vertices()).map(v -> leader(v, representatives)).toArray();
        faces = nodes.faces();
        channels = faces.channels();
        index = new LongIndex(nodes.vertices());
        for (int v = 0; v < nodes.vertices(); v++) {
            index.findOrAdd(nodes.vertexKey(v), v);
        }
        column = new int[nodes.vertices()][];
        entry = new float[nodes.vertices()][];
        Arrays.fill(column, new int[0]);
        Arrays.fill(entry, new float[0]);
        parts = new int[nodes.vertices()];
    }

    private int leader(int v, RepresentativeFaces representatives) {
        int f = nodes.vertexFace(v);
        int leader = representatives.leader(f);
        return leader == f ? v : nodes.corner(nodes.find(leader, NodePath.FACE), 0);
    }

    /** The vertex whose irradiance stands for that of a vertex. */
    int unknown(int vertex) {
        return unknown[vertex];
    }

    /**
     * The next part of all rows: what is seen of the shots of {@link Importance} that come next.
     *
     * @param shots how many
     * @param rows  of each partition: number of vertices, then for each its key, whether it is buried, its elements
     */
    void take(int shots, List<byte[]> rows) throws IOException {
        taken += shots;
        for (byte[] part : rows) {
            read(ByteBuffer.wrap(part));
        }
    }

    /** Shots of which the rows are known. */
    int taken() {
        return taken;
    }

    /** For each vertex its key, whether it is buried, and its {@link RowRecorder}. */
    private void read(ByteBuffer in) throws IOException {
        for (int n = count(in, ROW_BYTES); n > 0; n--) {
            int v = in.remaining() < ROW_BYTES ? -1 : index.find(in.getLong());
            if (v < 0) {
                throw new IOException("rows: expected one of a vertex of the coarse mesh, got " + in.remaining()
                        + " bytes");
            }
            if (in.get() != 0) {
                nodes.bury(v);
            }
            int size = count(in, RowRecorder.entryBytes(nodes));
            int from = parts[v] == taken ? column[v].length - size : column[v].length;
            parts[v] = taken;
            column[v] = Arrays.copyOf(column[v], from + size);
            entry[v] = Arrays.copyOf(entry[v], 3 * (from + size));
            for (int i = from; i < from + size; i++) {
                column[v][i] = RowRecorder.node(nodes, in);
                for (int k = 0; k < 3; k++) {
                    entry[v][3 * i + k] = in.getFloat();
                }
            }
        }
    }

    private static int count(ByteBuffer in, int least) throws IOException {
        int count = in.remaining() < Integer.BYTES ? -1 : in.getInt();
        if (count < 0 || count > in.remaining() / least) {
            throw new IOException("rows: expected a number of them in " + in.remaining() + " bytes, got " + count);
        }
        return count;
    }

    /** In a closed room all that a vertex sees adds up to 1. */
    void close(ClosedRooms rooms) {
        for (int v = 0; v < entry.length; v++) {
            double seen = 0;
            for (float part : entry[v]) {
                seen += part;
            }
            boolean closed = rooms.room(nodes.vertexFace(v)) >= 0 && seen > 0;
            for (int i = 0; i < entry[v].length && closed; i++) {
                entry[v][i] /= (float) seen;
            }
        }
    }

    /** What arrives at each vertex from unshot radiosity. */
    double[] direct(double[] unshot) {
        double[] sum = new double[channels * column.length];
        parallel.run(column.length, RUN, (from, to) -> {
            for (int v = from; v < to; v++) {
                direct(v, unshot, sum);
            }
        });
        return sum;
    }

    private void direct(int v, double[] unshot, double[] sum) {
        for (int i = 0; i < column[v].length; i++) {
            double seen = (double) entry[v][3 * i] + entry[v][3 * i + 1] + entry[v][3 * i + 2];
            for (int c = 0; c < channels; c++) {
                sum[channels * v + c] += seen * unshot[channels * column[v][i] + c];
            }
        }
    }

    /**
     * What arrives at a vertex by reflection, in terms of the irradiance at vertices instead of patches' corners.
     *
     * @param enough see {@link GaussSeidel}
     */
    GaussSeidel equations(double enough) {
        int[][] columns = new int[column.length][];
        float[][] value = new float[column.length][];
        parallel.run(column.length, EQUATIONS, (from, to) -> {
            int[] place = new int[column.length];
            for (int v = from; v < to; v++) {
                equation(v, place, columns, value);
            }
        });
        return new GaussSeidel(channels, faces.colours(), columns, value, enough);
    }

    /** @param place scratch, 1 per vertex: where it stands in the equation; what is there first does not matter */
    private void equation(int v, int[] place, int[][] columns, float[][] value) {
        int colours = faces.colours();
        int[] vertices = new int[3 * column[v].length];
        float[] sum = new float[colours * vertices.length];
        int size = 0;
        for (int i = 0; i < column[v].length; i++) {
            int patch = column[v][i];
            for (int k = 0; k < 3; k++) {
                int at = unknown[nodes.corner(patch, k)];
                float weight = weight(patch, k, v, i);
                if (place[at] >= size || vertices[place[at]] != at) {
                    place[at] = size;
                    vertices[size++] = at;
                }
                for (int c = 0; c < colours; c++) {
                    sum[colours * place[at] + c] += weight * (float) nodes.reflectance(patch, c);
                }
            }
        }
        columns[v] = Arrays.copyOf(vertices, size);
        value[v] = Arrays.copyOf(sum, colours * size);
    }

    /** What counts for corner k of a patch in a row; that of a buried one is shared by the others. */
    private float weight(int patch, int k, int v, int i) {
        if (nodes.isBuried(nodes.corner(patch, k))) {
            return 0;
        }
        float buried = 0;
        int seen = 0;
        for (int j = 0; j < 3; j++) {
            boolean hidden = nodes.isBuried(nodes.corner(patch, j));
            buried += hidden ? entry[v][3 * i + j] : 0;
            seen += hidden ? 0 : 1;
        }
        return entry[v][3 * i + k] + buried / seen;
    }
}
