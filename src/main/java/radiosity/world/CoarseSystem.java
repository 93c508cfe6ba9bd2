package radiosity.world;

import java.io.DataInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import radiosity.patch.Block;
import radiosity.patch.Faces;
import radiosity.patch.LongIndex;
import radiosity.patch.PatchTree;
import radiosity.patch.RadiosityNodes;
import radiosity.patch.Rooms;
import radiosity.patch.Subdivision;
import radiosity.patch.Weights;

/**
 * The linear system of a coarse mesh (equation 2), by which is foreseen what light will become of unshot light.
 *
 * <p>Unknowns are irradiances at vertices: H = K (U + rho H), where U is given on patches. Each row of K is made by the
 * partition that owns the vertex, once; the system is solved here as often as there is a round.
 */
final class CoarseSystem {

    /** What an empty row takes on the wire, and what one entry of a row. */
    private static final int ROW_BYTES = 13;
    private static final int ENTRY_BYTES = 24;

    private final InitialMesh mesh;
    private final Faces faces;
    private final Rooms rooms;
    private final List<Block> blocks;
    private final RadiosityNodes nodes;
    private final boolean single;
    private final int channels;
    /** Number of a vertex by its key. */
    private final LongIndex index;
    /** Per vertex: the patches that it sees, as far as they are known. */
    private final int[][] column;
    /** Per vertex: weights of the three corners of each of them. */
    private final float[][] entry;
    /** Shots of {@link #importance} of which the rows are known. */
    private int taken;
    /** Per vertex: up to which of them its own row is; several partitions may have it, and say the same. */
    private final int[] parts;
    /** Of irradiance by reflected irradiance; null until it is needed. */
    private GaussSeidel equations;

