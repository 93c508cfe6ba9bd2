package radiosity.patch;

import java.util.Arrays;

/** The top nodes of the subtrees that some blocks have, by name. */
final class Roots {

    private final LongIndex names;
    private int[] node;
    private int count;

    /** @param expected about how many */
    Roots(int expected) {
        names = new LongIndex(expected);
        node = new int[Math.max(1, expected)];
    }

    void add(int face, long path, int top) {
        names.findOrAdd(name(face, path), top);
        if (count == node.length) {
            node = Arrays.copyOf(node, 2 * count);
        }
        node[count++] = top;
    }

    /** In the order of the blocks. */
    int[] all() {
        return Arrays.copyOf(node, count);
    }

    /** The top node of this name, or -1. */
    int find(int face, long path) {
        return names.find(name(face, path));
    }

    private static long name(int face, long path) {
        return Hash.mix(Hash.mix(4, face), path);
    }
}
