package radiosity.util;

import java.util.stream.IntStream;

/** Connected sets of numbered items: a disjoint-set forest in which the root of each set is its lowest item. */
public final class DisjointSets {

    private final int[] parent;

    /** @param count number of items, each of which is at first a set of its own */
    public DisjointSets(int count) {
        parent = IntStream.range(0, count).toArray();
    }

    /**
     * Sets of vertices that are connected by elements.
     *
     * @param corners vertices, 3 per element; not modified, not kept
     */
    public DisjointSets(int vertices, int[] corners) {
        this(vertices);
        for (int i = 0; i < corners.length; i += 3) {
            join(corners[i], corners[i + 1]);
            join(corners[i], corners[i + 2]);
        }
    }

    /** Joins the sets of two items. */
    public void join(int a, int b) {
        int p = of(a);
        int q = of(b);
        parent[Math.max(p, q)] = Math.min(p, q);
    }

    /** The lowest item in the set of an item. */
    public int of(int thing) {
        int t = thing;
        while (parent[t] != t) {
            parent[t] = parent[parent[t]];
            t = parent[t];
        }
        return t;
    }
}
