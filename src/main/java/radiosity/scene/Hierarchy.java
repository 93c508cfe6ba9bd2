package radiosity.scene;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * Objects as the scene's maker named and ordered them, and which triangles are whose.
 *
 * @param nodes  each after its parent
 * @param nodeOf index into {@code nodes}, 1 per triangle; belongs to the hierarchy, nobody modifies it; empty where
 *               there are no nodes
 */
public record Hierarchy(List<SceneNode> nodes, int[] nodeOf) {

    /** Nodes up to which they are written: each takes some 10 KB of memory meanwhile, and nobody looks at more. */
    public static final int MOST_WRITTEN = 10_000;

    /** Triangles that belong to no object. */
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

    /** The same nodes without names, for who only has to tell them apart. */
    public static Hierarchy unnamed(int[] nodeOf) {
        int count = Arrays.stream(nodeOf).max().orElse(-1) + 1;
        return new Hierarchy(Collections.nCopies(count, new SceneNode("", -1, "", Affine.IDENTITY)), nodeOf);
    }

    /** What of it is written to a file: nothing where there are more than 10,000 nodes. */
    public Hierarchy written() {
        return nodes.size() <= MOST_WRITTEN ? this : NONE;
    }

    /** The node of a triangle, or -1 where it belongs to none. */
    public int of(int triangle) {
        return nodeOf.length == 0 ? -1 : nodeOf[triangle];
    }
}
