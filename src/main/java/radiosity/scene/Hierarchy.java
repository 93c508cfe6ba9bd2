package radiosity.scene;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * The named objects of a scene, in the order of the input file, and the object to which each triangle belongs.
 *
 * @param nodes  each node after its parent
 * @param nodeOf index into {@code nodes}, 1 per triangle; not copied, not to be modified; empty without nodes
 */
public record Hierarchy(List<SceneNode> nodes, int[] nodeOf) {

    /** Most nodes that are written to a file: writing takes some 10 KB of memory per node, and no user reads more. */
    public static final int MOST_WRITTEN = 10_000;

    /** The hierarchy of a scene whose triangles belong to no object. */
    public static final Hierarchy NONE = new Hierarchy(List.of(), new int[0]);

    public Hierarchy {
        nodes = List.copyOf(nodes);
        for (int n = 0; n < nodes.size(); n++) {
            require(nodes.get(n).parent() >= -1 && nodes.get(n).parent() < n, "a parent before node " + n,
                    nodes.get(n).parent());
        }
        for (int node : nodeOf) {
            require(node >= 0 && node < nodes.size(), "a node below " + nodes.size(), node);
        }
    }

    private static void require(boolean holds, String expected, int got) {
        if (!holds) {
            throw new IllegalArgumentException("hierarchy: expected " + expected + ", got " + got);
        }
    }

    /** A hierarchy of nodes without names and parents, for code that only tells nodes apart. */
    public static Hierarchy unnamed(int[] nodeOf) {
        int count = Arrays.stream(nodeOf).max().orElse(-1) + 1;
        return new Hierarchy(Collections.nCopies(count, new SceneNode("", -1, "", Affine.IDENTITY)), nodeOf);
    }

    /** The hierarchy for files: this one if it has at most {@link #MOST_WRITTEN} nodes, else {@link #NONE}. */
    public Hierarchy written() {
        return nodes.size() <= MOST_WRITTEN ? this : NONE;
    }

    /** The node of a triangle, or -1 where the triangle belongs to none. */
    public int of(int triangle) {
        return nodeOf.length == 0 ? -1 : nodeOf[triangle];
    }
}
