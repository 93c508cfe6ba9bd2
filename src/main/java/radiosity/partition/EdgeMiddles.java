package radiosity.partition;

import java.util.Arrays;
import java.util.BitSet;
import radiosity.mesh.Patcher;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.face.NodePath;

/**
 * The vertices in the order in which they receive a shot where the middle of an edge may take the mean of what the
 * edge's ends receive (P. Hanrahan, D. Salzman, L. Aupperle, A rapid hierarchical radiosity algorithm, 1991: receivers
 * interact at the level at which they receive alike).
 *
 * <p>Vertices of the initial mesh and the middles of its edges always gather for themselves, so that no shadow is
 * missed that the division of the mesh would find. Where faces share an edge, the initial mesh there is that of the
 * face which has more levels of it. So whether a vertex gathers, and between which ends it lies, follows from its place
 * alone, and is the same on every host, whatever faces and elements the host has.
 */
final class EdgeMiddles {

    private final RadiosityNodes nodes;
    private final Patcher patcher;
    /** Number of nodes for which the other fields hold. */
    private int known = -1;
    /** 2 per vertex: the ends of the edge whose middle it is, or -1 where the vertex always gathers. */
    private int[] ends = {};
    /** 1 per vertex: 0 where it always gathers, else 1 more than the larger number of its edge's ends. */
    private int[] wave = {};
    private int waves;

    /** @param nodes a mesh, which may be divided later */
    EdgeMiddles(RadiosityNodes nodes, Patcher patcher) {
        this.nodes = nodes;
        this.patcher = patcher;
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
        findEdges();
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
    private void findEdges() {
        if (known == nodes.nodes()) {
            return;
        }
        known = nodes.nodes();
        ends = new int[2 * nodes.vertices()];
        Arrays.fill(ends, -1);
        for (int top : nodes.tops()) {
            int level = NodePath.level(nodes.path(top));
            findEdges(top, level - patcher.level(nodes.face(top)), sides(top));
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

    /** Bit k: whether the edge of a node opposite corner k lies on the same edge of the node's face. */
    private int sides(int node) {
        int[] weight = new int[9];
        NodePath.weights(nodes.path(node), weight);
        int sides = 0;
        for (int k = 0; k < 3; k++) {
            sides |= weight[3 * ((k + 1) % 3) + k] == 0 && weight[3 * ((k + 2) % 3) + k] == 0 ? 1 << k : 0;
        }
        return sides;
    }

    /**
     * Finds the edges of a node and of all nodes below it.
     *
     * @param depth levels from the face's patches down to the node; below 0 above the patches
     * @param sides see {@link #sides(int)}
     */
    private void findEdges(int node, int depth, int sides) {
        if (nodes.isElement(node)) {
            return;
        }
        int face = nodes.face(node);
        int first = nodes.child(node);
        for (int k = 0; k < 3; k++) {
            int across = (sides >> k & 1) == 1 ? nodes.faces().across[3 * face + k] : -1;
            int finer = across < 0 ? 0 : Math.max(0, patcher.level(across) - patcher.level(face));
            if (depth > finer) {
                int middle = nodes.corner(first + 3, k);
                ends[2 * middle] = nodes.corner(node, (k + 1) % 3);
                ends[2 * middle + 1] = nodes.corner(node, (k + 2) % 3);
            }
            findEdges(first + k, depth + 1, sides & ~(1 << k));
        }
        findEdges(first + 3, depth + 1, 0);
    }
}
