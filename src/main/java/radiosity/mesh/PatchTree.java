package radiosity.mesh;

import java.util.Arrays;
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
        int[] order = breadthFirst(nodes, top);
        int channels = nodes.channels();
        int[] below = new int[order.length];
        double[] values = new double[3 * channels * order.length];
        int next = 1;
        for (int i = 0; i < order.length; i++) {
            below[i] = -1;
            if (!nodes.isElement(order[i])) {
                below[i] = next;
                next += 4;
                continue;
            }
            quantity.put(order[i], values, 3 * channels * i);
        }
        return new PatchTree(nodes.face(top), nodes.path(top), below, values);
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
        divide(0, null, into, 0, values, perNode);
        return new PatchTree(face, path, into, values);
    }

    /** @param here values at the corners where this tree goes no deeper, n entries; else null */
    private void divide(int i, double[] here, int[] into, int j, double[] values, int n) {
        double[] now = here == null && child[i] < 0 ? ofElement(i, n) : here;
        if (into[j] < 0) {
            if (now == null) {
                throw new IllegalArgumentException("tree: expected as many levels as before, got fewer");
            }
            System.arraycopy(now, 0, values, n * j, n);
            return;
        }
        for (int k = 0; k < 4; k++) {
            divide(now == null ? child[i] + k : i, now == null ? null : Subdivision.values(now, n / 3, k), into,
                    into[j] + k, values, n);
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

    private static int[] breadthFirst(RadiosityNodes nodes, int top) {
        int[] order = new int[size(nodes, top)];
        order[0] = top;
        int end = 1;
        for (int i = 0; i < end; i++) {
            for (int k = 0; k < 4 && !nodes.isElement(order[i]); k++) {
                order[end++] = nodes.child(order[i]) + k;
            }
        }
        return order;
    }

    private static int size(RadiosityNodes nodes, int top) {
        int n = 1;
        for (int k = 0; k < 4 && !nodes.isElement(top); k++) {
            n += size(nodes, nodes.child(top) + k);
        }
        return n;
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
        addShot(nodes, top, at, values);
    }

    private double[] ofElement(int i, int n) {
        return Arrays.copyOfRange(radiosity, n * i, n * i + n);
    }

    /** @param values 3 x channels at the corners where this tree goes no deeper; else null */
    private void addShot(RadiosityNodes nodes, int node, int i, double[] values) {
        int n = 3 * nodes.channels();
        boolean ends = values == null && child[i] < 0;
        double[] here = ends ? ofElement(i, n) : values;
        if (nodes.isElement(node)) {
            ElementLight light = nodes.light();
            for (int j = 0; j < n; j++) {
                int k = j / nodes.channels();
                int c = j % nodes.channels();
                light.setShot(node, k, c, light.shot(node, k, c) + here[j]);
            }
            return;
        }
        for (int k = 0; k < 4; k++) {
            addShot(nodes, nodes.child(node) + k, here == null ? child[i] + k : i,
                    here == null ? null : Subdivision.values(here, nodes.channels(), k));
        }
    }

    /**
     * Adds this tree's flux per channel, radiosity times area summed over elements, to {@code sum}; W/m² times squared
     * scene size.
     */
    public void addFlux(Faces faces, double[] sum) {
        add(0, faces.area(face) / (1L << 2 * NodePath.level(path)), sum);
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
