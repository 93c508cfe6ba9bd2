package radiosity.partition;

import java.util.List;
import radiosity.mesh.Patcher;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.protocol.Mark;
import radiosity.settings.Accuracy;
import radiosity.util.ParallelFor;

/**
 * Divides elements where the light at the middle of an edge is not the mean of the light at the edge's ends: linear
 * interpolation errs there. Elements on which independent points have found an error are divided, too.
 *
 * <p>The middles of a parent's edges are vertices of its children. The difference between the irradiance at a middle
 * and the mean of the edge's ends is the error that the parent would have as an element; where that error is too large,
 * the children that have the middle as a corner are divided. The decision reads only vertices of the element and of its
 * ancestors, so it does not depend on how blocks are dealt.
 *
 * <p>All errors are differences of radiosity (irradiance times {@linkplain Faces#importance importance}) relative to
 * the mean radiosity (see {@link Weights}), the largest over the channels.
 */
public final class MeshRefinement {

    /** Largest number of nodes that a thread examines at a time. */
    private static final int RUN = 256;
    /** Stands for the children of an element: a node is an element when decisions begin, and may be divided later. */
    private static final byte UNKNOWN = -1;
    /** Share of the total area below which no element is divided: its corners, as floats, might coincide. */
    private static final double LEAST_AREA = 1e-10;
    /**
     * Largest error of irradiance times share of area on a bright element, in units of {@link #meshError}. Where the
     * light curves the same way on many elements their errors add up, and a surface that reflects most of a lamp's
     * light passes the sum on to the whole room. So does a black surface, as flux that it receives in excess is taken
     * from all.
     */
    private static final double FLUX = 0.005;
    /** Radiosity relative to the mean radiosity below which a surface looks black. */
    private static final double BLACK = 0.01;
    /** Elements may be merged if the error of the merged element is below this part of the refinement threshold. */
    private static final double COARSE = 0.25;

    private final RadiosityNodes nodes;
    private final Faces faces;
    private final Weights weights;
    private final double meshError;
    private final double area;

    /**
     * @param weights   1 / mean radiosity, m²/W
     * @param meshError largest error times square root of the share of area that an element may have; an error on a
     *                  bright element is divided by the brightness of the element
     */
    public MeshRefinement(RadiosityNodes nodes, Weights weights, double meshError) {
        this.nodes = nodes;
        faces = nodes.faces();
        this.weights = weights;
        this.meshError = meshError;
        area = faces.area();
    }

    /**
     * Divides all elements that need it. All threads decide about the children of inner nodes before any element is
     * divided; the children of an element divided here are decided afterwards, and may be divided in the same call.
     *
     * @param round number of the round: new vertices are shared among splits of the same number
     * @param marks nodes to divide whatever their vertices have received
     */
    void splitAll(int round, List<Mark> marks, ParallelFor parallel) {
        byte[] wanted = new byte[nodes.nodes()];
        parallel.run(wanted.length, RUN, (from, to) -> {
            for (int node = from; node < to; node++) {
                wanted[node] = nodes.isElement(node) ? UNKNOWN : wanted(node);
            }
        });
        nodes.beginSplits(count(wanted) + marks.size());
        for (int node = 0; node < wanted.length; node++) {
            if (!nodes.isElement(node)) {
                splitChildren(node, wanted[node] == UNKNOWN ? wanted(node) : wanted[node], round);
            }
        }
        for (int top : nodes.tops()) {
            if (nodes.isElement(top) && wantsTop(top)) {
                nodes.split(top, round);
            }
        }
        marks.forEach(mark -> divide(mark, round));
    }

    /** Divides a marked node if it is in a block of this partition: first the element of which it is a part. */
    private void divide(Mark mark, int round) {
        int depth = NodePath.level(mark.path());
        int level = depth;
        int node = nodes.find(mark.face(), mark.path());
        while (node < 0 && level > 0) {
            level--;
            node = nodes.find(mark.face(), mark.path() >> 2 * (depth - level));
        }
        while (node >= 0 && level <= depth) {
            if (nodes.isElement(node)) {
                if (nodes.area(node) / area <= LEAST_AREA) {
                    return;
                }
                nodes.split(node, round);
            }
            level++;
            node = level <= depth ? nodes.child(node) + NodePath.step(mark.path(), level) : -1;
        }
    }

    /**
     * Whether the four children of a node may be merged, in a scene whose light has changed: all four are elements made
     * by refinement, and the merged element would neither err by much nor be divided for an error of its parent.
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

    /** Which children of an inner node are to be divided: bit k stands for child k. */
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

    /** Errors at the middles of an inner node's three edges; number k is opposite corner k. */
    private double[] ofMiddles(int node) {
        double[] error = new double[3];
        for (int k = 0; k < 3; k++) {
            error[k] = ofMiddle(node, nodes.corner(nodes.child(node) + 3, k), k);
        }
        return error;
    }

    /** The largest of three errors at those middles that child k has as corners. */
    private static double touching(double[] error, int k) {
        double all = Math.max(error[0], Math.max(error[1], error[2]));
        return k == 3 ? all : Math.max(error[(k + 1) % 3], error[(k + 2) % 3]);
    }

    /**
     * Error of a node expected from its parent's error: a quarter of it, as where light is smooth. At the edge of a
     * shadow the node's own middles may by chance show no error at all.
     */
    private double fromAbove(int node) {
        int parent = nodes.parent(node);
        return Math.max(unseen(node), parent < 0 ? 0 : touching(ofMiddles(parent), node - nodes.child(parent)) / 4);
    }

