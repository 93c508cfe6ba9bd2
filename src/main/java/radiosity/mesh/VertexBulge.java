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

    private final int channels;
    private final LongIndex index = new LongIndex(1024);
    /** channels per vertex: area times bulge summed over the elements around it, W/m² times squared scene size. */
    private double[] flux;
    /** 1 per vertex: area of the elements around the vertex, in squared scene sizes. */
    private double[] area = new double[1024];

    public VertexBulge(int channels) {
        this.channels = channels;
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

    /** The irradiance that a vertex shows, W/m²; a negative correction is at most the irradiance that arrived. */
    public double shown(long vertexKey, int channel, double arrived) {
        int v = index.find(vertexKey);
        double more = v < 0 ? 0 : flux[channels * v + channel] / area[v];
        return arrived + Math.max(more, -Math.max(0, arrived));
    }
}
