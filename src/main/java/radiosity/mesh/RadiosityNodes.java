package radiosity.mesh;

import java.util.List;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.util.ArraySize;

/**
 * The patch trees of some blocks and their light, in arrays (section 4.5.7 of the paper); a node is an index.
 *
 * <p>The leaves are the elements. Each element refers to three vertices. Irradiance is kept at vertices, shot radiosity
 * at the corners of each element; both are linear between corners. A patch is a leaf of the initial mesh: every node
 * that is made later lies below a patch.
 */
public final class RadiosityNodes extends NodeTree {

    private final Patcher patcher;
    private final Faces faces;
    private final int channels;
    private final ReceivingPoints points;
    private final ElementLight light;
    /** Leaves of the initial mesh, in the order of the blocks. */
    private final int[] patches;
    private int patchCount;
    /** Scratch space for the weights of a node's corners; makes division of nodes single-threaded. */
    private final int[] weights = new int[9];

    /** Makes the initial mesh of some blocks. */
    public RadiosityNodes(Patcher patcher, List<Block> blocks) {
        this(patcher, blocks, leaves(patcher, blocks), blocks.stream().mapToInt(block -> block.face().length).sum());
    }

    private RadiosityNodes(Patcher patcher, List<Block> blocks, long leaves, int tops) {
        super(tops, (int) Math.min(ArraySize.MOST, (4 * leaves - tops) / 3));
        this.patcher = patcher;
        faces = patcher.faces();
        channels = faces.channels();
        points = new ReceivingPoints(patcher);
        patches = new int[(int) leaves];
        for (Block block : blocks) {
            for (int i = 0; i < block.face().length; i++) {
                plant(block.face()[i], block.path()[i]);
            }
        }
        points.trim();
        light = new ElementLight(this, points);
    }

    private static long leaves(Patcher patcher, List<Block> blocks) {
        long leaves = 0;
        for (Block block : blocks) {
            for (int i = 0; i < block.face().length; i++) {
                leaves += 1L << 2 * (patcher.level(block.face()[i]) - NodePath.level(block.path()[i]));
            }
        }
        ElementLight.size(patcher.faces().channels(), leaves);
        return leaves;
    }

    private void plant(int f, long top) {
        float[] at = faces.corners(f, top);
        NodePath.weights(top, weights);
        int node = addRoot(f, top);
        int depth = patcher.level(f);
        for (int k = 0; k < 3; k++) {
            setCorner(node, k, patcher.isPoint(f) ? points.middle(f, at)
                    : points.vertex(f, weights, 3 * k, depth, at, 3 * k, 0));
        }
        grow(node, depth);
    }

    private void grow(int node, int depth) {
        if (level(node) == depth) {
            patches[patchCount++] = node;
            return;
        }
        int first = divide(node, depth, 0);
        for (int k = 0; k < 4; k++) {
            grow(first + k, depth);
        }
    }

    /**
     * Divides an element in four (section 2.5); new corners take interpolated irradiance and shot radiosity.
     *
     * @param with number of the split, above 0: new vertices are shared among all splits with this number
     * @return the first of the four children
     */
    public int split(int node, int with) {
        int first = divide(node, level(node) + 1, with);
        light.divide(node, first);
        return first;
    }

    /**
     * Must be called before the first split with a new number: vertices of earlier splits are not shared any more.
     *
     * @param expected approximate number of splits for which room is made
     */
    public void beginSplits(int expected) {
        points.forget();
        expect(expected);
        light.expect(expected);
    }

    private int divide(int node, int depth, int with) {
        NodePath.weights(path(node), weights);
        if (isPoint(node)) {
            giveCorners(node, depth, with);
        }
        int[] mid = new int[3];
        for (int k = 0; k < 3; k++) {
            int p = (k + 1) % 3;
            int q = (k + 2) % 3;
            int[] between = new int[3];
            for (int a = 0; a < 3; a++) {
                between[a] = (weights[3 * p + a] + weights[3 * q + a]) >> 1;
            }
            mid[k] = points.between(corner(node, p), corner(node, q), face(node), between, depth, with);
        }
        int first = addChildren(node);
        for (int k = 0; k < 3; k++) {
            setCorner(first + k, k, corner(node, k));
            setCorner(first + k, (k + 1) % 3, mid[(k + 2) % 3]);
            setCorner(first + k, (k + 2) % 3, mid[(k + 1) % 3]);
            setCorner(first + 3, k, mid[k]);
        }
        return first;
    }

    /** Gives a node that received at its middle a vertex at each corner; the vertex at the middle becomes buried. */
    private void giveCorners(int node, int depth, int with) {
        int middle = corner(node, 0);
        for (int k = 0; k < 3; k++) {
            setCorner(node, k, points.cornerInsteadOf(middle, face(node), weights, 3 * k, depth, with));
        }
        points.bury(middle);
    }

    /*---- Queries ----*/

    public Faces faces() {
        return faces;
    }

    public int channels() {
        return channels;
    }

    public ElementLight light() {
        return light;
    }

    public ReceivingPoints points() {
        return points;
    }

    public int vertices() {
        return points.count();
    }

    /** Number of patches of the initial mesh. */
    public int patches() {
        return patchCount;
    }

    /** The node of patch i, in the order of the blocks. */
    public int patch(int i) {
        return patches[i];
    }

    /** Levels between a node and the patch of which it is a part. */
    public int depthBelowPatch(int node) {
        return level(node) - patcher.level(face(node));
    }

    /** The top nodes of one block. */
    public int[] tops(Block of) {
        int[] found = new int[of.face().length];
        for (int i = 0; i < found.length; i++) {
            found[i] = find(of.face()[i], of.path()[i]);
        }
        return found;
    }

    /**
     * Position of corner k of a node in the scene. Safe for concurrent calls.
     *
     * @param to modified: x, y, z in scene units, 3 from {@code at}
     */
    public void position(int node, int k, double[] to, int at) {
        int[] weight = new int[9];
        NodePath.weights(path(node), weight);
        for (int a = 0; a < 3; a++) {
            double sum = 0;
            for (int j = 0; j < 3; j++) {
                sum += (double) weight[3 * k + j] / NodePath.ONE * faces.sceneCorner(face(node), j, a);
            }
            to[at + a] = sum;
        }
    }

    /** Number of the split that divided an inner node; 0 in the initial mesh. */
    public int dividedWith(int node) {
        return points.made(corner(child(node) + 3, 0));
    }

    public boolean isElement(int node) {
        return child(node) < 0;
    }

    /** Whether a node has one vertex at its middle for all three corners; a split gives it three vertices. */
    public boolean isPoint(int node) {
        return corner(node, 0) == corner(node, 1);
    }

    /** Area of a node outside of solids that no other face covers, in squared scene sizes. */
    public double area(int node) {
        return faces.exposedArea(face(node)) / (1L << 2 * level(node));
    }

    /** Exitance E, mean over a node, W/m². */
    public double exitance(int node, int channel) {
        return faces.exitance(face(node), mapPath(node), channel);
    }

    /** Reflectance rho, mean over a node, in [0, 1). */
    public double reflectance(int node, int channel) {
        return faces.reflectance(face(node), mapPath(node), channel);
    }

    /** Path of a node where its face has varying materials; else the path of the face, which costs nothing to find. */
    private long mapPath(int node) {
        return faces.isMapped(face(node)) ? path(node) : NodePath.FACE;
    }
}
