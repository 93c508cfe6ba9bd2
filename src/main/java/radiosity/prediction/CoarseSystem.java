package radiosity.prediction;

import java.io.IOException;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import radiosity.mesh.Block;
import radiosity.mesh.PatchTree;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.RepresentativeFaces;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.Subdivision;
import radiosity.mesh.room.ClosedRooms;
import radiosity.protocol.Shot;
import radiosity.scene.Surface;
import radiosity.settings.Accuracy;
import radiosity.setup.InitialMesh;
import radiosity.util.ParallelFor;

/**
 * The linear system of a coarse mesh (equation 2 of the paper), which predicts the irradiance that unshot radiosity
 * will cause after all reflections.
 *
 * <p>Unknowns are irradiances at vertices: H = K (U + rho H), with unshot radiosity U on patches and form factors K.
 * Partitions make the rows of K once; the master solves the system in every round.
 */
public final class CoarseSystem {

    /** Relative change that ends the sweeps: where rows err by some per cent, and where any remainder would show. */
    private static final double ROUGHLY = 1e-5;
    private static final double EXACTLY = 1e-9;
    /** Most light that a patch may reflect, as a multiple of what it reflects of the light by the rows. */
    private static final double MOST_REBALANCED = 4;

    private final InitialMesh mesh;
    private final ParallelFor parallel;
    private final Faces faces;
    private final ClosedRooms rooms;
    private final List<Block> blocks;
    private final RadiosityNodes nodes;
    private final boolean single;
    private final int channels;
    private final CoarseRows rows;
    private boolean isComplete;
    /**
     * Colours per node, used for patches: what a patch reflects of the irradiance by the rows. That is the patch's
     * reflectance before anything was shot, see {@link #rebalance}.
     */
    private final double[] reflectance;

    public CoarseSystem(InitialMesh mesh, ParallelFor parallel) {
        this.mesh = mesh;
        this.parallel = parallel;
        faces = mesh.faces;
        rooms = mesh.rooms;
        channels = faces.channels();
        blocks = mesh.clusters.clusters;
        single = mesh.solvesAtOnce();
        nodes = new RadiosityNodes(mesh.coarse, blocks);
        rows = new CoarseRows(nodes, mesh.representatives, parallel);
        reflectance = new double[faces.colours() * nodes.nodes()];
        for (int p = 0; p < nodes.patches(); p++) {
            for (int c = 0; c < faces.colours(); c++) {
                reflectance[faces.colours() * nodes.patch(p) + c] = nodes.reflectance(nodes.patch(p), c);
            }
        }
    }

    /**
     * Takes the next part of all rows: the entries of the next shots of {@link #importance}.
     *
     * @param shots number of these shots
     * @param parts 1 per partition, see {@link CoarseRows#take}
     * @throws IOException where the bytes are no rows of this mesh
     */
    public void take(int shots, List<byte[]> parts) throws IOException {
        rows.take(shots, parts);
    }

    /** Whether the rows have the entries of all shots. */
    public boolean isMade() {
        return rows.taken() == (single ? nodes.patches() : blocks.size());
    }

    /** Shots of the whole coarse mesh by which rows are made: their radiosity is the {@link Importance} of surfaces. */
    public List<Shot> importance() {
        Importance importance = new Importance(mesh);
        return shooters().map(tops -> importance.of(nodes, tops)).toList();
    }

    /** Top nodes per shooter: those of a cluster, or single patches where clusters would not be exact enough. */
    private Stream<int[]> shooters() {
        return single ? IntStream.range(0, nodes.patches()).mapToObj(p -> new int[] {nodes.patch(p)})
                : blocks.stream().map(nodes::tops);
    }

    /**
     * Predicts the irradiance that unshot radiosity will cause, directly and after all reflections.
     *
     * @param unshot channels per node of the coarse mesh, used for patches, W/m²; not modified
     * @param goOn   whether to go on; asked before every sweep
     * @return channels per vertex, W/m²; null where {@code goOn} was false
     * @throws radiosity.util.NoNumberException where the irradiance is not finite
     */
    public double[] irradiance(double[] unshot, BooleanSupplier goOn) {
        completeRows();
        return new GaussSeidel(rows, channels, reflectance, isRough() ? ROUGHLY : EXACTLY)
                .solve(rows.direct(unshot), goOn);
    }

