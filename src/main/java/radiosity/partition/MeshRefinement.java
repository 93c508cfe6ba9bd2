package radiosity.partition;

import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.settings.Accuracy;
import radiosity.util.ParallelFor;

/**
 * Where the mesh is too coarse for the light on it: where the middle of an edge has not what lies between its ends.
 *
 * <p>The middles of a parent's edges are vertices of its children. By how much they differ from the mean of the edge's
 * ends is the error that the parent would have had; a child that touches such a middle is divided. Decided from the
 * element's own surroundings only.
 */
public final class MeshRefinement {

    /** Nodes that a thread looks at at a time. */
    private static final int RUN = 256;
    /** Of which it is not decided yet which of its children are divided. */
    private static final byte UNKNOWN = -1;
    /** Part of all area below which an element is left: corners that are floats could not be told apart. */
    private static final double LEAST_AREA = 1e-10;
    /**
     * Flux that interpolation on a bright element may add, relative to all that is reflected and to the error that it
     * may add: where light curves one way, many elements have too much of it, and what reflects most of a lamp's light
     * hands that on to everything.
     */
    private static final double FLUX = 0.005;
    /** Error that four elements may have as one for not to be divided again soon, of that at which it is divided. */
    private static final double COARSE = 0.25;

    private final RadiosityNodes nodes;
    private final Faces faces;
    private final Weights weights;
    private final double meshError;
    private final double area;

    /**
     * @param weights   1 / mean radiosity, m²/W
     * @param meshError error times square root of area that an element may have, relative to the mean, or to what
     *                  is there where that is bright, and to the whole area
     */
    public MeshRefinement(RadiosityNodes nodes, Weights weights, double meshError) {
        this.nodes = nodes;
        faces = nodes.faces();
        this.weights = weights;
        this.meshError = meshError;
        area = faces.area();
    }

    /**
     * Most is decided by all threads before anything is divided; of what is divided now the parts are looked at
     * afterwards: their parents' middles are known.
     *
     * @param round what the new vertices are shared by
     */
    void splitAll(int round, ParallelFor parallel) {
        byte[] wanted = new byte[nodes.nodes()];
        parallel.run(wanted.length, RUN, (from, to) -> {
            for (int node = from; node < to; node++) {
                wanted[node] = nodes.isElement(node) ? UNKNOWN : wanted(node);
            }
        });
        nodes.beginSplits(count(wanted));
        for (int node = 0; node < wanted.length; node++) {
            if (!nodes.isElement(node)) {
                splitChildren(node, wanted[node] == UNKNOWN ? wanted(node) : wanted[node], round);
            }
        }
        for (int top : nodes.tops()) {
            if (nodes.isElement(top) && (nodes.isPoint(top) ? wants(top, ofPoint(top)) : wantsUnseen(top))) {
                nodes.split(top, round);
            }
        }
    }

    /**
     * Whether a node has four elements where one would do, in a scene whose light has changed since, and that one would
     * not be divided again for what is beside it.
     */
    public boolean isTooFine(int node) {
        for (int k = 0; k < 4; k++) {
            if (nodes.isElement(node) || !nodes.isElement(nodes.child(node) + k)) {
                return false;
            }
        }
        return nodes.dividedWith(node) > 0 && !wantsFromAbove(node)
                && !wants(node, Math.max(touching(ofMiddles(node), 3), fromAbove(node)) / COARSE);
    }

    private boolean wantsFromAbove(int node) {
        int parent = nodes.parent(node);
        return parent < 0 ? wantsUnseen(node) : wants(node, Math.max(fromAbove(parent),
                touching(ofMiddles(parent), node - nodes.child(parent))));
    }

    private static int count(byte[] wanted) {
        int count = 0;
        for (byte children : wanted) {
            count += children == UNKNOWN ? 0 : Integer.bitCount(children);
        }
        return count;
    }

    /** Which children of a node are to be divided, as bits. */
    private byte wanted(int parent) {
        double[] error = ofMiddles(parent);
        double before = fromAbove(parent);
        int wanted = 0;
        for (int k = 0; k < 4; k++) {
            int child = nodes.child(parent) + k;
            boolean wants = nodes.isElement(child) && wants(child, Math.max(before, touching(error, k)));
            wanted |= wants ? 1 << k : 0;
        }
        return (byte) wanted;
    }

    private void splitChildren(int parent, byte wanted, int round) {
        for (int k = 0; k < 4; k++) {
            if ((wanted >> k & 1) == 1) {
                nodes.split(nodes.child(parent) + k, round);
            }
        }
    }

    /** Of a node's three edges. */
    private double[] ofMiddles(int node) {
        double[] error = new double[3];
        for (int k = 0; k < 3; k++) {
            error[k] = ofMiddle(node, nodes.corner(nodes.child(node) + 3, k), k);
        }
        return error;
    }

    /** The largest error at a middle that child k has as a corner. */
    private static double touching(double[] error, int k) {
        double all = Math.max(error[0], Math.max(error[1], error[2]));
        return k == 3 ? all : Math.max(error[(k + 1) % 3], error[(k + 2) % 3]);
    }

