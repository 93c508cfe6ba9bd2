package radiosity.mesh;

import java.util.Arrays;
import java.util.Queue;
import java.util.function.IntUnaryOperator;
import java.util.function.ObjIntConsumer;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.mesh.face.Subdivision;

/**
 * A copy of the elements below a node, with a radiosity at the corners of each element.
 *
 * @param face      face on which the node lies
 * @param path      path of the node below its face, see {@link NodePath}
 * @param child     1 per node, breadth first: first of four consecutive children, or -1
 * @param radiosity 3 x channels per node, corner by corner, W/m²; 0 for inner nodes. Empty where it is left out
 */
public record PatchTree(int face, long path, int[] child, double[] radiosity) {

    /** A quantity at the corners of an element: writes 3 x channels values, corner by corner, from an index on. */
    public interface Quantity {
        void put(int element, double[] values, int at);
    }

    /** Number of channels of the radiosity; 0 where the radiosity is empty. */
    public int channels() {
        return radiosity.length / (3 * child.length);
    }

    /** Copies the elements below a node and their values of a quantity. */
    public static PatchTree of(RadiosityNodes nodes, int top, Quantity quantity) {
        return of(nodes.face(top), nodes.path(top), top, nodes::child, 3 * nodes.channels(), quantity);
    }

    /**
     * Copies the elements below a node of any tree and their values of a quantity.
     *
     * @param children first of four consecutive children of a node of the other tree, or -1
     * @param n        values per element
     */
    static PatchTree of(int face, long path, int top, IntUnaryOperator children, int n, Quantity quantity) {
        int[] node = new int[size(top, children)];
        int[] below = new int[node.length];
        double[] values = new double[n * node.length];
        node[0] = top;
        for (int i = 0, next = 1; i < node.length; i++) {
            int first = children.applyAsInt(node[i]);
            below[i] = first < 0 ? -1 : next;
            for (int k = 0; k < 4 && first >= 0; k++) {
                node[next++] = first + k;
            }
            if (first < 0) {
                quantity.put(node[i], values, n * i);
            }
        }
        return new PatchTree(face, path, below, values);
    }

    private static int size(int node, IntUnaryOperator children) {
        int first = children.applyAsInt(node);
        int size = 1;
        for (int k = 0; k < 4 && first >= 0; k++) {
            size += size(first + k, children);
        }
        return size;
    }

    /**
     * This tree cut off at a level below its face; every element gets its mean radiosity at all corners.
     *
     * @param level levels below the face; a tree with a deeper top keeps its top only
     */
    public PatchTree mean(int level) {
        int[] levels = levels();
        int channels = channels();
        return of(face, path, 0, i -> levels[i] < level ? child[i] : -1, 3 * channels, (i, values, at) -> {
            double[] mean = new double[channels];
            addMean(i, 1, mean);
            for (int k = 0; k < 3; k++) {
                System.arraycopy(mean, 0, values, at + channels * k, channels);
            }
        });
    }

    /**
     * The same radiosity, to the last bit, on as few elements as possible: four siblings with radiosity linear over
     * their parent are merged.
     *
     * @param level siblings whose parent lies above this level below the face are not merged
     */
    public PatchTree pruned(int level) {
        int[] levels = levels();
        int[] kept = child.clone();
        double[] values = radiosity.clone();
        int n = channels();
        for (int i = kept.length - 1; i >= 0; i--) {
            if (kept[i] >= 0 && levels[i] >= level && isLinear(kept, values, kept[i])) {
                for (int k = 0; k < 3; k++) {
                    System.arraycopy(values, n * (3 * (kept[i] + k) + k), values, n * (3 * i + k), n);
                }
                kept[i] = -1;
            }
        }
        return Arrays.equals(kept, child) ? this : of(face, path, kept, values);
    }

    /** The tree of some nodes that may be in another order; those that are not reached from node 0 are left out. */
    private static PatchTree of(int face, long path, int[] child, double[] radiosity) {
        int n = radiosity.length / child.length;
        return of(face, path, 0, i -> child[i], n,
                (i, values, at) -> System.arraycopy(radiosity, n * i, values, at, n));
    }

