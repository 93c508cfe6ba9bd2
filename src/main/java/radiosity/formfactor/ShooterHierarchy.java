package radiosity.formfactor;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.util.Arrays;
import java.util.List;
import radiosity.mesh.PatchTree;
import radiosity.mesh.UniformRadiosity;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.mesh.face.Subdivision;
import radiosity.util.Hash;

/**
 * A patch that shoots, or a cluster of patches: the tree of elements below each, the radiosity of each element
 * (section 4.4 of the paper), and pairs of neighbours above them, ready for being gathered from.
 *
 * <p>A node is a cluster with two children, a triangle with four, or an element. Read by any number of threads.
 * Clusters: B. Smits, J. Arvo, D. Greenberg, A clustering algorithm for radiosity in complex environments, 1994.
 */
public final class ShooterHierarchy {

    private static final VarHandle OPEN = MethodHandles.arrayElementVarHandle(byte[].class);

    final int channels;
    private int nodes;
    /** 1 per node: its face, or -1 for a cluster. */
    final int[] face;
    /** 1 per node, of triangles. */
    private final long[] path;
    /** 1 per node: first of its consecutive children, or -1. */
    final int[] child;
    /** 3 per node, of triangles. */
    final float[] normal;
    /** 9 per node: corners, of triangles. */
    final float[] corner;
    /** 1 per node: what it is, whoever shoots it. */
    final long[] key;
    /** 1 per node: area, of the scene's squared size. */
    final float[] area;
    /** 4 per node: middle, and squared distance from there within which all of it lies. */
    final float[] extent;
    /** 1 per node: mean over the node of the largest channel of weight times |radiosity|. */
    final double[] strength;
    /** Of clusters. */
    final NormalCones cones;
    /** 1 per node, of clusters: what of its flux, counted by strength, its first child shoots. */
    final double[] share;
    /** 3 x channels per node: radiosity to shoot at the corners, of elements. W/m². */
    final double[] radiosity;

    /** 1 per node: not 0 where its parts have been looked at. */
    private final byte[] open;
    private final Faces faces;
    private final List<PatchTree> trees;
    private final Weights weights;
    private final UniformRadiosity ambient;

    /** @param weights what its radiosity counts for when it is decided where to look closer */
    public ShooterHierarchy(Faces faces, List<PatchTree> trees, Weights weights) {
        this(faces, trees, weights, new UniformRadiosity(null, faces.channels(), new double[0]));
    }

    /** @param ambient what is taken off the radiosity: by how much surfaces differ from it is shot */
    public ShooterHierarchy(Faces faces, List<PatchTree> trees, Weights weights, UniformRadiosity ambient) {
        this.ambient = ambient;
        this.faces = faces;
        this.trees = trees;
        this.weights = weights;
        channels = faces.channels();
        int most = trees.size() - 1;
        for (PatchTree tree : trees) {
            most += tree.child().length;
        }
        face = new int[most];
        path = new long[most];
        child = new int[most];
        normal = new float[3 * most];
        corner = new float[9 * most];
        key = new long[most];
        area = new float[most];
        extent = new float[4 * most];
        strength = new double[most];
        share = new double[most];
        cones = new NormalCones(most);
        radiosity = new double[3 * channels * most];
        open = new byte[most];
        nodes = 1;
        build(0, 0, trees.size());
    }

    /** Halves a run of trees, which stand in geometric order, until one is left. */
    private void build(int node, int from, int to) {
        if (to - from == 1) {
            plant(node, trees.get(from));
            return;
        }
        face[node] = -1;
        child[node] = nodes;
        nodes += 2;
        int middle = (from + to) >>> 1;
        build(child[node], from, middle);
        build(child[node] + 1, middle, to);
        enclose(node, child[node], child[node] + 1);
        cones.enclose(node, child[node], child[node] + 1);
        key[node] = Hash.mix(key[child[node]], key[child[node] + 1]);
    }

    /** A sphere around two; strengths by area. */
    private void enclose(int node, int a, int b) {
        area[node] = area[a] + area[b];
        double flux = strength[a] * area[a] + strength[b] * area[b];
        strength[node] = flux / area[node];
        share[node] = flux == 0 ? 0 : strength[a] * area[a] / flux;
        double d2 = 0;
        for (int i = 0; i < 3; i++) {
            double d = extent[4 * b + i] - extent[4 * a + i];
            d2 += d * d;
        }
        double d = Math.sqrt(d2);
        double ra = Math.sqrt(extent[4 * a + 3]);
        double rb = Math.sqrt(extent[4 * b + 3]);
        double r = Math.max(Math.max(ra, rb), (d + ra + rb) / 2);
        double t = d == 0 ? 0 : Math.min(1, Math.max(0, (r - ra) / d));
        for (int i = 0; i < 3; i++) {
            extent[4 * node + i] = (float) (extent[4 * a + i] + t * (extent[4 * b + i] - extent[4 * a + i]));
        }
        extent[4 * node + 3] = (float) (r * r * (1 + 1e-5));
    }

