package radiosity.mesh;

import java.util.Arrays;
import radiosity.util.ArraySize;
import radiosity.util.LongIndex;

/**
 * Corrects the displayed irradiance of vertices for curvature. Where irradiance is curved, linear interpolation loses
 * flux; elements reflect this flux ({@link ElementLight#bulge}), but pictures would not show it. So a vertex shows its
 * irradiance plus the area-weighted mean bulge of the elements around it. The display then carries the flux that
 * elements receive and, like a least-squares linear fit, is nearer to the true irradiance.
 */
public final class VertexBulge {

    /**
     * Largest part of a vertex's irradiance that a correction takes: light with a step, as at the edge of a shadow, has
     * a bulge that says nothing of a curve, and would turn the vertex black.
     */
    private static final double MOST_TAKEN = 0.5;

    private final int channels;
    private final int colours;
    private final LongIndex index = new LongIndex(1024);
    /** channels per vertex: area times bulge summed over the elements around it, W/m² times squared scene size. */
    private double[] flux;
    /** 1 per vertex: area of the elements around the vertex, in squared scene sizes. */
    private double[] area = new double[1024];

    /** @param colours channels of one lamp or of all light together, 1 or 3; divides {@code channels} */
    public VertexBulge(int channels, int colours) {
        this.channels = channels;
        this.colours = colours;
        flux = new double[channels * area.length];
    }

    /**
     * Adds all elements of some blocks; adds nothing where their vertices gather anew.
     *
     * @param dark number of the split whose new vertices have not gathered yet; 0 where all have
     */
    public void add(RadiosityNodes nodes, int dark) {
        for (int node = 0; node < nodes.nodes(); node++) {
            if (nodes.isElement(node) && !nodes.isPoint(node) && !nodes.points().isSetAside()) {
                add(nodes, node, hasGathered(nodes, nodes.parent(node), dark));
            }
        }
    }

    /** Whether the vertices at the middles of a node's edges have gathered; false without a node (parent -1). */
    private static boolean hasGathered(RadiosityNodes nodes, int parent, int dark) {
        boolean all = parent >= 0;
        for (int k = 0; k < 3 && all && dark != 0; k++) {
            all = nodes.points().made(nodes.corner(nodes.child(parent) + 3, k)) != dark;
        }
        return all;
    }

    private void add(RadiosityNodes nodes, int node, boolean curves) {
        double its = nodes.area(node);
        for (int k = 0; k < 3; k++) {
            int v = index.findOrAdd(nodes.points().key(nodes.corner(node, k)), index.size());
            if (v == area.length) {
                int room = ArraySize.room("curved light at vertices in " + channels + " channels", v + 1L, 2L * v,
                        channels);
                area = Arrays.copyOf(area, room);
                flux = Arrays.copyOf(flux, channels * room);
            }
            area[v] += its;
            for (int c = 0; c < channels && curves; c++) {
                flux[channels * v + c] += its * nodes.light().bulge(node, c);
            }
        }
    }

    /**
     * Corrects the irradiance of a vertex. Of a channel at most {@link #MOST_TAKEN} is taken; where the bulge is more,
     * as at the edge of a shadow, the corrections of all colours are reduced alike, and the vertex keeps its hue.
     *
     * @param irradiance that arrived, W/m², one per channel from {@code first}; modified
     */
    public void show(long vertexKey, double[] irradiance, int first) {
        int v = index.find(vertexKey);
        for (int c = 0; v >= 0 && c < channels; c += colours) {
            double part = 1;
            for (int k = c; k < c + colours; k++) {
                double taken = -flux[channels * v + k] / area[v];
                double most = MOST_TAKEN * Math.max(0, irradiance[first + k]);
                part = taken > most ? Math.min(part, most / taken) : part;
            }
            for (int k = c; k < c + colours; k++) {
                irradiance[first + k] += part * flux[channels * v + k] / area[v];
            }
        }
    }
}
