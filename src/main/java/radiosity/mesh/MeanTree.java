package radiosity.mesh;

import java.util.Arrays;
import radiosity.mesh.face.NodePath;

/** Cuts a patch tree off at a level below its face; every element gets its mean radiosity at all corners. */
public final class MeanTree {

    private MeanTree() { }

    /** @param level levels below the face at which the tree is cut off; a tree with a deeper top keeps its top only */
    public static PatchTree of(PatchTree tree, int level) {
        int[] of = new int[tree.child().length];
        int[] levels = new int[of.length];
        int[] child = new int[of.length];
        levels[0] = NodePath.level(tree.path());
        int size = 1;
        for (int i = 0; i < size; i++) {
            int first = levels[i] < level ? tree.child()[of[i]] : -1;
            child[i] = first < 0 ? -1 : size;
            for (int k = 0; k < 4 && first >= 0; k++, size++) {
                of[size] = first + k;
                levels[size] = levels[i] + 1;
            }
        }
        return new PatchTree(tree.face(), tree.path(), Arrays.copyOf(child, size), means(tree, child, of, size));
    }

    /** 3 x channels per node: the mean radiosity of an element at each of its corners; 0 for inner nodes. W/m². */
    private static double[] means(PatchTree tree, int[] child, int[] of, int size) {
        int channels = tree.channels();
        double[] means = new double[3 * channels * size];
        for (int i = 0; i < size; i++) {
            double[] mean = new double[channels];
            if (child[i] < 0) {
                tree.addMean(of[i], 1, mean);
            }
            for (int k = 0; k < 3; k++) {
                System.arraycopy(mean, 0, means, channels * (3 * i + k), channels);
            }
        }
        return means;
    }
}