    /**
     * Whether four consecutive nodes are elements whose radiosity at the middles of their parent's edges is the exact
     * mean of the values at the ends of these edges.
     */
    private static boolean isLinear(int[] child, double[] values, int first) {
        int n = values.length / (3 * child.length);
        boolean isLinear = Math.max(Math.max(child[first], child[first + 1]),
                Math.max(child[first + 2], child[first + 3])) < 0;
        for (int i = 0; i < 3 * n && isLinear; i++) {
            int k = i / n;
            int p = (k + 1) % 3;
            int q = (k + 2) % 3;
            int atP = n * 3 * (first + p) + i % n;
            int atQ = n * 3 * (first + q) + i % n;
            double middle = 0.5 * (values[atP + n * p] + values[atQ + n * q]);
            isLinear = values[n * (3 * (first + 3) + k) + i % n] == middle && values[atP + n * q] == middle
                    && values[atQ + n * p] == middle;
        }
        return isLinear;
    }

    /**
     * Joins the patch trees of all subtrees below a node to the tree of the node.
     *
     * @param parts modified: patch trees in depth-first order; the parts of the node are removed from the head
     * @throws IllegalArgumentException where the head of the queue does not hold all parts of the node
     */
    public static PatchTree joined(int face, long path, Queue<PatchTree> parts) {
        PatchTree next = parts.peek();
        if (next == null || next.face != face || NodePath.level(next.path) < NodePath.level(path)) {
            throw new IllegalArgumentException("trees: expected all parts of " + face + " " + path + ", got " + next);
        }
        if (next.path == path) {
            return parts.remove();
        }
        PatchTree[] part = new PatchTree[4];
        int size = 1;
        for (int k = 0; k < 4; k++) {
            part[k] = joined(face, NodePath.child(path, k), parts);
            size += part[k].child.length;
        }
        int n = part[0].radiosity.length / part[0].child.length;
        int[] child = new int[size];
        double[] radiosity = new double[n * size];
        child[0] = 1;
        for (int k = 0, before = 4; k < 4; before += part[k].child.length - 1, k++) {
            for (int j = 0; j < part[k].child.length; j++) {
                int i = j == 0 ? 1 + k : before + j; // the tops of the parts are consecutive
                child[i] = part[k].child[j] < 0 ? -1 : before + part[k].child[j];
                System.arraycopy(part[k].radiosity, n * j, radiosity, n * i, n);
            }
        }
        return of(face, path, child, radiosity);
    }

    /** 1 per node: levels below the face. */
    private int[] levels() {
        int[] levels = new int[child.length];
        levels[0] = NodePath.level(path);
        for (int i = 0; i < levels.length; i++) {
            if (child[i] >= 0) {
                Arrays.fill(levels, child[i], child[i] + 4, levels[i] + 1);
            }
        }
        return levels;
    }

    /** A tree that consists of one element with radiosity 0. */
    public static PatchTree none(int face, long path, int channels) {
        return new PatchTree(face, path, new int[] {-1}, new double[3 * channels]);
    }

    /**
     * The same radiosity on the elements of a deeper tree, interpolated as {@link RadiosityNodes#split} does.
     *
     * @param into children of the nodes of the deeper tree, as {@link #child}; not modified, kept
     * @throws IllegalArgumentException where the other tree is less deep somewhere
     */
    public PatchTree divided(int[] into) {
        if (Arrays.equals(child, into)) {
            return this;
        }
        int perNode = radiosity.length / child.length;
        double[] values = new double[perNode * into.length];
        interpolate(0, null, perNode, j -> into[j], 0,
                (here, j) -> System.arraycopy(here, 0, values, perNode * j, perNode));
        return new PatchTree(face, path, into, values);
    }

    /**
     * Interpolates the radiosity at the corners of the elements of a deeper tree.
     *
     * @param here     values at the corners of node i where this tree goes no deeper, n entries; else null
     * @param children first of four consecutive children of a node of the deeper tree, or -1
     * @param j        node of the deeper tree in the place of node i
     * @param to       receives n values, corner by corner, and their element of the deeper tree
     */
    private void interpolate(int i, double[] here, int n, IntUnaryOperator children, int j,
            ObjIntConsumer<double[]> to) {
        double[] now = here == null && child[i] < 0 ? ofElement(i, n) : here;
        int first = children.applyAsInt(j);
        if (first < 0) {
            if (now == null) {
                throw new IllegalArgumentException("tree: expected as many levels as before, got fewer");
            }
            to.accept(now, j);
            return;
        }
        for (int k = 0; k < 4; k++) {
            interpolate(now == null ? child[i] + k : i, now == null ? null : Subdivision.values(now, n / 3, k), n,
                    children, first + k, to);
        }
    }

