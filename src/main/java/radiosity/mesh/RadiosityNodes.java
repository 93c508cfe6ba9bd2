package radiosity.mesh;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.mesh.face.Subdivision;
import radiosity.util.ArraySize;

/**
 * The patch trees of some blocks and their light, in arrays (section 4.5.7 of the paper); a node is an index.
 *
 * <p>Leaves are the elements. Each refers to three vertices; light arrives at vertices, and what an element has shot
 * is kept at its own corners. Between corners both are linear. A patch is a leaf of the initial mesh: whatever is
 * subdivided later lies below one.
 */
public final class RadiosityNodes {

    private final Patcher patcher;
    private final Faces faces;
    private final int channels;
    private final ReceivingPoints points;

    private final NodeTree tree;
    private final ElementLight light;
    /** Leaves of the initial mesh. */
    private final int[] patches;
    private int patchCount;
    /** For whoever divides nodes: modified. */
    private final int[] weights = new int[9];

    /** Makes the initial mesh of some blocks. */
    public RadiosityNodes(Patcher patcher, List<Block> blocks) {
        this.patcher = patcher;
        faces = patcher.faces();
        channels = faces.channels();
        points = new ReceivingPoints(patcher);
        long tops = 0;
        long leaves = 0;
        for (Block block : blocks) {
            tops += block.face().length;
            for (int i = 0; i < block.face().length; i++) {
                leaves += 1L << 2 * (patcher.level(block.face()[i]) - NodePath.level(block.path()[i]));
            }
        }
        ElementLight.size(channels, leaves);
        tree = new NodeTree((int) tops, (int) Math.min(ArraySize.MOST, (4 * leaves - tops) / 3));
        patches = new int[(int) leaves];
        for (Block block : blocks) {
            for (int i = 0; i < block.face().length; i++) {
                plant(block.face()[i], block.path()[i]);
            }
        }
        points.trim();
        light = new ElementLight(this, tree, points);
    }

    private void plant(int f, long top) {
        float[] at = new float[9];
        for (int k = 0; k < 9; k++) {
            at[k] = faces.corner(f, k / 3, k % 3);
        }
        for (int level = 1; level <= NodePath.level(top); level++) {
            Subdivision.descend(at, NodePath.step(top, level));
        }
        NodePath.weights(top, weights);
        int node = tree.addRoot(f, top);
        int depth = patcher.level(f);
        for (int k = 0; k < 3; k++) {
            tree.setCorner(node, k, patcher.isPoint(f) ? points.middle(f, at)
                    : points.vertex(f, weights, 3 * k, depth, at, 3 * k, 0));
        }
        grow(node, depth);
    }

    private void grow(int node, int depth) {
        if (tree.level(node) == depth) {
            patches[patchCount++] = node;
            return;
        }
        int first = divide(node, depth, 0);
        for (int k = 0; k < 4; k++) {
            grow(first + k, depth);
        }
    }

    /**
     * Divides an element in four (section 2.5). What its new corners had received and shot is what stood there before.
     *
     * @param with new vertices are shared with those of all splits of the same number, above 0
     * @return the first of the four
     */
    public int split(int node, int with) {
        int first = divide(node, tree.level(node) + 1, with);
        light.divide(node, first);
        return first;
    }

    /**
     * To be called before splits with a number that there was none with: nobody asks for other shared vertices again.
     *
     * @param expected how many splits, about
     */
    public void beginSplits(int expected) {
        points.forget();
        tree.expect(expected);
        light.expect(expected);
    }

    private int divide(int node, int depth, int with) {
        NodePath.weights(tree.path(node), weights);
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
        int first = tree.addChildren(node);
        for (int k = 0; k < 3; k++) {
            tree.setCorner(first + k, k, corner(node, k));
            tree.setCorner(first + k, (k + 1) % 3, mid[(k + 2) % 3]);
            tree.setCorner(first + k, (k + 2) % 3, mid[(k + 1) % 3]);
            tree.setCorner(first + 3, k, mid[k]);
        }
        return first;
    }

    /** Gives a node that received at its middle only a vertex at each corner; the one in its middle rests. */
    private void giveCorners(int node, int depth, int with) {
        int middle = corner(node, 0);
        for (int k = 0; k < 3; k++) {
            tree.setCorner(node, k, points.cornerInsteadOf(middle, face(node), weights, 3 * k, depth, with));
        }
        points.bury(middle);
    }

    /*---- What is there ----*/

    public Faces faces() {
        return faces;
    }

    public int channels() {
        return channels;
    }

    public ElementLight light() {
        return light;
    }

