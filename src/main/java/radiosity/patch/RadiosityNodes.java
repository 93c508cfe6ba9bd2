package radiosity.patch;

import java.util.Arrays;
import java.util.List;

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

    private int nodes;
    private int elements;
    /** 1 per node. */
    private int[] face = new int[64];
    /** 1 per node, see {@link Path}. */
    private long[] path = new long[64];
    /** 1 per node: what it is a part of, or -1. */
    private int[] parent = new int[64];
    /** 1 per node: first of four consecutive children, or -1. */
    private int[] child = new int[64];
    /** 1 per node: with which others it shares vertices; 0 in the initial mesh. */
    private int[] share = new int[64];
    /** 3 per node: vertices. */
    private int[] corner = new int[3 * 64];
    /** 3 x channels per node: radiosity S that has been shot at each corner; of leaves only. W/m². */
    private double[] shot;

    private final Roots roots;
    private int[] patches = new int[64];
    private int patchCount;
    private final int[] weights = new int[9];

    /** Makes the initial mesh of some blocks. */
    public RadiosityNodes(Patcher patcher, List<Block> blocks) {
        this.patcher = patcher;
        faces = patcher.faces();
        channels = faces.channels();
        shot = new double[3 * channels * 64];
        points = new ReceivingPoints(patcher);
        roots = new Roots(blocks.stream().mapToInt(block -> block.face().length).sum());
        for (Block block : blocks) {
            for (int i = 0; i < block.face().length; i++) {
                plant(block.face()[i], block.path()[i]);
            }
        }
    }

    private void plant(int f, long top) {
        float[] at = new float[9];
        for (int k = 0; k < 9; k++) {
            at[k] = faces.corner(f, k / 3, k % 3);
        }
        for (int level = 1; level <= Path.level(top); level++) {
            Subdivision.descend(at, Path.step(top, level));
        }
        Path.weights(top, weights);
        int node = addNode(f, top, -1, 0);
        int depth = patcher.level(f);
        for (int k = 0; k < 3; k++) {
            corner[3 * node + k] = patcher.isPoint(f) ? points.middle(f, at)
                    : points.vertex(f, weights, 3 * k, depth, at, 3 * k, 0);
        }
        elements++;
        roots.add(f, top, node);
        grow(node, depth);
    }

    private void grow(int node, int depth) {
        if (Path.level(path[node]) == depth) {
            if (patchCount == patches.length) {
                patches = Arrays.copyOf(patches, 2 * patchCount);
            }
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
        return divide(node, Path.level(path[node]) + 1, with);
    }

    private int divide(int node, int depth, int with) {
        int[] w = new int[9];
        Path.weights(path[node], w);
        int[] mid = new int[3];
        for (int k = 0; k < 3; k++) {
            int p = (k + 1) % 3;
            int q = (k + 2) % 3;
            int[] between = new int[3];
            for (int a = 0; a < 3; a++) {
                between[a] = (w[3 * p + a] + w[3 * q + a]) >> 1;
            }
            mid[k] = points.between(corner[3 * node + p], corner[3 * node + q], face[node], between, depth, with);
        }
        int first = nodes;
        for (int k = 0; k < 4; k++) {
            addNode(face[node], Path.child(path[node], k), node, with);
        }
        for (int k = 0; k < 3; k++) {
            int c = 3 * (first + k);
            corner[c + k] = corner[3 * node + k];
            corner[c + (k + 1) % 3] = mid[(k + 2) % 3];
            corner[c + (k + 2) % 3] = mid[(k + 1) % 3];
            corner[3 * (first + 3) + k] = mid[k];
        }
        Subdivision.shareShot(shot, channels, node, first);
        child[node] = first;
        elements += 3;
        return first;
    }

    private int addNode(int f, long where, int under, int with) {
        if (nodes == face.length) {
            int more = nodes + nodes / 2;
            face = Arrays.copyOf(face, more);
            path = Arrays.copyOf(path, more);
            parent = Arrays.copyOf(parent, more);
            child = Arrays.copyOf(child, more);
            share = Arrays.copyOf(share, more);
            corner = Arrays.copyOf(corner, 3 * more);
            shot = Arrays.copyOf(shot, 3 * channels * more);
        }
        face[nodes] = f;
        path[nodes] = where;
        share[nodes] = with;
        parent[nodes] = under;
        child[nodes] = -1;
        return nodes++;
    }

    /*---- What is there ----*/

    public Faces faces() {
        return faces;
    }

    public int channels() {
        return channels;
    }

    /** Number of nodes, inner ones and elements. */
    public int nodes() {
        return nodes;
    }

    /** Number of leaves. */
    public int elements() {
        return elements;
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
        return Path.level(path[node]) - patcher.level(face[node]);
    }

    /** The top nodes of all blocks, in their order. */
    public int[] tops() {
        return roots.all();
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
     * Where corner k of a node lies in the scene.
     *
     * @param to modified: x, y, z in scene units, 3 from {@code at}
     */
    public void position(int node, int k, double[] to, int at) {
        Path.weights(path[node], weights);
        for (int a = 0; a < 3; a++) {
            double sum = 0;
            for (int j = 0; j < 3; j++) {
                sum += (double) weights[3 * k + j] / Path.ONE * faces.sceneCorner(face[node], j, a);
            }
            to[at + a] = sum;
        }
    }

    /** The node of this name, or -1. */
    public int find(int onFace, long atPath) {
        int levels = Path.level(atPath);
        int up = levels;
        int node = roots.find(onFace, atPath);
        while (node < 0 && up > 0) {
            up--;
            node = roots.find(onFace, atPath >> 2 * (levels - up));
        }
        for (int level = up + 1; level <= levels && node >= 0; level++) {
            node = child[node] < 0 ? -1 : child[node] + Path.step(atPath, level);
        }
        return node;
    }

    public int face(int node) {
        return face[node];
    }

    public long path(int node) {
        return path[node];
    }

    /** What a node is a part of, or -1. */
    public int parent(int node) {
        return parent[node];
    }

    /** First of four consecutive children, or -1. */
    public int child(int node) {
        return child[node];
    }

    /** With which splits a node shares vertices; 0 in the initial mesh. */
    public int share(int node) {
        return share[node];
    }

    public boolean isElement(int node) {
        return child[node] < 0;
    }

    /** Whether all corners of a node are one vertex, in its middle; it is not to be split. */
    public boolean isPoint(int node) {
        return corner[3 * node] == corner[3 * node + 1];
    }

    /** Vertex at corner k of a node. */
    public int corner(int node, int k) {
        return corner[3 * node + k];
    }

    /** Area of a node, of the scene's squared size. */
    public double area(int node) {
        return faces.area(face[node]) / (1L << 2 * Path.level(path[node]));
    }

    /** Receiving points, 3 per vertex; not to be modified. */
    public float[] receivers() {
        return points.receivers();
    }

    /** The face on which a vertex lies. */
    public int vertexFace(int vertex) {
        return points.face(vertex);
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

    public boolean isBuried(int vertex) {
        return points.isBuried(vertex);
    }

    public void bury(int vertex) {
        points.bury(vertex);
    }

    /** H, channels per vertex, W/m²; whoever owns the tree adds to it. */
    public double[] irradiance() {
        return points.irradiance();
    }

    /** S, 3 x channels per node (meaningful for leaves), W/m²; whoever owns the tree adds to it. */
    public double[] shot() {
        return shot;
    }

    /** Irradiance H at corner k of an element, W/m²: that of its vertex, or the mean of the others if it is buried. */
    public double irradiance(int node, int k, int channel) {
        if (!points.isBuried(corner[3 * node + k])) {
            return arrived(corner[3 * node + k], channel);
        }
        double sum = 0;
        int seen = 0;
        for (int j = 0; j < 3; j++) {
            int v = corner[3 * node + j];
            if (!points.isBuried(v)) {
                sum += arrived(v, channel);
                seen++;
            }
        }
        return seen == 0 ? 0 : sum / seen;
    }

    /**
     * By how much the mean of H over an element exceeds that of its corners, W/m²: where light is curved, straight
     * lines between vertices lose some.
     *
     * <p>Seen from its parent (L. F. Richardson, The deferred approach to the limit, 1927): an edge of half the length
     * bulges a quarter as much, and the mean over a parabolic triangle is a third of the sum of its edges' bulges.
     */
    public double bulge(int node, int channel) {
        double sum = 0;
        for (int k = 0; k < 3 && parent[node] >= 0; k++) {
            sum += bulge(parent[node], k, channel);
        }
        return sum / 12;
    }

    /** H at the middle of the edge opposite corner k of an inner node less the mean of the edge's ends, W/m². */
    private double bulge(int node, int k, int channel) {
        int p = corner[3 * node + (k + 1) % 3];
        int q = corner[3 * node + (k + 2) % 3];
        int middle = corner[3 * (child[node] + 3) + k];
        if (points.isBuried(p) || points.isBuried(q) || points.isBuried(middle)) {
            return 0;
        }
        return arrived(middle, channel) - 0.5 * (arrived(p, channel) + arrived(q, channel));
    }

    private double arrived(int vertex, int channel) {
        return points.irradiance()[channels * vertex + channel];
    }

    /** E in W/m², in the mean over a node. */
    public double exitance(int node, int channel) {
        return faces.exitance(face[node], path[node], channel);
    }

    /** rho in [0, 1), in the mean over a node. */
    public double reflectance(int node, int channel) {
        return faces.reflectance(face[node], path[node], channel);
    }

    /** Radiosity B = E + rho H (equation 1) at corner k of an element, W/m². */
    public double radiosity(int node, int k, int channel) {
        return exitance(node, channel) + reflectance(node, channel) * irradiance(node, k, channel);
    }

    /** Radiosity S that was shot at corner k of an element, W/m². */
    public double shot(int node, int k, int channel) {
        return shot[channels * (3 * node + k) + channel];
    }

    /** Unshot radiosity U = B - S, the element's bulge included, at corner k of an element, W/m²; signed. */
    public double unshot(int node, int k, int channel) {
        return radiosity(node, k, channel) - shot(node, k, channel)
                + reflectance(node, channel) * bulge(node, channel);
    }
}
