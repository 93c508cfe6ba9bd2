package radiosity.mesh;

import java.util.Arrays;
import radiosity.mesh.face.NodePath;
import radiosity.util.Hash;
import radiosity.util.LongIndex;

/** The top nodes of the subtrees of some blocks, found by face and path. */
final class Roots {

    private final LongIndex names;
    private int[] node;
    private long[] path;
    private int count;

    /** @param expected expected number of top nodes */
    Roots(int expected) {
        names = new LongIndex(expected);
        node = new int[Math.max(1, expected)];
        path = new long[node.length];
    }

    void add(int face, long at, int root) {
        names.findOrAdd(name(face, at), root);
        if (count == node.length) {
            node = Arrays.copyOf(node, 2 * count);
            path = Arrays.copyOf(path, 2 * count);
        }
        path[count] = at;
        node[count++] = root;
    }

    int count() {
        return count;
    }

    /** Path of top node i below its face, see {@link NodePath}. */
    long path(int i) {
        return path[i];
    }

    /** The top nodes, in the order in which they were added. */
    int[] all() {
        return Arrays.copyOf(node, count);
    }

    /** The top node with this face and path, or -1. */
    int find(int face, long at) {
        return names.find(name(face, at));
    }

    private static long name(int face, long at) {
        return Hash.mix(Hash.mix(4, face), at);
    }
}
