package radiosity.world;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.Arrays;
import radiosity.formfactor.Shooter;
import radiosity.patch.Faces;
import radiosity.patch.Path;
import radiosity.patch.RadiosityNodes;
import radiosity.patch.Subdivision;

/**
 * One patch shooting: which node, the tree of elements below it, and the unshot radiosity at their corners. What goes
 * over the wire, into the journal and into the scene file is this same record.
 *
 * @param face      face on which the patch lies
 * @param path      its node below the face
 * @param child     1 per node of its tree, breadth first: first of four consecutive children, or -1
 * @param radiosity 3 x channels per node, corner by corner; 0 for inner nodes. W/m²
 * @param flux      sum of |U| A over elements and channels, W
 */
record Shot(int face, long path, int[] child, double[] radiosity, double flux) implements Comparable<Shot> {

    /** What a patch has to shoot. */
    static Shot of(RadiosityNodes nodes, int patch, double flux) {
        return of(nodes, patch, flux, nodes::unshot);
    }

    /** What a patch has ever shot. */
    static Shot total(RadiosityNodes nodes, int patch) {
        return of(nodes, patch, 0, nodes::shot);
    }

    /** A quantity at corner k of an element. */
    interface Quantity {
        double at(int node, int k, int channel);
    }

    static Shot of(RadiosityNodes nodes, int patch, double flux, Quantity quantity) {
        int[] order = breadthFirst(nodes, patch);
        int[] child = new int[order.length];
        int channels = nodes.channels();
        double[] radiosity = new double[3 * channels * order.length];
        int next = 1;
        for (int i = 0; i < order.length; i++) {
            child[i] = -1;
            if (!nodes.isElement(order[i])) {
                child[i] = next;
                next += 4;
                continue;
            }
            for (int k = 0; k < 3; k++) {
                for (int c = 0; c < channels; c++) {
                    radiosity[channels * (3 * i + k) + c] = quantity.at(order[i], k, c);
                }
            }
        }
        return new Shot(nodes.face(patch), nodes.path(patch), child, radiosity, flux);
    }

    /** Adds what a patch shoots to what it has shot; the patch may have been subdivided further since. */
    void markShot(RadiosityNodes nodes, int patch) {
        mark(nodes, patch, 0, null);
    }

    /** @param values 3 x channels at the corners, where this tree goes no deeper; else null */
    private void mark(RadiosityNodes nodes, int node, int i, double[] values) {
        int n = 3 * nodes.channels();
        double[] here = values != null || child[i] >= 0 ? values : Arrays.copyOfRange(radiosity, n * i, n * i + n);
        if (nodes.isElement(node)) {
            for (int j = 0; j < n; j++) {
                nodes.shot()[n * node + j] += here[j];
            }
            return;
        }
        for (int k = 0; k < 4; k++) {
            mark(nodes, nodes.child(node) + k, here == null ? child[i] + k : i,
                    here == null ? null : Subdivision.values(here, nodes.channels(), k));
        }
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

    /** @param weight one per channel, see {@link Shooter} */
    Shooter shooter(Faces faces, double[] weight) {
        return new Shooter(faces, face, path, child, radiosity, weight);
    }

    /** U A summed over the elements, one per channel, of the scene's squared size; signed. */
    double[] flux(Faces faces) {
        double[] sum = new double[faces.channels()];
        add(0, faces.area(face) / (1L << 2 * Path.level(path)), sum);
        return sum;
    }

    private void add(int node, double area, double[] sum) {
        for (int k = 0; k < 4 && child[node] >= 0; k++) {
            add(child[node] + k, area / 4, sum);
        }
        for (int i = 0; i < 3 * sum.length && child[node] < 0; i++) {
            sum[i % sum.length] += radiosity[3 * sum.length * node + i] * area / 3;
        }
    }

    /** Most flux first; what is equal, by id. */
    @Override
    public int compareTo(Shot other) {
        int order = Double.compare(other.flux, flux);
        order = order != 0 ? order : Integer.compare(face, other.face);
        return order != 0 ? order : Long.compare(path, other.path);
    }

    void write(DataOutput out) throws IOException {
        out.writeInt(face);
        out.writeLong(path);
        out.writeInt(child.length);
        for (int c : child) {
            out.writeInt(c);
        }
        out.writeInt(radiosity.length);
        for (double u : radiosity) {
            out.writeDouble(u);
        }
        out.writeDouble(flux);
    }

    static Shot read(DataInput in) throws IOException {
        int face = in.readInt();
        long path = in.readLong();
        int[] child = new int[in.readInt()];
        for (int i = 0; i < child.length; i++) {
            child[i] = in.readInt();
        }
        double[] radiosity = new double[in.readInt()];
        for (int i = 0; i < radiosity.length; i++) {
            radiosity[i] = in.readDouble();
        }
        return new Shot(face, path, child, radiosity, in.readDouble());
    }
}
