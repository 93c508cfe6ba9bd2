package radiosity.patch;

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

    /** Largest difference of radiosity between two corners, over the channels, W/m². */
    private static double difference(RadiosityNodes nodes, int node) {
        double largest = 0;
        for (int c = 0; c < nodes.channels(); c++) {
            double a = nodes.radiosity(node, 0, c);
            double b = nodes.radiosity(node, 1, c);
            double d = nodes.radiosity(node, 2, c);
            double range = Math.max(a, Math.max(b, d)) - Math.min(a, Math.min(b, d));
            largest = Math.max(largest, range);
        }
        return largest;
    }
}
