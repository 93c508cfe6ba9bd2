package radiosity.mesh;

import java.util.Queue;
import radiosity.mesh.face.NodePath;

/** Joins the patch trees of neighbouring subtrees to the patch tree of a common ancestor. */
public final class JoinedTree {

    /** The given patch tree of this node; null where the node is divided into four parts. */
    private final PatchTree whole;
    /** Four, one per child of this node; null where this node has a given patch tree. */
    private final JoinedTree[] part;

    private JoinedTree(PatchTree whole, JoinedTree[] part) {
        this.whole = whole;
        this.part = part;
    }

    /**
     * Joins the patch trees of all subtrees below a node to the tree of the node.
     *
     * @param parts modified: patch trees in depth-first order; the parts of the node are removed from the head
     * @throws IllegalArgumentException where the head of the queue does not hold all parts of the node
     */
    public static PatchTree of(int face, long path, Queue<PatchTree> parts) {
        JoinedTree joined = take(face, path, parts);
        return joined.whole != null ? joined.whole : joined.tree(face, path);
    }

    private static JoinedTree take(int face, long path, Queue<PatchTree> parts) {
        PatchTree next = parts.peek();
        if (next == null || next.face() != face || NodePath.level(next.path()) < NodePath.level(path)) {
            throw new IllegalArgumentException("trees: expected all parts of " + face + " " + path + ", got " + next);
        }
        if (next.path() == path) {
            return new JoinedTree(parts.remove(), null);
        }
        JoinedTree[] part = new JoinedTree[4];
        for (int k = 0; k < part.length; k++) {
            part[k] = take(face, NodePath.child(path, k), parts);
        }
        return new JoinedTree(null, part);
    }

    private int size() {
        int size = whole == null ? 1 : whole.child().length;
        for (int k = 0; whole == null && k < part.length; k++) {
            size += part[k].size();
        }
        return size;
    }


    private int valuesPerNode() {
        return whole == null ? part[0].valuesPerNode() : whole.radiosity().length / whole.child().length;
    }

    private PatchTree tree(int face, long path) {
        int n = valuesPerNode();
        int[] child = new int[size()];
        double[] radiosity = new double[n * child.length];
        JoinedTree[] of = new JoinedTree[child.length];
        int[] at = new int[child.length];
        of[0] = this;
        for (int i = 0, next = 1; i < child.length; i++) {
            boolean inner = of[i].whole == null || of[i].whole.child()[at[i]] >= 0;
            child[i] = inner ? next : -1;
            for (int k = 0; k < 4 && inner; k++, next++) {
                of[next] = of[i].whole == null ? of[i].part[k] : of[i];
                at[next] = of[i].whole == null ? 0 : of[i].whole.child()[at[i]] + k;
            }
            if (!inner) {
                System.arraycopy(of[i].whole.radiosity(), n * at[i], radiosity, n * i, n);
            }
        }
        return new PatchTree(face, path, child, radiosity);
    }
}
