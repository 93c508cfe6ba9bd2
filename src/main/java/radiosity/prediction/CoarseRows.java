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
    static final int ROW_BYTES = 13;

    /** Largest number of rows that a thread takes at a time. */
    private static final int RUN = 64;

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
    /** 1 array per vertex, see {@link #corners}. */
    private final int[][] corners;

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
        corners = new int[nodes.vertices()][];
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
     * @param rows  1 per partition: number of rows, then the rows, see {@link RowRecorder#row}
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
            if (from < 0) {
                throw new IOException("rows: expected as many entries of a vertex from each partition, got " + size
                        + " after " + column[v].length);
            }
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

    /**
     * To be called once, when all rows are taken: scales the rows of vertices in closed rooms so that their form
     * factors add up to 1, as they must there, and shares the form factors to buried corners among the other corners of
     * the patch.
     */
    void complete(ClosedRooms rooms) {
        parallel.run(column.length, RUN, (from, to) -> {
            for (int v = from; v < to; v++) {
                if (rooms.room(nodes.points().face(v)) >= 0) {
                    close(entry[v]);
                }
                for (int i = 0; i < column[v].length; i++) {
                    shareBuried(column[v][i], entry[v], 3 * i);
                }
            }
        });
        setCorners();
    }

    private static void close(float[] row) {
        double seen = 0;
        for (float part : row) {
            seen += part;
        }
        for (int i = 0; i < row.length && seen > 0; i++) {
            row[i] /= (float) seen;
        }
    }

    /** Where all three corners are buried nothing is shared: no irradiance is known there, and nothing is reflected. */
    private void shareBuried(int patch, float[] row, int at) {
        float buried = 0;
        int others = 0;
        for (int k = 0; k < 3; k++) {
            boolean isBuried = nodes.points().isBuried(nodes.corner(patch, k));
            buried += isBuried ? row[at + k] : 0;
            others += isBuried ? 0 : 1;
        }
        for (int k = 0; k < 3 && buried > 0 && others > 0; k++) {
            boolean isBuried = nodes.points().isBuried(nodes.corner(patch, k));
            row[at + k] = isBuried ? 0 : row[at + k] + buried / others;
        }
    }

    private void setCorners() {
        int[] count = new int[corners.length];
        forEachCorner((vertex, corner) -> count[vertex]++);
        Arrays.setAll(corners, v -> new int[count[v]]);
        forEachCorner((vertex, corner) -> corners[vertex][--count[vertex]] = corner);
    }

    private interface CornerOfVertex {
        void take(int vertex, int corner);
    }

    private void forEachCorner(CornerOfVertex each) {
        for (int p = 0; p < nodes.patches(); p++) {
            for (int k = 0; k < 3; k++) {
                int v = nodes.corner(nodes.patch(p), k);
                if (!nodes.points().isBuried(v)) {
                    each.take(unknown[v], 3 * nodes.patch(p) + k);
                }
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

    /*---- The system, as it is read to solve it ----*/

    /** Number of rows: of vertices. */
    int count() {
        return column.length;
    }

    /** Number of nodes of the coarse mesh. */
    int nodes() {
        return nodes.nodes();
    }

    /** Nodes of the patches that a vertex sees; not to be modified. */
    int[] patches(int vertex) {
        return column[vertex];
    }

    /** Form factors to the three corners of each of the {@link #patches}; not to be modified. */
    float[] factors(int vertex) {
        return entry[vertex];
    }

    /** Corners of patches that have the irradiance of a vertex: 3 x node + 0 to 2 each; not to be modified. */
    int[] corners(int vertex) {
        return corners[vertex];
    }
}
