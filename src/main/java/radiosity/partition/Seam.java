package radiosity.partition;

import java.util.BitSet;
import java.util.LinkedHashSet;
import java.util.Set;
import radiosity.mesh.RadiosityNodes;
import radiosity.protocol.BlockState;
import radiosity.protocol.Wire;

/**
 * Patches of a host at some of whose corners others gather. In the paper's schedule everybody looks at all patches in
 * every round, so these are left to the master: with every answer it is told what has arrived at their corners.
 */
public final class Seam {

    private final RadiosityNodes nodes;
    private final GhostVertices border;
    /** Tops of these patches: parents, as seen from which light between corners is found. */
    private final int[] tops;
    private final BitSet patches = new BitSet();

    Seam(RadiosityNodes nodes, GhostVertices border) {
        this.nodes = nodes;
        this.border = border;
        Set<Integer> torn = new LinkedHashSet<>();
        for (int i = 0; i < nodes.patches(); i++) {
            if (isTorn(nodes.patch(i))) {
                torn.add(top(i));
            }
        }
        tops = torn.stream().mapToInt(Integer::intValue).toArray();
        for (int i = 0; i < nodes.patches(); i++) {
            patches.set(i, torn.contains(top(i)));
        }
    }

    private boolean isTorn(int patch) {
        return border.isTaken(nodes.corner(patch, 0)) || border.isTaken(nodes.corner(patch, 1))
                || border.isTaken(nodes.corner(patch, 2));
    }

    private int top(int i) {
        int parent = nodes.parent(nodes.patch(i));
        return parent < 0 ? nodes.patch(i) : parent;
    }

    /** Which these are, of all patches of the host. */
    BitSet patches() {
        return patches;
    }

    /**
     * Makes the host tell what arrives at their corners, and says what the master needs to know, see {@link
     * GhostReport}.
     */
    byte[] report() {
        border.giveAlso(corners());
        return Wire.bytes(out -> {
            out.writeInt(tops.length);
            for (int top : tops) {
                out.writeInt(nodes.face(top));
                out.writeLong(nodes.path(top));
            }
            Wire.write(out, BlockState.write(nodes, tops));
            Wire.write(out, border.givenKeys());
        });
    }

    private BitSet corners() {
        BitSet corners = new BitSet();
        patches.stream().forEach(i -> {
            for (int k = 0; k < 3; k++) {
                corners.set(nodes.corner(nodes.patch(i), k));
            }
        });
        return corners;
    }
}
