package radiosity.partition;

import radiosity.mesh.RadiosityNodes;

/**
 * Decides that an element is subdivided (section 2.5 of the paper) where the radiosities at its vertices differ by more
 * than a threshold.
 */
final class AdaptiveMeshing {

    /** Most levels of an element below its patch: at a sharp shadow the difference never falls below the threshold. */
    private static final int DEEPEST = 4;

    private final double threshold;

    /** @param threshold largest radiosity difference between vertices of an element, W/m²; infinite: no subdivision */
    AdaptiveMeshing(double threshold) {
        this.threshold = threshold;
    }

    boolean isOn() {
        return threshold < Double.POSITIVE_INFINITY;
    }

    /** Whether a node is an element that is to be divided. Reads the light of this element only. */
    boolean wants(RadiosityNodes nodes, int node) {
        return nodes.isElement(node) && nodes.depthBelowPatch(node) < DEEPEST && difference(nodes, node) > threshold;
    }

    /** Largest difference of radiosity between two corners of an element, over the colours, W/m². */
    private static double difference(RadiosityNodes nodes, int node) {
        double largest = 0;
        for (int c = 0; c < nodes.faces().colours(); c++) {
            double a = radiosity(nodes, node, 0, c);
            double b = radiosity(nodes, node, 1, c);
            double d = radiosity(nodes, node, 2, c);
            double range = Math.max(a, Math.max(b, d)) - Math.min(a, Math.min(b, d));
            largest = Math.max(largest, range);
        }
        return largest;
    }

    /** Radiosity of one colour at corner k of an element, summed over the layers, W/m². */
    private static double radiosity(RadiosityNodes nodes, int node, int k, int colour) {
        double sum = 0;
        for (int c = colour; c < nodes.channels(); c += nodes.faces().colours()) {
            sum += nodes.light().radiosity(node, k, c);
        }
        return sum;
    }
}