    private void completeRows() {
        if (!isComplete) {
            rows.complete(rooms);
            isComplete = true;
        }
    }

    private boolean isRough() {
        return !single && !mesh.rounding.exact();
    }

    /**
     * Lets each patch reflect as much of the light by the rows as it has reflected of all light so far, so that the
     * system has the light of the fine mesh as its solution (K. Smith, Nodal method storage reduction by non-linear
     * iteration, 1983, for neutrons). Corners of patches see less than their middles where surfaces meet, and of two
     * neighbours with one row, one may lie in the shadow of a bulb: without this, each round would leave the same part
     * of its light to the next.
     *
     * <p>Rows of closed rooms are balanced already; there a face that another one
     * {@linkplain RepresentativeFaces represents} may reflect less than that one. Where lights without geometry shine,
     * their part of the irradiance is not known here, and nothing changes.
     *
     * @param totals radiosity that every patch has shot so far; not modified
     * @param unshot channels per node of the coarse mesh, used for patches, W/m²; not modified
     */
    public void rebalance(List<Shot> totals, double[] unshot) {
        if (!isRough() || !mesh.scene.lights().isEmpty()) {
            return;
        }
        completeRows();
        double[] shot = restrict(totals);
        double[] h = rows.direct(shot);
        parallel.run(nodes.patches(), p -> rebalance(nodes.patch(p), shot, unshot, h));
    }

    private void rebalance(int patch, double[] shot, double[] unshot, double[] h) {
        int face = nodes.face(patch);
        double most = rooms.room(face) < 0 ? MOST_REBALANCED : mesh.representatives.leader(face) != face ? 1 : 0;
        int colours = faces.colours();
        for (int colour = 0; colour < colours && most > 0; colour++) {
            double own = nodes.reflectance(patch, colour);
            double reflected = 0;
            double byRows = 0;
            for (int c = colour; c < channels; c += colours) {
                reflected += shot[channels * patch + c] + unshot[channels * patch + c] - nodes.exitance(patch, c);
                for (int k = 0; k < 3; k++) {
                    byRows += own * corner(patch, k, h, c) / 3;
                }
            }
            double ratio = byRows > 0 ? Math.max(0, Math.min(most, reflected / byRows)) : 1;
            reflectance[colours * patch + colour] = Math.min(Surface.MAX_REFLECTANCE, own * ratio);
        }
    }

    private double reflectance(int patch, int channel) {
        return reflectance[faces.colours() * patch + channel % faces.colours()];
    }

    /** Irradiance at corner k of a patch, W/m²; at a buried corner the mean of the patch's other corners, or 0. */
    private double corner(int patch, int k, double[] h, int c) {
        IntToDoubleFunction atVertex = v -> h[channels * rows.unknown(v) + c];
        int corner = nodes.corner(patch, k);
        return nodes.points().isBuried(corner) ? nodes.light().ofOthers(patch, atVertex)
                : atVertex.applyAsDouble(corner);
    }

