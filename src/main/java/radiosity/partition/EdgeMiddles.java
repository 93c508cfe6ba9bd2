package radiosity.partition;

import java.util.Arrays;
import java.util.BitSet;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.face.NodePath;

/**
 * The vertices in the order in which they receive a shot where the middle of an edge may take the mean of what the
 * edge's ends receive (P. Hanrahan, D. Salzman, L. Aupperle, A rapid hierarchical radiosity algorithm, 1991: receivers
 * interact at the level at which they receive alike).
 *
 * <p>Vertices of the initial mesh and the middles of its edges always gather for themselves, so that no shadow is
 * missed that the division of the mesh would find. So do vertices on an edge that faces share: another face may be
 * divided otherwise there, on another host. Within a face the ends of a vertex's edge follow from the vertex's place.
 */
final class EdgeMiddles {

    private final RadiosityNodes nodes;
    /** Number of nodes for which the other fields hold. */
    private int known = -1;
    /** 2 per vertex: the ends of the edge whose middle it is, or -1 where the vertex always gathers. */
    private int[] ends = {};
    /** 1 per vertex: 0 where it always gathers, else 1 more than the larger number of its edge's ends. */
    private int[] wave = {};
    private int waves;

    EdgeMiddles(RadiosityNodes nodes) {
        this.nodes = nodes;
    }

    /** End 0 or 1 of the edge whose middle a vertex is; -1 where the vertex always gathers. */
    int end(int vertex, int number) {
        return ends[2 * vertex + number];
    }

    /**
     * Some vertices and all on which they depend, in waves: the ends of a vertex's edge are in earlier waves.
     *
     * @param vertices not modified
     */
    int[][] waves(int[] vertices) {
        look();
        BitSet needed = new BitSet(wave.length);
        for (int v : vertices) {
            needed.set(v);
        }
        int[] size = new int[waves];
        for (int v = needed.length() - 1; v >= 0; v = needed.previousSetBit(v - 1)) {
            size[wave[v]]++;
            if (wave[v] > 0) {
                needed.set(ends[2 * v]);
                needed.set(ends[2 * v + 1]);
            }
        }
        int[][] made = new int[waves][];
        Arrays.setAll(made, w -> new int[size[w]]);
        Arrays.fill(size, 0);
        for (int v = needed.nextSetBit(0); v >= 0; v = needed.nextSetBit(v + 1)) {
            made[wave[v]][size[wave[v]]++] = v;
        }
        return made;
    }

    /** Finds the edges, where the mesh has been divided since the last time. */
    private void look() {
        if (known == nodes.nodes()) {
            return;
        }
        known = nodes.nodes();
        ends = new int[2 * nodes.vertices()];
        Arrays.fill(ends, -1);
        for (int top : nodes.tops()) {
            look(top, shared(top));
        }
        wave = new int[nodes.vertices()];
        waves = 1;
        for (int v = 0; v < wave.length; v++) {
            if (ends[2 * v] >= 0) { // both have lower numbers, as an edge is there before it is divided
                wave[v] = 1 + Math.max(wave[ends[2 * v]], wave[ends[2 * v + 1]]);
                waves = Math.max(waves, 1 + wave[v]);
            }
        }
    }

    /** Bit k: whether the edge of a node opposite corner k lies on an edge that its face shares with another. */
    private int shared(int node) {
        int[] weight = new int[9];
        NodePath.weights(nodes.path(node), weight);
        int shared = 0;
        for (int k = 0; k < 3; k++) {
            for (int of = 0; of < 3; of++) {
                boolean lies = weight[3 * ((k + 1) % 3) + of] == 0 && weight[3 * ((k + 2) % 3) + of] == 0;
                shared |= lies && (nodes.faces().border[nodes.face(node)] >> of & 1) == 0 ? 1 << k : 0;
            }
        }
        return shared;
    }

    /** @param shared see {@link #shared(int)} */
    private void look(int node, int shared) {
        if (nodes.isElement(node)) {
            return;
        }
        int first = nodes.child(node);
        for (int k = 0; k < 3; k++) {
            int middle = nodes.corner(first + 3, k);
            int p = nodes.corner(node, (k + 1) % 3);
            int q = nodes.corner(node, (k + 2) % 3);
            boolean isShared = (shared >> k & 1) == 1;
            if (!isShared && nodes.points().made(middle) > 0 && nodes.points().made(p) + nodes.points().made(q) > 0) {
                ends[2 * middle] = p;
                ends[2 * middle + 1] = q;
            }
            look(first + k, shared & ~(1 << k));
        }
        look(first + 3, 0);
    }
}
