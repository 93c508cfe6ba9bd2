package radiosity.solver;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.VertexBulge;
import radiosity.protocol.BlockState;
import radiosity.setup.InitialMesh;
import radiosity.solution.EnergyLedger;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.util.ArraySize;
import radiosity.util.Hash;
import radiosity.util.LongIndex;

/** Merges the blocks of all partitions into one mesh, in the order of block ids (figure 7: merge patch trees). */
final class Merger {

    private final InitialMesh mesh;
    private final int dark;
    private final int channels;
    private final LongIndex index = new LongIndex(1024);
    private double[] position = new double[3 * 1024];
    /** channels per vertex: sum of irradiance over the vertex's copies, W/m². */
    private double[] irradiance;
    private final VertexBulge bulge;
    /** One per channel: see {@link SolveCounters#shownShare}. */
    private final double[] share;
    /** 1 per vertex: its key; the corners of an element that is a point have keys derived from the point's key. */
    private long[] vertexKey = new long[1024];
    /** 1 per vertex: number of its copies in blocks, without buried copies. */
    private int[] copies = new int[1024];
    private int[] corner = new int[3 * 1024];
    private int[] faceOf = new int[1024];
    private int elements;

    /**
     * @param dark  number of the round whose new vertices have not gathered yet; they take the irradiance of their
     *              neighbours; 0 where there is no such round
     * @param share one per channel: share of the irradiance that is shown, in [0, 1]; not modified
     */
    Merger(InitialMesh mesh, List<byte[]> states, int dark, double[] share) {
        this.mesh = mesh;
        this.share = share;
        this.dark = dark;
        channels = mesh.faces.channels();
        irradiance = new double[channels * 1024];
        bulge = new VertexBulge(channels, mesh.faces.colours());
        for (int b = 0; b < states.size(); b++) {
            RadiosityNodes nodes = BlockState.nodes(mesh.patcher, mesh.blocks.get(b), states.get(b));
            add(nodes);
            bulge.add(nodes, dark);
        }
    }

    /** Adds the elements of a block but for those that surfaces in the same place cover: these are not to be seen. */
    private void add(RadiosityNodes nodes) {
        int[] number = new int[nodes.vertices()];
        Arrays.fill(number, -1);
        for (int node = 0; node < nodes.nodes(); node++) {
            if (!nodes.isElement(node) || mesh.rooms.isCovered(nodes.face(node))) {
                continue;
            }
            if (elements == faceOf.length) {
                int room = ArraySize.room("corners of elements", elements + 1L, 2L * elements, 3);
                faceOf = Arrays.copyOf(faceOf, room);
                corner = Arrays.copyOf(corner, 3 * room);
            }
            for (int k = 0; k < 3; k++) {
                int v = nodes.corner(node, k);
                if (number[v] < 0 || nodes.isPoint(node)) {
                    number[v] = vertex(nodes, node, k);
                }
                corner[3 * elements + k] = number[v];
            }
            int side = mesh.faces.side(nodes.face(node));
            faceOf[elements++] = 2 * mesh.origins[side >> 1] + (side & 1);
        }
    }

    private int vertex(RadiosityNodes nodes, int node, int k) {
        int from = nodes.corner(node, k);
        long key = nodes.isPoint(node) ? Hash.mix(nodes.points().key(from), k) : nodes.points().key(from);
        int v = index.findOrAdd(key, index.size());
        if (v == copies.length) {
            int room = ArraySize.room("light at vertices in " + channels + " channels", v + 1L, 2L * v,
                    Math.max(3, channels));
            copies = Arrays.copyOf(copies, room);
            position = Arrays.copyOf(position, 3 * room);
            irradiance = Arrays.copyOf(irradiance, channels * room);
            vertexKey = Arrays.copyOf(vertexKey, room);
        }
        vertexKey[v] = key;
        nodes.position(node, k, position, 3 * v);
        if (!nodes.points().isBuried(from) && (dark == 0 || nodes.points().made(from) != dark)) {
            copies[v]++;
            for (int c = 0; c < channels; c++) {
                irradiance[channels * v + c] += nodes.points().shown(from, c);
            }
        }
        return v;
    }

    Solution solution(int shots, int rounds, double unshotFlux, EnergyLedger ledger, SavedState state) {
        int vertices = index.size();
        for (int v = 0; v < vertices; v++) {
            for (int i = channels * v; i < channels * (v + 1); i++) {
                irradiance[i] /= Math.max(1, copies[v]);
            }
            bulge.show(vertexKey[v], irradiance, channels * v);
            for (int c = 0; c < channels; c++) {
                irradiance[channels * v + c] *= share[c];
            }
        }
        fillBuried();
        return new Solution(mesh.original, channels, mesh.faces.lamps(), Arrays.copyOf(position, 3 * vertices),
                Arrays.copyOf(irradiance, channels * vertices), Arrays.copyOf(corner, 3 * elements),
                Arrays.copyOf(faceOf, elements), shots, rounds, unshotFlux, ledger, state);
    }

    /**
     * Gives a buried vertex the mean irradiance of its known neighbours, so that no dark seam shows, layer by layer
     * inwards: a buried vertex may be the corner of a large element that is partly visible.
     */
    private void fillBuried() {
        boolean[] known = new boolean[index.size()];
        for (int v = 0; v < known.length; v++) {
            known[v] = copies[v] > 0;
        }
        boolean more = IntStream.range(0, known.length).anyMatch(v -> !known[v]);
        while (more) {
            more = fillBeside(known);
        }
    }

    /**
     * Fills buried vertices that share an element with a known vertex.
     *
     * @param known modified: 1 per vertex, whether its irradiance is known
     * @return whether a vertex was filled
     */
    private boolean fillBeside(boolean[] known) {
        double[] sum = new double[channels * known.length];
        int[] terms = new int[known.length];
        for (int i = 0; i < 3 * elements; i++) {
            int v = corner[i];
            for (int k = 0; k < 3 && !known[v]; k++) {
                int other = corner[3 * (i / 3) + k];
                if (known[other]) {
                    terms[v]++;
                    for (int c = 0; c < channels; c++) {
                        sum[channels * v + c] += irradiance[channels * other + c];
                    }
                }
            }
        }
        boolean filled = false;
        for (int v = 0; v < known.length; v++) {
            for (int c = 0; c < channels && terms[v] > 0; c++) {
                irradiance[channels * v + c] = sum[channels * v + c] / terms[v];
            }
            filled |= terms[v] > 0;
            known[v] |= terms[v] > 0;
        }
        return filled;
    }
}
