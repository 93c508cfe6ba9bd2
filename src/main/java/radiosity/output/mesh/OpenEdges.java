package radiosity.output.mesh;

import java.util.Arrays;
import radiosity.util.EdgeKey;

/** The edges that are not shared by exactly two elements: borders of parts, and edges with a vertex hanging in them. */
final class OpenEdges {

    /** One {@link EdgeKey} of vertices per open edge, ascending. */
    private final long[] edges;

    /** @param corners vertices, 3 per element; not modified, not kept */
    OpenEdges(int[] corners) {
        long[] all = new long[corners.length];
        for (int i = 0; i < corners.length; i++) {
            all[i] = EdgeKey.of(corners[i], corners[i % 3 == 2 ? i - 2 : i + 1]);
        }
        Arrays.sort(all);
        edges = EdgeKey.occurring(all, elements -> elements != 2);
    }

    boolean contains(int a, int b) {
        return Arrays.binarySearch(edges, EdgeKey.of(a, b)) >= 0;
    }

    /** The vertices at the ends of open edges, ascending. */
    int[] ends() {
        return EdgeKey.ends(edges);
    }
}
