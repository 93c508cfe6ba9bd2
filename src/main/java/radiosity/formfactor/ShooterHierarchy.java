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
 * A shooter, prepared for gathering: the tree of elements of each of its patches with the radiosities to shoot (section
 * 4.4 of the paper), and above several patches a binary tree of clusters of neighbours.
 *
 * <p>A node is a cluster with two children, a triangle with four, or an element. Any number of threads may read.
 * Clusters: B. Smits, J. Arvo, D. Greenberg, A clustering algorithm for radiosity in complex environments, 1994.
 */
public final class ShooterHierarchy {

    private static final VarHandle OPEN = MethodHandles.arrayElementVarHandle(byte[].class);

    final int channels;
    private int nodes;
    /** 1 per node: its face, or -1 for a cluster. */
    final int[] face;
    /** 1 per node, for triangles: path below the face, see {@link NodePath}. */
    private final long[] path;
    /** 1 per node: first of its consecutive children, or -1. */
    final int[] child;
    /** 3 per node, for triangles: normal. */
    final float[] normal;
    /** 9 per node, for triangles: corners in the scene brought to size 1. */
    final float[] corner;
    /** 1 per node: key that is the same on every host. */
    final long[] key;
    /** 1 per node: area, in units of the scene's squared size. */
    final float[] area;
    /** 4 per node: middle and squared radius of a sphere around the node. */
    final float[] extent;
    /** 1 per node: mean by area, over the elements below the node, of the largest channel of weight x |radiosity|. */
    final double[] strength;
    /** Cones of normals of clusters and of the top triangles below clusters. */
    final NormalCones cones;
    /** 1 per node, for clusters: part of the flux (strength times area) that the first child shoots, in [0, 1]. */
    final double[] share;
    /** 3 x channels per node, for elements: radiosity to shoot, corner by corner, W/m². */
    final double[] radiosity;

    /** 1 per node: not 0 where corners and areas of the node's four parts have been computed. */
    private final byte[] open;
    private final Faces faces;
    private final List<PatchTree> trees;
    private final Weights weights;
    private final UniformRadiosity ambient;

    /** @param weights weights of radiosity in {@link RayCaster}'s decision where to enter nodes */
    public ShooterHierarchy(Faces faces, List<PatchTree> trees, Weights weights) {
        this(faces, trees, weights, new UniformRadiosity(null, faces.channels(), new double[0]));
    }

    /** @param ambient uniform radiosity that is subtracted: surfaces shoot only their difference from it */
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

    /** Builds a node for the trees {@code from} to {@code to - 1}, in geometric order; each half becomes a child. */
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

    /** Sets area, strength, share and sphere of a cluster from its children a and b. */
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

    /** Copies a tree: its top to node {@code top}, all other nodes in the order of the tree to the next free nodes. */
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
        System.arraycopy(faces.corners(tree.face(), tree.path()), 0, corner, 9 * top, 9);
        area[top] = (float) faces.area(tree.face(), tree.path());
        survey(top);
        cones.set(top, normal, 3 * top);
    }

    /** Sets radiosity, path and strength of a tree's nodes: of {@code top}, and of node i at {@code before} + i. */
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

    /*---- Geometry of the parts of triangles: computed when first needed ----*/

    /** To be called before the four parts of a triangle are read. Any thread may call: all compute the same numbers. */
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

    /** Computes key, normal and sphere of a triangle from its face, path and corners. */
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

    /** Path of a triangle below its face, see {@link NodePath}. */
    public long path(int node) {
        return path[node];
    }
}