    /**
     * Flux that arrives on some faces, weighted by {@link Faces#importance}, W.
     *
     * @param h      irradiance, channels per vertex, W/m²; not modified
     * @param counts whether a face counts
     */
    public double weighted(double[] h, int c, IntPredicate counts) {
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

    /**
     * Change of the radiosity that an irradiance causes where patches reflect it, relative to the mean radiosity, over
     * the area of all patches.
     *
     * @param size root mean square of the change; that of a {@linkplain Accuracy#BRIGHT bright} patch is relative to a
     *             part of the patch's own radiosity, as errors of a certificate are
     * @param bias mean of the change
     */
    public record Change(double size, double bias) { }

    /**
     * The change that an irradiance would make to one channel.
     *
     * @param h         irradiance, channels per vertex, W/m²; not modified
     * @param radiosity channels per node of the coarse mesh, used for patches, W/m²; not modified
     * @param weights   1 / mean radiosity, m²/W
     */
    public Change change(double[] h, double[] radiosity, Weights weights, int c) {
        double area = 0;
        double squares = 0;
        double bias = 0;
        for (int p = 0; p < nodes.patches(); p++) {
            int patch = nodes.patch(p);
            double weight = weights.at(nodes.face(patch), c);
            double reflected = 0;
            for (int k = 0; k < 3; k++) {
                reflected += reflectance(patch, c) * corner(patch, k, h, c) / 3;
            }
            double change = reflected * weight;
            double size = change / Math.max(1, radiosity[channels * patch + c] * weight / Accuracy.BRIGHT);
            area += nodes.area(patch);
            squares += nodes.area(patch) * size * size;
            bias += nodes.area(patch) * change;
        }
        return new Change(Math.sqrt(squares / area), bias / area);
    }

    /**
     * Adds to the radiosity of shots the part of an irradiance that their patches reflect, linear between vertices.
     *
     * @param shots of elements none of which is larger than a patch of the coarse mesh; not modified
     * @param h     irradiance, channels per vertex, W/m²; not modified
     * @param first whether nothing was shot before: the shots are then rounded less
     */
    public List<Shot> with(List<Shot> shots, double[] h, boolean first) {
        return new ShotsOnDemand(shots.size(), i -> with(shots.get(i), h, first), parallel);
    }

    private Shot with(Shot shot, double[] h, boolean first) {
        Shot made = new Shot(shot.trees().stream().map(tree -> with(tree, h)).toList(), shot.flux());
        return first ? mesh.rounding.finely(made) : mesh.rounding.of(made);
    }

    private PatchTree with(PatchTree tree, double[] h) {
        double[] radiosity = tree.radiosity().clone();
        spread(tree, 0, nodes.find(tree.face(), tree.path()), null, h, radiosity);
        return new PatchTree(tree.face(), tree.path(), tree.child(), radiosity);
    }

    /**
     * @param coarse    node of the coarse mesh, or -1 below a patch
     * @param values    reflected radiosity at the node's corners, 3 x channels, below a patch; else null
     * @param radiosity modified: the reflected radiosity is added
     */
    private void spread(PatchTree tree, int node, int coarse, double[] values, double[] h, double[] radiosity) {
        double[] here = values;
        boolean patch = coarse >= 0 && nodes.isElement(coarse);
        if (patch) {
            here = new double[3 * channels];
            for (int i = 0; i < here.length; i++) {
                here[i] = reflectance(coarse, i % channels) * corner(coarse, i / channels, h, i % channels);
            }
        }
        int first = tree.child()[node];
        if (first < 0) {
            for (int i = 0; i < 3 * channels; i++) {
                radiosity[3 * channels * node + i] += here[i];
            }
            return;
        }
        for (int k = 0; k < 4; k++) {
            spread(tree, first + k, coarse < 0 || patch ? -1 : nodes.child(coarse) + k,
                    here == null ? null : Subdivision.values(here, channels, k), h, radiosity);
        }
    }

    /**
     * Mean radiosity of shots on the patches of the coarse mesh: channels per node, 0 for inner nodes, W/m².
     *
     * @param shots no two of the same patch; not modified
     */
    public double[] restrict(List<Shot> shots) {
        double[] radiosity = new double[channels * nodes.nodes()];
        parallel.run(shots.size(), i -> restrict(shots.get(i), radiosity));
        return radiosity;
    }

    private void restrict(Shot shot, double[] radiosity) {
        for (PatchTree tree : shot.trees()) {
            restrict(tree, 0, nodes.find(tree.face(), tree.path()), radiosity);
        }
    }

    private void restrict(PatchTree tree, int node, int coarse, double[] radiosity) {
        if (!nodes.isElement(coarse)) {
            for (int k = 0; k < 4; k++) {
                restrict(tree, tree.child()[node] + k, nodes.child(coarse) + k, radiosity);
            }
            return;
        }
        double[] mean = new double[channels];
        tree.addMean(node, 1, mean);
        for (int c = 0; c < channels; c++) {
            radiosity[channels * coarse + c] += mean[c];
        }
    }
}
