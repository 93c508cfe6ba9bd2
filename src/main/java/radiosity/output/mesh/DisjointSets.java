package radiosity.output.mesh;

/** Which vertices are connected by elements: a disjoint-set forest whose roots are the lowest vertices. */
public final class DisjointSets {

    private final int[] parent;

    /** @param corners vertices, 3 per element; not modified, not kept */
    public DisjointSets(int vertices, int[] corners) {
        parent = new int[vertices];
        for (int v = 0; v < vertices; v++) {
            parent[v] = v;
        }
        for (int i = 0; i < corners.length; i += 3) {
            join(corners[i], corners[i + 1]);
            join(corners[i], corners[i + 2]);
        }
    }

    /** Makes one of two vertices' parts. */
    public void join(int a, int b) {
        int p = of(a);
        int q = of(b);
        parent[Math.max(p, q)] = Math.min(p, q);
    }

    /** The lowest vertex of a vertex's part. */
    public int of(int vertex) {
        int v = vertex;
        while (parent[v] != v) {
            parent[v] = parent[parent[v]];
            v = parent[v];
        }
        return v;
    }
}