    /** Number of nodes, inner ones and elements. */
    public int nodes() {
        return tree.count();
    }

    /** Number of leaves. */
    public int elements() {
        return tree.elements();
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

    /** Levels between a node and the patch that it lies below. */
    int depthBelowPatch(int node) {
        return tree.level(node) - patcher.level(face(node));
    }

    /** The top nodes of all blocks, in their order. */
    public int[] tops() {
        return tree.roots();
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
     * Where corner k of a node lies in the scene; any number of threads may ask.
     *
     * @param to modified: x, y, z in scene units, 3 from {@code at}
     */
    public void position(int node, int k, double[] to, int at) {
        int[] weight = new int[9];
        NodePath.weights(tree.path(node), weight);
        for (int a = 0; a < 3; a++) {
            double sum = 0;
            for (int j = 0; j < 3; j++) {
                sum += (double) weight[3 * k + j] / NodePath.ONE * faces.sceneCorner(face(node), j, a);
            }
            to[at + a] = sum;
        }
    }

    /** The node of this name, or -1. */
    public int find(int onFace, long atPath) {
        return tree.find(onFace, atPath);
    }

    public int face(int node) {
        return tree.face(node);
    }

    public long path(int node) {
        return tree.path(node);
    }

    /** What a node is a part of, or -1. */
    public int parent(int node) {
        return tree.parent(node);
    }

    /** First of four consecutive children, or -1. */
    public int child(int node) {
        return tree.child(node);
    }

    /** Number under which an inner node was divided; 0 in the initial mesh. */
    public int dividedWith(int node) {
        return points.made(corner(child(node) + 3, 0));
    }

    public boolean isElement(int node) {
        return tree.child(node) < 0;
    }

    /** Whether all corners of a node are one vertex, in its middle; once it is split it has three. */
    public boolean isPoint(int node) {
        return corner(node, 0) == corner(node, 1);
    }

    /** Vertex at corner k of a node. */
    public int corner(int node, int k) {
        return tree.corner(node, k);
    }

    /** Area of a node, of the scene's squared size. */
    public double area(int node) {
        return faces.area(face(node)) / (1L << 2 * tree.level(node));
    }

    /** Receiving points, 3 per vertex; not to be modified. */
    public float[] receivers() {
        return points.receivers();
    }

    /** A face on which a vertex lies, or next to it: the same whichever of its faces the vertex was made for. */
    public int vertexFace(int vertex) {
        return points.face(vertex);
    }

    /** The face in whose plane a vertex receives, as {@link #vertexFace} the same for all. */
    public int vertexPlane(int vertex) {
        return points.plane(vertex);
    }

    /** What a vertex is, whoever owns it. */
    public long vertexKey(int vertex) {
        return points.key(vertex);
    }

    /** Number of the split that made a vertex; 0 in the initial mesh. */
    public int made(int vertex) {
        return points.made(vertex);
    }

    /** The vertices that were made by splits of this number. */
    public int[] verticesMade(int with) {
        return points.madeBy(with);
    }

    /** Sets aside what all vertices have received: they have received nothing then, and gather anew. */
    public void setAside() {
        points.setAside();
    }

    /**
     * All vertices have gathered anew: that is averaged with what is set aside, unless this is negative.
     *
     * @param anew weight of what was gathered anew, in (0, 1]
     */
    public void averageAside(double anew) {
        points.averageAside(anew);
    }

    /** Whether vertices gather anew, and what they had received before is set aside. */
    public boolean isSetAside() {
        return points.isSetAside();
    }

    /** Irradiance of a vertex that is shown: what was set aside, else what it has received, W/m². */
    public double shown(int vertex, int channel) {
        return points.shown(vertex, channel);
    }

    /** For whoever restores what was saved: the irradiance of a vertex that is set aside, W/m². */
    public void setAside(int vertex, int channel, double irradiance) {
        points.setAside(vertex, channel, irradiance);
    }

    public boolean isBuried(int vertex) {
        return points.isBuried(vertex);
    }

    public void bury(int vertex) {
        points.bury(vertex);
    }

    /** E in W/m², in the mean over a node. */
    public double exitance(int node, int channel) {
        return faces.exitance(face(node), mapPath(node), channel);
    }

    /** rho in [0, 1), in the mean over a node. */
    public double reflectance(int node, int channel) {
        return faces.reflectance(face(node), mapPath(node), channel);
    }

    /** Where a node lies, if that matters for how it looks. */
    private long mapPath(int node) {
        return faces.isMapped(face(node)) ? tree.path(node) : NodePath.FACE;
    }
}