    /** A tree's nodes stand as they do in it, its top elsewhere. */
    private void plant(int top, PatchTree tree) {
        int before = nodes - 1;
        int count = tree.child().length;
        for (int i = 0; i < count; i++) {
            int below = tree.child()[i];
            child[i == 0 ? top : before + i] = below < 0 ? -1 : before + below;
        }
        face[top] = tree.face();
        Arrays.fill(face, nodes, before + count, tree.face());
        path[top] = tree.path();
        setRadiosity(tree, top, before);
        nodes = before + count;
        for (int i = 0; i < 9; i++) {
            corner[9 * top + i] = faces.corner(tree.face(), i / 3, i % 3);
        }
        for (int level = 1; level <= NodePath.level(tree.path()); level++) {
            Subdivision.child(corner, 9 * top, NodePath.step(tree.path(), level), corner, 9 * top);
        }
        area[top] = (float) (faces.area(tree.face()) / (1L << 2 * NodePath.level(tree.path())));
        survey(top);
        cones.set(top, normal, 3 * top);
    }

    /** What the nodes of a tree shoot; the top's own place is not among theirs. */
    private void setRadiosity(PatchTree tree, int top, int before) {
        int n = 3 * channels;
        System.arraycopy(tree.radiosity(), 0, radiosity, n * top, n);
        System.arraycopy(tree.radiosity(), n, radiosity, n * (before + 1), tree.radiosity().length - n);
        for (int i = 0; i < tree.child().length; i++) {
            int node = i == 0 ? top : before + i;
            for (int k = 0; k < 4 && child[node] >= 0; k++) {
                path[child[node] + k] = NodePath.child(path[node], k);
            }
            for (int j = 0; j < n && child[node] < 0; j++) {
                radiosity[n * node + j] -= ambient.at(tree.face(), j % channels);
            }
        }
        for (int i = tree.child().length - 1; i >= 0; i--) {
            int node = i == 0 ? top : before + i;
            strength[node] = child[node] < 0 ? ofElement(node) : ofParts(child[node]);
        }
    }

    private double ofParts(int first) {
        double sum = 0;
        for (int k = 0; k < 4; k++) {
            sum += strength[first + k] / 4;
        }
        return sum;
    }

    private double ofElement(int node) {
        double most = 0;
        for (int c = 0; c < channels; c++) {
            double sum = 0;
            for (int k = 0; k < 3; k++) {
                sum += Math.abs(radiosity[channels * (3 * node + k) + c]);
            }
            most = Math.max(most, weights.at(face[node], c) * sum / 3);
        }
        return most;
    }

    /*---- Where the parts of triangles lie: found when somebody looks at them ----*/

    /** To be called before anybody looks at the four parts of a triangle. Several threads find the same. */
    void open(int node) {
        if ((byte) OPEN.getAcquire(open, node) == 0) {
            divide(node);
            OPEN.setRelease(open, node, (byte) 1);
        }
    }

    private void divide(int node) {
        for (int k = 0; k < 4; k++) {
            int part = child[node] + k;
            area[part] = area[node] / 4;
            Subdivision.child(corner, 9 * node, k, corner, 9 * part);
            survey(part);
        }
    }

    /** What follows from a triangle's face, place and corners. */
    private void survey(int node) {
        key[node] = Hash.mix(Hash.mix(4, face[node]), path[node]);
        for (int a = 0; a < 3; a++) {
            normal[3 * node + a] = faces.normal(face[node], a);
            extent[4 * node + a] = (corner[9 * node + a] + corner[9 * node + 3 + a] + corner[9 * node + 6 + a]) / 3;
        }
        float most = 0;
        for (int k = 0; k < 3; k++) {
            float d2 = 0;
            for (int a = 0; a < 3; a++) {
                float d = corner[9 * node + 3 * k + a] - extent[4 * node + a];
                d2 += d * d;
            }
            most = Math.max(most, d2);
        }
        extent[4 * node + 3] = most;
    }

    /** The face on which a node lies, or -1 for a cluster. */
    public int face(int node) {
        return face[node];
    }

    /** A triangle's place below its face. */
    public long path(int node) {
        return path[node];
    }
}
