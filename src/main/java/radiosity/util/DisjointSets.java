package radiosity.util;

import java.util.stream.IntStream;

/** Which of some numbered things are connected: a disjoint-set forest whose roots are the lowest of each set. */
public final class DisjointSets {

    private final int[] parent;

    /** @param count number of things, each of which is a set of its own at first */
    public DisjointSets(int count) {
        parent = IntStream.range(0, count).toArray();
    }

    /**
     * Vertices connected by elements.
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

    /** Makes one of the sets of two things. */
    public void join(int a, int b) {
        int p = of(a);
        int q = of(b);
        parent[Math.max(p, q)] = Math.min(p, q);
    }

    /** The lowest thing that is in the same set. */
    public int of(int thing) {
        int t = thing;
        while (parent[t] != t) {
            parent[t] = parent[parent[t]];
            t = parent[t];
        }
        return t;
    }
}