    CoarseSystem(InitialMesh mesh) {
        this.mesh = mesh;
        faces = mesh.faces;
        rooms = mesh.rooms;
        channels = faces.channels();
        blocks = mesh.blocks;
        single = mesh.solvesAtOnce();
        nodes = new RadiosityNodes(mesh.coarse, blocks);
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

    /**
     * The next part of all rows: what is seen of the shots of {@link #importance} that come next.
     *
     * @param shots how many
     * @param rows  of each partition: number of vertices, then for each its key, whether it is buried, its elements
     */
    void take(int shots, List<byte[]> rows) throws IOException {
        taken += shots;
        for (byte[] part : rows) {
            read(Wire.input(part));
        }
    }

    /** Whether all rows are known as a whole. */
    boolean isMade() {
        return taken == (single ? nodes.patches() : blocks.size());
    }

    /** For each vertex its key, whether it is buried, and its {@link Rows}. */
    private void read(DataInputStream in) throws IOException {
        for (int n = Wire.count(in, ROW_BYTES); n > 0; n--) {
            int v = index.find(in.readLong());
            if (in.readBoolean()) {
                nodes.bury(v);
            }
            int size = Wire.count(in, ENTRY_BYTES);
            int from = parts[v] == taken ? column[v].length - size : column[v].length;
            parts[v] = taken;
            column[v] = Arrays.copyOf(column[v], from + size);
            entry[v] = Arrays.copyOf(entry[v], 3 * (from + size));
            for (int i = from; i < from + size; i++) {
                column[v][i] = nodes.find(in.readInt(), in.readLong());
                for (int k = 0; k < 3; k++) {
                    entry[v][3 * i + k] = in.readFloat();
                }
            }
        }
    }

    /**
     * All of the initial mesh as shots, with what it matters for light to come as radiosity: 1, and more for what
     * emits.
     */
    List<Shot> importance() {
        double[] mean = new double[Weights.count(rooms, faces.layers())];
        double[] area = new double[mean.length];
        for (int f = 0; f < faces.count(); f++) {
            for (int layer = 0; layer < faces.layers(); layer++) {
                mean[of(f, layer, mean)] += faces.area(f) * brightest(f, layer);
                area[of(f, layer, mean)] += faces.area(f);
            }
        }
        Arrays.setAll(mean, i -> mean[i] == 0 ? 0 : mean[i] / area[i]);
        return shooters().map(tops -> Shot.of(nodes, tops, 0, (node, k, c) ->
                mesh.rounded(1 + brightness(nodes.face(node), mean))))
                .toList();
    }

    /** Nodes that shoot together: those of a block, or single ones where clusters would not be exact enough. */
    private Stream<int[]> shooters() {
        return single ? IntStream.range(0, nodes.patches()).mapToObj(p -> new int[] {nodes.patch(p)})
                : blocks.stream().map(nodes::tops);
    }

    /** Where a face's room has its values of a layer. */
    private int of(int face, int layer, double[] values) {
        return Weights.at(rooms, face, layer, faces.layers(), values.length);
    }

    /** Of the layer in which a face is brightest, relative to the layer's mean in its room. */
    private double brightness(int face, double[] mean) {
        double most = 0;
        for (int layer = 0; layer < faces.layers(); layer++) {
            double all = mean[of(face, layer, mean)];
            most = Math.max(most, all == 0 ? 0 : brightest(face, layer) / all);
        }
        return most;
    }

    private double brightest(int face, int layer) {
        double e = 0;
        for (int c = layer * faces.colours(); c < (layer + 1) * faces.colours(); c++) {
            e = Math.max(e, faces.exitance(face, c));
        }
        return e;
    }

    /**
     * Irradiance that will come of unshot radiosity.
     *
     * @param unshot channels per node of the initial mesh, for patches, W/m²; not modified
     * @param goOn   asked now and then
     * @return channels per vertex, W/m²; null where it was not to go on
     */
    double[] irradiance(double[] unshot, BooleanSupplier goOn) {
        if (equations == null) {
            close();
            equations = equations();
        }
        return equations.solve(direct(unshot), goOn);
    }

    /** In a closed room all that a vertex sees adds up to 1. */
    private void close() {
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
    private double[] direct(double[] unshot) {
        double[] sum = new double[channels * column.length];
        for (int v = 0; v < column.length; v++) {
            for (int i = 0; i < column[v].length; i++) {
                double seen = (double) entry[v][3 * i] + entry[v][3 * i + 1] + entry[v][3 * i + 2];
                for (int c = 0; c < channels; c++) {
                    sum[channels * v + c] += seen * unshot[channels * column[v][i] + c];
                }
            }
        }
        return sum;
    }

    /** What arrives at a vertex by reflection, in terms of the irradiance at vertices instead of patches' corners. */
    private GaussSeidel equations() {
        int[][] unknown = new int[column.length][];
        float[][] value = new float[column.length][];
        int[] place = new int[column.length];
        int colours = faces.colours();
        for (int v = 0; v < column.length; v++) {
            int[] vertices = new int[3 * column[v].length];
            float[] sum = new float[colours * vertices.length];
            int size = 0;
            for (int i = 0; i < column[v].length; i++) {
                int patch = column[v][i];
                for (int k = 0; k < 3; k++) {
                    int at = nodes.corner(patch, k);
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
            unknown[v] = Arrays.copyOf(vertices, size);
            value[v] = Arrays.copyOf(sum, colours * size);
        }
        return new GaussSeidel(channels, colours, unknown, value);
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

    /** A buried corner takes the mean of the others. */
    private double corner(int patch, int k, double[] h, int c) {
        if (!nodes.isBuried(nodes.corner(patch, k))) {
            return h[channels * nodes.corner(patch, k) + c];
        }
        double sum = 0;
        int seen = 0;
        for (int j = 0; j < 3; j++) {
            int v = nodes.corner(patch, j);
            if (!nodes.isBuried(v)) {
                sum += h[channels * v + c];
                seen++;
            }
        }
        return seen == 0 ? 0 : sum / seen;
    }

    /**
     * Flux that matters where this irradiance arrives: {@link Faces#importance} times what arrives, scene units.
     *
     * @param counts which faces count
     */
    double weighted(double[] h, int c, IntPredicate counts) {
        double sum = 0;
        for (int p = 0; p < nodes.patches(); p++) {
            int patch = nodes.patch(p);
            if (!counts.test(nodes.face(patch))) {
                continue;
            }
            double importance = faces.importance(nodes.face(patch), c);
            for (int k = 0; k < 3; k++) {
                sum += nodes.area(patch) * importance * corner(patch, k, h, c) / 3;
            }
        }
        return sum * faces.size() * faces.size();
    }

    /** Room for {@link #restrict}. */
    double[] noUnshot() {
        return new double[channels * nodes.nodes()];
    }

    /** Adds to a shot what its patches will reflect of an irradiance, linear between the vertices. */
    Shot with(Shot shot, double[] h) {
        return new Shot(shot.trees().stream().map(tree -> with(tree, h)).toList(), shot.flux());
    }

    private PatchTree with(PatchTree tree, double[] h) {
        double[] radiosity = tree.radiosity().clone();
        spread(tree, 0, nodes.find(tree.face(), tree.path()), null, h, radiosity);
        return new PatchTree(tree.face(), tree.path(), tree.child(), radiosity);
    }

    /**
     * @param coarse node of the coarse mesh, or -1 below a patch
     * @param values below a patch: 3 x channels at the corners
     */
    private void spread(PatchTree tree, int node, int coarse, double[] values, double[] h, double[] radiosity) {
        double[] here = values;
        boolean patch = coarse >= 0 && nodes.isElement(coarse);
        if (patch) {
            here = new double[3 * channels];
            for (int i = 0; i < here.length; i++) {
                here[i] = nodes.reflectance(coarse, i % channels) * corner(coarse, i / channels, h, i % channels);
            }
        }
        int first = tree.child()[node];
        if (first < 0) {
            for (int i = 0; i < 3 * channels; i++) {
                radiosity[3 * channels * node + i] = mesh.rounded(radiosity[3 * channels * node + i] + here[i]);
            }
            return;
        }
        for (int k = 0; k < 4; k++) {
            spread(tree, first + k, coarse < 0 || patch ? -1 : nodes.child(coarse) + k,
                    here == null ? null : Subdivision.values(here, channels, k), h, radiosity);
        }
    }

    /** Adds, to the patches of the coarse mesh, the mean of what is shot. */
    void restrict(Shot shot, double[] unshot) {
        for (PatchTree tree : shot.trees()) {
            restrict(tree, 0, nodes.find(tree.face(), tree.path()), unshot);
        }
    }

    private void restrict(PatchTree tree, int node, int coarse, double[] unshot) {
        if (!nodes.isElement(coarse)) {
            for (int k = 0; k < 4; k++) {
                restrict(tree, tree.child()[node] + k, nodes.child(coarse) + k, unshot);
            }
            return;
        }
        double[] mean = new double[channels];
        tree.addMean(node, 1, mean);
        for (int c = 0; c < channels; c++) {
            unshot[channels * coarse + c] += mean[c];
        }
    }
}