    /**
     * What a node's own middles should differ by after what its parent's did: a quarter where light is smooth. At the
     * edge of a shadow they may happen not to differ at all.
     */
    private double fromAbove(int node) {
        int parent = nodes.parent(node);
        return Math.max(unseen(node), parent < 0 ? 0 : touching(ofMiddles(parent), node - nodes.child(parent)) / 4);
    }

    /**
     * Where corners and middles are all dark, they may all be covered: the middle of a window sill is where the bar
     * stands. Then as much may be missed between them as on a face that nothing has divided, a quarter of it for each
     * division since.
     */
    private double unseen(int node) {
        double brightest = 0;
        for (int k = 0; k < 6; k++) {
            int v = k < 3 ? nodes.corner(node, k) : nodes.corner(nodes.child(node) + 3, k - 3);
            for (int c = 0; c < nodes.channels() && !nodes.isBuried(v); c++) {
                brightest = Math.max(brightest, weigh(node, c, at(v, c)));
            }
        }
        int divisions = 1;
        for (int above = nodes.parent(node); above >= 0; above = nodes.parent(above)) {
            divisions++;
        }
        return brightest < 1 / Accuracy.BRIGHT ? missed(node) / (1L << 2 * divisions) : 0;
    }

    private boolean wants(int element, double error) {
        double share = nodes.area(element) / area;
        double brightness = brightness(element);
        return share > LEAST_AREA && (error / brightness * Math.sqrt(share) > meshError
                || brightness > 1 && error * share > FLUX * meshError);
    }

    /** Difference of radiosity between the middle of an edge and the mean of its ends, relative to the scene's mean. */
    private double ofMiddle(int parent, int middle, int k) {
        int p = nodes.corner(parent, (k + 1) % 3);
        int q = nodes.corner(parent, (k + 2) % 3);
        boolean hidden = nodes.isBuried(middle) || nodes.isBuried(p) || nodes.isBuried(q);
        double largest = 0;
        for (int c = 0; c < nodes.channels(); c++) {
            double difference = hidden ? ofVisible(parent, c)
                    : Math.abs(at(middle, c) - (at(p, c) + at(q, c)) / 2);
            largest = Math.max(largest, weigh(parent, c, difference));
        }
        return largest;
    }

    /**
     * What lies partly under something takes its light from the corners that do not: half the difference between those,
     * and half of what is there where only one is left to tell.
     */
    private double ofVisible(int parent, int c) {
        double low = Double.POSITIVE_INFINITY;
        double high = 0;
        int seen = 0;
        for (int k = 0; k < 6; k++) {
            int v = k < 3 ? nodes.corner(parent, k) : nodes.corner(nodes.child(parent) + 3, k - 3);
            if (!nodes.isBuried(v)) {
                seen++;
                low = Math.min(low, at(v, c));
                high = Math.max(high, at(v, c));
            }
        }
        return seen > 1 ? (high - low) / 2 : high / 2;
    }

    /**
     * An original triangle has no parent: nothing is known of what lies between its corners, even if these are dark. At
     * most all of what is there is missed, and errors of what is bright are relative to that part of it.
     */
    private boolean wantsUnseen(int top) {
        double share = nodes.area(top) / area;
        return share > LEAST_AREA && missed(top) * Math.sqrt(share) > meshError;
    }

    /** Error where all light of a node is missed, as far as its surface reflects it. */
    private double missed(int node) {
        double importance = 0;
        for (int c = 0; c < nodes.channels(); c++) {
            importance = Math.max(importance, faces.importance(nodes.face(node), c));
        }
        return Accuracy.BRIGHT * importance;
    }

    /** What receives at its middle only counts a quarter of its light as error, as nothing is known of its corners. */
    private double ofPoint(int node) {
        double largest = 0;
        for (int c = 0; c < nodes.channels(); c++) {
            largest = Math.max(largest, weigh(node, c, nodes.light().irradiance(node, 0, c) / 4));
        }
        return largest;
    }

    /** How many times as bright as is {@linkplain Accuracy#BRIGHT bright} it is; at least 1. */
    private double brightness(int node) {
        int face = nodes.face(node);
        double largest = 1;
        for (int c = 0; c < nodes.channels(); c++) {
            double irradiance = 0;
            for (int k = 0; k < 3; k++) {
                irradiance += nodes.light().irradiance(node, k, c) / 3;
            }
            double radiosity = irradiance * faces.importance(face, c) + faces.exitance(face, c);
            largest = Math.max(largest, radiosity * weights.at(face, c) / Accuracy.BRIGHT);
        }
        return largest;
    }

    /** Relative to the mean radiosity. */
    private double weigh(int node, int c, double irradiance) {
        return irradiance * faces.importance(nodes.face(node), c) * weights.at(nodes.face(node), c);
    }

    private double at(int vertex, int c) {
        return nodes.light().irradiance()[nodes.channels() * vertex + c];
    }
}