    /** The sum of two trees with the same top node, on a tree that is everywhere as deep as the deeper of the two. */
    public PatchTree plus(PatchTree other) {
        int[] both = Arrays.equals(child, other.child) ? child : ofBoth(child, other.child);
        double[] sum = divided(both).radiosity.clone();
        double[] added = other.divided(both).radiosity;
        for (int i = 0; i < sum.length; i++) {
            sum[i] += added[i];
        }
        return new PatchTree(face, path, both, sum);
    }

    /** Children of the nodes of the least tree that is everywhere as deep as two others, as {@link #child}. */
    private static int[] ofBoth(int[] a, int[] b) {
        int most = a.length + b.length;
        int[] child = new int[most];
        int[] inA = new int[most];
        int[] inB = new int[most];
        int next = 1;
        for (int i = 0; i < next; i++) {
            int inner = Math.max(below(a, inA[i]), below(b, inB[i]));
            child[i] = inner < 0 ? -1 : next;
            for (int k = 0; k < 4 && inner >= 0; k++, next++) {
                inA[next] = below(a, inA[i]) < 0 ? -1 : a[inA[i]] + k;
                inB[next] = below(b, inB[i]) < 0 ? -1 : b[inB[i]] + k;
            }
        }
        return Arrays.copyOf(child, next);
    }

    private static int below(int[] child, int i) {
        return i < 0 ? -1 : child[i];
    }

    /**
     * Adds this tree's radiosity to the radiosity that elements have shot, interpolated where they are divided deeper.
     *
     * @param top the node with this tree's face and path, or a node below that one
     */
    public void addShot(RadiosityNodes nodes, int top) {
        int at = 0;
        double[] values = null;
        for (int level = NodePath.level(path) + 1; level <= NodePath.level(nodes.path(top)); level++) {
            int k = NodePath.step(nodes.path(top), level);
            if (values == null && child[at] < 0) {
                values = ofElement(at, 3 * nodes.channels());
            }
            values = values == null ? null : Subdivision.values(values, nodes.channels(), k);
            at = values == null ? child[at] + k : at;
        }
        ElementLight light = nodes.light();
        interpolate(at, values, 3 * nodes.channels(), nodes::child, top, (here, node) -> {
            for (int j = 0; j < here.length; j++) {
                int k = j / nodes.channels();
                int c = j % nodes.channels();
                light.setShot(node, k, c, light.shot(node, k, c) + here[j]);
            }
        });
    }

    private double[] ofElement(int i, int n) {
        return Arrays.copyOfRange(radiosity, n * i, n * i + n);
    }

    /**
     * Adds this tree's flux per channel, radiosity times area summed over elements, to {@code sum}; W/m² times squared
     * scene size.
     */
    public void addFlux(Faces faces, double[] sum) {
        add(0, faces.exposedArea(face, path), sum);
    }

    private void add(int node, double area, double[] sum) {
        for (int k = 0; k < 4 && child[node] >= 0; k++) {
            add(child[node] + k, area / 4, sum);
        }
        for (int i = 0; i < 3 * sum.length && child[node] < 0; i++) {
            sum[i % sum.length] += radiosity[3 * sum.length * node + i] * area / 3;
        }
    }

    /** The least radiosity of one channel at any corner of an element, W/m². */
    public double least(int channel) {
        int channels = channels();
        double least = Double.POSITIVE_INFINITY;
        for (int node = 0; node < child.length; node++) {
            for (int k = 0; k < 3 && child[node] < 0; k++) {
                least = Math.min(least, radiosity[channels * (3 * node + k) + channel]);
            }
        }
        return least;
    }

    /** Adds {@code share} times the mean radiosity over a node to {@code mean}: one value per channel, W/m². */
    public void addMean(int node, double share, double[] mean) {
        for (int k = 0; k < 4 && child[node] >= 0; k++) {
            addMean(child[node] + k, share / 4, mean);
        }
        for (int i = 0; i < 3 * mean.length && child[node] < 0; i++) {
            mean[i % mean.length] += share / 3 * radiosity[3 * mean.length * node + i];
        }
    }
}
