package radiosity.mesh;

/** Cuts a patch tree off at a level below its face; every element gets its mean radiosity at all corners. */
public final class MeanTree {

    private MeanTree() { }

    /** @param level levels below the face at which the tree is cut off; a tree with a deeper top keeps its top only */
    public static PatchTree of(PatchTree tree, int level) {
        int[] levels = tree.levels();
        int channels = tree.channels();
        return PatchTree.of(tree.face(), tree.path(), 0, i -> levels[i] < level ? tree.child()[i] : -1, 3 * channels,
                (i, values, at) -> {
                    double[] mean = new double[channels];
                    tree.addMean(i, 1, mean);
                    for (int k = 0; k < 3; k++) {
                        System.arraycopy(mean, 0, values, at + channels * k, channels);
                    }
                });
    }
}
