package radiosity.util;

import java.util.Arrays;

/** Finds the edges that triangles have in common. */
public final class CommonEdges {

    /** Largest number of earlier triangles at an edge with which a triangle is paired, so that no file takes long. */
    private static final int MOST = 8;

    private CommonEdges() { }

    /** Is given a pair of triangles with a common edge. */
    public interface Pair {

        /**
         * @param i corner at one end of the edge, in the first triangle
         * @param j corner at the same end, in the second triangle
         * @param k corner at the other end, in the first triangle
         * @param l corner at the other end, in the second triangle
         */
        void met(int i, int j, int k, int l);
    }

    /**
     * Visits the pairs of triangles with a common edge, in the order of the triangles.
     *
     * @param at 3 per triangle: the number of the point at each corner; not modified
     */
    public static void visit(int[] at, Pair pair) {
        LongIndex latest = new LongIndex(at.length);
        // The edge before with the same ends, of an earlier triangle. An edge has the number of its first corner.
        int[] earlier = new int[at.length];
        Arrays.fill(earlier, -1);
        for (int i = 0; i < at.length; i++) {
            int k = next(i);
            if (at[i] == at[k]) {
                continue;
            }
            long key = EdgeKey.of(at[i], at[k]);
            earlier[i] = latest.find(key);
            latest.put(key, i);
            for (int j = earlier[i], n = 0; j >= 0 && n < MOST; j = earlier[j], n++) {
                boolean alike = at[j] == at[i];
                pair.met(i, alike ? j : next(j), k, alike ? next(j) : j);
            }
        }
    }

    private static int next(int corner) {
        return corner % 3 == 2 ? corner - 2 : corner + 1;
    }
}
