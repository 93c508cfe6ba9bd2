package radiosity.mesh;

import java.util.Arrays;

/** Removes redundant elements from a patch tree: four siblings with radiosity linear over their parent are merged. */
public final class PrunedTree {

    private final PatchTree tree;
    /** Children of the nodes as in {@link PatchTree#child}, but -1 where four siblings have been merged. */
    private final int[] child;
    private final double[] radiosity;
    /** Values per node: 3 x channels. */
    private final int n;

    private PrunedTree(PatchTree tree) {
        this.tree = tree;
        child = tree.child().clone();
        radiosity = tree.radiosity().clone();
        n = radiosity.length / child.length;
    }

    /**
     * The same radiosity, to the last bit, on as few elements as possible.
     *
     * @param level siblings whose parent lies above this level below the face are not merged
     */
    public static PatchTree of(PatchTree tree, int level) {
        if (tree.child().length == 1) {
            return tree;
        }
        PrunedTree pruned = new PrunedTree(tree);
        pruned.prune(level);
        return Arrays.equals(pruned.child, tree.child()) ? tree : PatchTree.of(tree.face(), tree.path(), 0,
                i -> pruned.child[i], pruned.n,
                (i, values, at) -> System.arraycopy(pruned.radiosity, pruned.n * i, values, at, pruned.n));
    }

    private void prune(int level) {
        int[] levels = tree.levels();
        for (int i = child.length - 1; i >= 0; i--) {
            if (child[i] >= 0 && levels[i] >= level && isLinear(child[i])) {
                for (int k = 0; k < 3; k++) {
                    System.arraycopy(radiosity, corner(child[i] + k, k), radiosity, corner(i, k), n / 3);
                }
                child[i] = -1;
            }
        }
    }

    private int corner(int node, int k) {
        return n * node + n / 3 * k;
    }

    /**
     * Whether four consecutive nodes are elements whose radiosity at the middles of their parent's edges is the exact
     * mean of the values at the ends of these edges.
     */
    private boolean isLinear(int first) {
        for (int k = 0; k < 4; k++) {
            if (child[first + k] >= 0) {
                return false;
            }
        }
        for (int k = 0; k < 3; k++) {
            int p = (k + 1) % 3;
            int q = (k + 2) % 3;
            for (int c = 0; c < n / 3; c++) {
                double middle = 0.5 * (radiosity[corner(first + p, p) + c] + radiosity[corner(first + q, q) + c]);
                if (radiosity[corner(first + 3, k) + c] != middle || radiosity[corner(first + p, q) + c] != middle
                        || radiosity[corner(first + q, p) + c] != middle) {
                    return false;
                }
            }
        }
        return true;
    }
}
