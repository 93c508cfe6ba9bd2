package radiosity.mesh;

/**
 * When an element is subdivided (section 2.5 of the paper): when the radiosities at its vertices differ by more than a
 * threshold.
 */
public final class AdaptiveMeshing {

    /** At a sharp shadow the difference never falls: no element is divided deeper than this below its patch. */
    static final int DEEPEST = 4;

    private final double threshold;

    /** @param threshold largest difference between two vertices of an element, W/m²; infinite: no subdivision */
    public AdaptiveMeshing(double threshold) {
        this.threshold = threshold;
    }

    public boolean isOn() {
        return threshold < Double.POSITIVE_INFINITY;
    }

    /** Decided from the element's own values. */
    public boolean wants(RadiosityNodes nodes, int node) {
        return nodes.isElement(node) && nodes.depthBelowPatch(node) < DEEPEST && difference(nodes, node) > threshold;
    }

    /** Largest difference of radiosity between two corners, over the colours, W/m². */
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

    /** Of all layers. */
    private static double radiosity(RadiosityNodes nodes, int node, int k, int colour) {
        double sum = 0;
        for (int c = colour; c < nodes.channels(); c += nodes.faces().colours()) {
            sum += nodes.light().radiosity(node, k, c);
        }
        return sum;
    }
}
