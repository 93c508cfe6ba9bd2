package radiosity.output.mesh;

import java.util.Arrays;
import java.util.BitSet;

/** The edges that are not shared by exactly two elements: borders of parts, and edges with a vertex hanging in them. */
final class OpenEdges {

    /** One key per open edge, sorted: lower vertex in the upper 32 bits, higher vertex in the lower 32 bits. */
    private final long[] edges;

    /** @param corners vertices, 3 per element; not modified, not kept */
    OpenEdges(int[] corners) {
        long[] all = new long[corners.length];
        for (int i = 0; i < corners.length; i++) {
            all[i] = key(corners[i], corners[i % 3 == 2 ? i - 2 : i + 1]);
        }
        Arrays.parallelSort(all);
        int count = 0;
        for (int i = 0, next; i < all.length; i = next) {
            next = i + 1;
            while (next < all.length && all[next] == all[i]) {
                next++;
            }
            if (next - i != 2) {
                all[count++] = all[i];
            }
        }
        edges = Arrays.copyOf(all, count);
    }

    private static long key(int a, int b) {
        return (long) Math.min(a, b) << 32 | Math.max(a, b);
    }

    boolean contains(int a, int b) {
        return Arrays.binarySearch(edges, key(a, b)) >= 0;
    }

    /**
     * The vertices at the ends of open edges, ascending.
     *
     * @param vertices number of vertices of the mesh
     */
    int[] ends(int vertices) {
        BitSet ends = new BitSet(vertices);
        for (long edge : edges) {
            ends.set((int) (edge >> 32));
            ends.set((int) edge);
        }
        return ends.stream().toArray();
    }
}
