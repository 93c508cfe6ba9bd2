package radiosity.mesh;

import java.util.Arrays;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.mesh.face.Subdivision;

/**
 * The elements below a node, by value, and a radiosity at the corners of each.
 *
 * @param face      face on which it lies
 * @param path      its top node below the face, see {@link NodePath}
 * @param child     1 per node, breadth first: first of four consecutive children, or -1
 * @param radiosity 3 x channels per node, corner by corner; 0 for inner nodes. Empty where it is left out. W/m²
 */
public record PatchTree(int face, long path, int[] child, double[] radiosity) {

    /** A quantity at the corners of an element: puts 3 x channels, corner by corner, from a place on. */
    public interface Quantity {
        void put(int element, double[] values, int at);
    }

    /** Of its radiosity. */
    public int channels() {
        return radiosity.length / (3 * child.length);
    }

    /** A copy of the elements below a node. */
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

    /** Nothing, on an element. */
    public static PatchTree none(int face, long path, int channels) {
        return new PatchTree(face, path, new int[] {-1}, new double[3 * channels]);
    }

    /**
     * The same radiosity on the elements of a tree that goes as deep or deeper, as {@link RadiosityNodes#split} would
     * leave it.
     *
     * @param into as {@link #child}
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

    /** @param here at the corners, where this tree goes no deeper; else null */
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

    /** The sum of this and another one below the same node, on the elements of both. */
    public PatchTree plus(PatchTree other) {
        int[] both = Arrays.equals(child, other.child) ? child : ofBoth(child, other.child);
        double[] sum = divided(both).radiosity.clone();
        double[] added = other.divided(both).radiosity;
        for (int i = 0; i < sum.length; i++) {
            sum[i] += added[i];
        }
        return new PatchTree(face, path, both, sum);
    }

    /** A tree that goes as deep as the deeper one of two everywhere, as {@link #child}. */
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
     * Adds to what the elements below a node have shot; they may have been subdivided deeper than this tree is.
     *
     * @param top the node of this name, or one below it
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

    /** @param values 3 x channels at the corners, where this tree goes no deeper; else null */
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
     * Radiosity times area summed over the elements, per channel, of the scene's squared size; added to {@code sum}.
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

    /** Mean radiosity below a node, per channel; added to {@code mean}. */
    public void addMean(int node, double share, double[] mean) {
        for (int k = 0; k < 4 && child[node] >= 0; k++) {
            addMean(child[node] + k, share / 4, mean);
        }
        for (int i = 0; i < 3 * mean.length && child[node] < 0; i++) {
            mean[i % mean.length] += share / 3 * radiosity[3 * mean.length * node + i];
        }
    }
}