    /**
     * Error that an inner node may have although its corners and middles are dark, as all of these may be covered: a
     * bar stands at the middle of a window sill. The error is {@link #missed} divided by 4 for each division from the
     * top node down to the children of this node; 0 where a corner or middle has a third of the mean radiosity or more.
     */
    private double unseen(int node) {
        double brightest = 0;
        for (int k = 0; k < 6; k++) {
            int v = k < 3 ? nodes.corner(node, k) : nodes.corner(nodes.child(node) + 3, k - 3);
            for (int c = 0; c < nodes.channels() && !nodes.points().isBuried(v); c++) {
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
        double most = meshError * brightness / Math.sqrt(share);
        return share > LEAST_AREA && (error > most
                || brightness > 1 && error / importance(element) * share > FLUX * meshError);
    }

    /** Error at the middle of the edge opposite corner k; {@link #ofVisible} where a vertex of the edge is buried. */
    private double ofMiddle(int parent, int middle, int k) {
        int p = nodes.corner(parent, (k + 1) % 3);
        int q = nodes.corner(parent, (k + 2) % 3);
        boolean hidden = nodes.points().isBuried(middle) || nodes.points().isBuried(p) || nodes.points().isBuried(q);
        double largest = 0;
        for (int c = 0; c < nodes.channels(); c++) {
            double difference = hidden ? ofVisible(parent, c)
                    : Math.abs(at(middle, c) - (at(p, c) + at(q, c)) / 2);
            largest = Math.max(largest, weigh(parent, c, difference));
        }
        return largest;
    }

    /**
     * Difference of irradiance at the middle of an edge of a node that is partly covered by a solid, W/m²: half the
     * range over the node's corners and middles that are not buried; half the irradiance where only one is not buried.
     */
    private double ofVisible(int parent, int c) {
        double low = Double.POSITIVE_INFINITY;
        double high = 0;
        int seen = 0;
        for (int k = 0; k < 6; k++) {
            int v = k < 3 ? nodes.corner(parent, k) : nodes.corner(nodes.child(parent) + 3, k - 3);
            if (!nodes.points().isBuried(v)) {
                seen++;
                low = Math.min(low, at(v, c));
                high = Math.max(high, at(v, c));
            }
        }
        return seen > 1 ? (high - low) / 2 : high / 2;
    }

    /**
     * Whether a top node that is an element is to be divided. Where such an element is dark, or has corners of its own,
     * another part of the element may have other light, as where a solid covers the middle.
     */
    private boolean wantsTop(int top) {
        double error = ofTop(top);
        return wants(top, error) || (error <= 0 || !nodes.isPoint(top)) && wantsUnseen(top);
    }

    /**
     * Whether a top node is to be divided by its area alone. A top node has no parent, so nothing is known of the light
     * between its receiving points, even if these are dark: its error may be all of its light. A black one is divided
     * if its visible part is large enough to be looked at, as a canvas whose corners lie in its frame.
     */
    private boolean wantsUnseen(int top) {
        double share = nodes.area(top) / area;
        return share > LEAST_AREA && (missed(top) * Math.sqrt(share) > meshError
                || share > Patcher.POINT && isBlack(top));
    }

    /**
     * Whether a node looks black at all of its corners, though it can be seen: a corner lies outside of solids, or less
     * of the face is hidden than the area of the node.
     */
    private boolean isBlack(int node) {
        double brightest = 0;
        int face = nodes.face(node);
        double wholeArea = faces.area(face, nodes.path(node));
        boolean isVisible = faces.mostHiddenArea(face) < wholeArea;
        for (int k = 0; k < 3; k++) {
            isVisible |= !nodes.points().isBuried(nodes.corner(node, k));
            for (int c = 0; c < nodes.channels(); c++) {
                brightest = Math.max(brightest, weigh(node, c, at(nodes.corner(node, k), c)));
            }
        }
        return isVisible && brightest < BLACK;
    }

    /** Largest error of a node if all of its light is missed: errors of a bright node are relative to its own light. */
    private double missed(int node) {
        return Accuracy.BRIGHT * importance(node);
    }

    /** Largest {@linkplain Faces#importance importance} of a node's face, over the channels. */
    private double importance(int node) {
        double importance = 0;
        for (int c = 0; c < nodes.channels(); c++) {
            importance = Math.max(importance, faces.importance(nodes.face(node), c));
        }
        return importance;
    }

    /**
     * Error of a top node that is an element: a quarter of its light, as the light between its corners, or around its
     * middle where it receives at its middle only, is not known.
     */
    private double ofTop(int node) {
        double largest = 0;
        for (int c = 0; c < nodes.channels(); c++) {
            double most = 0;
            for (int k = 0; k < 3; k++) {
                most = Math.max(most, nodes.light().irradiance(node, k, c));
            }
            largest = Math.max(largest, weigh(node, c, most / 4));
        }
        return largest;
    }

    /** Mean radiosity of an element, relative to a {@linkplain Accuracy#BRIGHT bright} radiosity; at least 1. */
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

    /** Radiosity, relative to the mean radiosity, of a node with this irradiance in W/m². */
    private double weigh(int node, int c, double irradiance) {
        return irradiance * faces.importance(nodes.face(node), c) * weights.at(nodes.face(node), c);
    }

    private double at(int vertex, int c) {
        return nodes.light().irradiance()[nodes.channels() * vertex + c];
    }
}
