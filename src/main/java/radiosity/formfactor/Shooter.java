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
    final float nx;
    final float ny;
    final float nz;
    /** 9 per node: corners. */
    final float[] corner;
    /** 1 per node: first of four consecutive children, or -1. */
    final int[] child;
    /** 1 per node: what it is, whoever shoots it. */
    final long[] key;
    /** 3 x channels per node: radiosity to shoot at the corners; of inner nodes the mean of what lies below. W/m². */
    final double[] radiosity;
    /** 1 per node: mean over the node of the largest weighted channel of |radiosity|. */
    final double[] strength;

    /**
     * @param faces     where the face's geometry stands
     * @param face      the face on which the shooter lies
     * @param top       its node below the face
     * @param child     1 per node of the tree, breadth first: first of four consecutive children, or -1
     * @param radiosity 3 x channels per node, corner by corner, of leaves; modified: filled in for inner nodes
     */
    public Shooter(Faces faces, int face, long top, int[] child, double[] radiosity) {
        channels = faces.channels();
        nx = faces.normal(face, 0);
        ny = faces.normal(face, 1);
        nz = faces.normal(face, 2);
        this.child = child;
        this.radiosity = radiosity;
        int nodes = child.length;
        corner = new float[9 * nodes];
        key = new long[nodes];
        strength = new double[nodes];
        for (int i = 0; i < 9; i++) {
            corner[i] = faces.corner(face, i / 3, i % 3);
        }
        for (int level = 1; level <= Path.level(top); level++) {
            float[] at = java.util.Arrays.copyOf(corner, 9);
            Subdivision.child(at, 0, (int) (top >>> 2 * (Path.level(top) - level)) & 3, corner, 0);
        }
        long[] path = new long[nodes];
        path[0] = top;
        for (int i = 0; i < nodes; i++) {
            key[i] = Hash.mix(Hash.mix(4, face), path[i]);
            for (int k = 0; k < 4 && child[i] >= 0; k++) {
                path[child[i] + k] = Path.child(path[i], k);
                Subdivision.child(corner, 9 * i, k, corner, 9 * (child[i] + k));
            }
        }
        for (int i = nodes - 1; i >= 0; i--) {
            summarize(i);
        }
    }

    private void summarize(int i) {
        if (child[i] < 0) {
            for (int c = 0; c < channels; c++) {
                double sum = 0;
                for (int k = 0; k < 3; k++) {
                    sum += Math.abs(radiosity[channels * (3 * i + k) + c]);
                }
                strength[i] = Math.max(strength[i], sum / 3);
            }
            return;
        }
        for (int k = 0; k < 4; k++) {
            strength[i] += strength[child[i] + k] / 4;
        }
    }

    /** Number of nodes of the tree. */
    public int nodes() {
        return child.length;
    }
}
