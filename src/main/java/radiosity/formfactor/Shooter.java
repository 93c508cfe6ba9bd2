package radiosity.formfactor;

import radiosity.patch.Faces;
import radiosity.patch.Hash;
import radiosity.patch.Path;
import radiosity.patch.Subdivision;

/**
 * A patch that shoots: the tree of elements below it and the radiosity of each (section 4.4 of the paper), ready for
 * being gathered from. Read by any number of threads.
 */
public final class Shooter {

    final int channels;
    private final int face;
    /** 1 per node. */
    private final long[] path;
    final float nx;
    final float ny;
    final float nz;
    /** 9 per node: corners. */
    final float[] corner;
    /** 1 per node: first of four consecutive children, or -1. */
    final int[] child;
    /** 1 per node: what it is, whoever shoots it. */
    final long[] key;
    /** 3 x channels per node: radiosity to shoot at the corners, of leaves. W/m². */
    final double[] radiosity;
    /** 4 per node: middle, and squared distance from there to the farthest corner. */
    final float[] extent;
    /** 1 per node: mean over the node of the largest channel of weight times |radiosity|. */
    final double[] strength;

    /**
     * @param faces     where the face's geometry stands
     * @param face      the face on which the shooter lies
     * @param top       its node below the face
     * @param child     1 per node of the tree, breadth first: first of four consecutive children, or -1
     * @param radiosity 3 x channels per node, corner by corner, of leaves
     * @param weight    one per channel: what its radiosity counts for when it is decided where to look closer
     */
    public Shooter(Faces faces, int face, long top, int[] child, double[] radiosity, double[] weight) {
        channels = faces.channels();
        this.face = face;
        nx = faces.normal(face, 0);
        ny = faces.normal(face, 1);
        nz = faces.normal(face, 2);
        this.child = child;
        this.radiosity = radiosity;
        int nodes = child.length;
        corner = new float[9 * nodes];
        key = new long[nodes];
        strength = new double[nodes];
        extent = new float[4 * nodes];
        for (int i = 0; i < 9; i++) {
            corner[i] = faces.corner(face, i / 3, i % 3);
        }
        for (int level = 1; level <= Path.level(top); level++) {
            Subdivision.child(corner, 0, Path.step(top, level), corner, 0);
        }
        path = new long[nodes];
        path[0] = top;
        for (int i = 0; i < nodes; i++) {
            key[i] = Hash.mix(Hash.mix(4, face), path[i]);
            for (int k = 0; k < 4 && child[i] >= 0; k++) {
                path[child[i] + k] = Path.child(path[i], k);
                Subdivision.child(corner, 9 * i, k, corner, 9 * (child[i] + k));
            }
        }
        for (int i = nodes - 1; i >= 0; i--) {
            measure(i);
            summarize(i, weight);
        }
    }

    private void measure(int i) {
        for (int a = 0; a < 3; a++) {
            extent[4 * i + a] = (corner[9 * i + a] + corner[9 * i + 3 + a] + corner[9 * i + 6 + a]) / 3;
        }
        for (int k = 0; k < 3; k++) {
            float d2 = 0;
            for (int a = 0; a < 3; a++) {
                float d = corner[9 * i + 3 * k + a] - extent[4 * i + a];
                d2 += d * d;
            }
            extent[4 * i + 3] = Math.max(extent[4 * i + 3], d2);
        }
    }

    private void summarize(int i, double[] weight) {
        if (child[i] < 0) {
            for (int c = 0; c < channels; c++) {
                double sum = 0;
                for (int k = 0; k < 3; k++) {
                    sum += Math.abs(radiosity[channels * (3 * i + k) + c]);
                }
                strength[i] = Math.max(strength[i], weight[c] * sum / 3);
            }
            return;
        }
        for (int k = 0; k < 4; k++) {
            strength[i] += strength[child[i] + k] / 4;
        }
    }

    /** The face on which it lies. */
    public int face() {
        return face;
    }

    /** A node's place below the face. */
    public long path(int node) {
        return path[node];
    }

    /** Number of nodes of the tree. */
    public int nodes() {
        return child.length;
    }
}
