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

/** The rows of a {@link CoarseSystem}: for each vertex of a coarse mesh, form factors to the patches' corners. */
public final class CoarseRows {

    /** Bytes of an empty row on the wire: key, whether the vertex is buried, number of entries. */
    private static final int ROW_BYTES = 13;

    /** Largest number of rows that a thread takes at a time, to sum up light and to make equations. */
    private static final int RUN = 64;
    private static final int EQUATIONS = 1024;

    private final Faces faces;
    private final RadiosityNodes nodes;
    private final ParallelFor parallel;
    private final int channels;
    /** Number of a vertex by its key. */
    private final LongIndex index;
    /** 1 array per vertex: nodes of the patches that the vertex sees, of the shots taken so far. */
    private final int[][] column;
    /** 1 array per vertex: form factors to the three corners of each of these patches. */
    private final float[][] entry;
    /** Number of shots whose entries have been taken. */
    private int taken;
    /** 1 per vertex: {@link #taken} when its row last grew. Several partitions may send the same part of a row. */
    private final int[] parts;
    /** 1 per vertex: the vertex whose irradiance stands for the irradiance of this one, mostly itself. */
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
            index.findOrAdd(nodes.points().key(v), v);
        }
        column = new int[nodes.vertices()][];
        entry = new float[nodes.vertices()][];
        Arrays.fill(column, new int[0]);
        Arrays.fill(entry, new float[0]);
        parts = new int[nodes.vertices()];
    }

    private int leader(int v, RepresentativeFaces representatives) {
        int f = nodes.points().face(v);
        int leader = representatives.leader(f);
        return leader == f ? v : nodes.corner(nodes.find(leader, NodePath.FACE), 0);
    }

    /** The vertex whose irradiance stands for the irradiance of this vertex. */
    int unknown(int vertex) {
        return unknown[vertex];
    }

    /**
     * Takes the next part of all rows: the entries of the next shots of {@link CoarseSystem#importance}.
     *
     * @param shots number of these shots
     * @param rows  1 per partition: number of rows, then per row the vertex's key, whether the vertex is buried, and a
     *              {@link RowRecorder}'s entries
     * @throws IOException where the bytes are no rows of this mesh
     */
    void take(int shots, List<byte[]> rows) throws IOException {
        taken += shots;
        for (byte[] part : rows) {
            read(ByteBuffer.wrap(part));
        }
    }

    /** Number of shots whose entries have been taken. */
    int taken() {
        return taken;
    }

    private void read(ByteBuffer in) throws IOException {
        for (int n = count(in, ROW_BYTES); n > 0; n--) {
            int v = in.remaining() < ROW_BYTES ? -1 : index.find(in.getLong());
            if (v < 0) {
                throw new IOException("rows: expected one of a vertex of the coarse mesh, got " + in.remaining()
                        + " bytes");
            }
            if (in.get() != 0) {
                nodes.points().bury(v);
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

    /** Scales the rows of all vertices in closed rooms so that their form factors add up to 1, as they must there. */
    void close(ClosedRooms rooms) {
        for (int v = 0; v < entry.length; v++) {
            double seen = 0;
            for (float part : entry[v]) {
                seen += part;
            }
            boolean closed = rooms.room(nodes.points().face(v)) >= 0 && seen > 0;
            for (int i = 0; i < entry[v].length && closed; i++) {
                entry[v][i] /= (float) seen;
            }
        }
    }

    /**
     * Irradiance K U that comes directly from unshot radiosity: from channels per node to channels per vertex, W/m².
     */
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
     * The system H = D + K rho H, with irradiances at representative vertices as unknowns instead of patches' corners.
     *
     * @param reflectance colours per node of the coarse mesh, used for patches; not modified
     * @param enough      see {@link GaussSeidel}
     */
    GaussSeidel equations(double[] reflectance, double enough) {
        int[][] columns = new int[column.length][];
        float[][] value = new float[column.length][];
        parallel.run(column.length, EQUATIONS, (from, to) -> {
            int[] place = new int[column.length];
            for (int v = from; v < to; v++) {
                equation(v, reflectance, place, columns, value);
            }
        });
        return new GaussSeidel(channels, faces.colours(), columns, value, enough);
    }

    /** @param place scratch, 1 per vertex: its place in the equation of v; the initial content does not matter */
    private void equation(int v, double[] reflectance, int[] place, int[][] columns, float[][] value) {
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
                    sum[colours * place[at] + c] += weight * (float) reflectance[colours * patch + c];
                }
            }
        }
        columns[v] = Arrays.copyOf(vertices, size);
        value[v] = Arrays.copyOf(sum, colours * size);
    }

    /** Form factor of entry i of row v to corner k of its patch; a buried corner's is shared among the others. */
    private float weight(int patch, int k, int v, int i) {
        if (nodes.points().isBuried(nodes.corner(patch, k))) {
            return 0;
        }
        float buried = 0;
        int seen = 0;
        for (int j = 0; j < 3; j++) {
            boolean hidden = nodes.points().isBuried(nodes.corner(patch, j));
            buried += hidden ? entry[v][3 * i + j] : 0;
            seen += hidden ? 0 : 1;
        }
        return entry[v][3 * i + k] + buried / seen;
    }
}
