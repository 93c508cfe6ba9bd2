package radiosity.mesh;

import java.util.Arrays;
import radiosity.util.ArraySize;
import radiosity.util.LongIndex;

/**
 * What is shown at vertices beyond the light that arrives there. Where light is curved, straight lines between vertices
 * lose some of it: elements reflect it ({@link ElementLight#bulge}), and pictures would not show it. So a vertex shows
 * the mean of what the elements around it have more, by their areas. What is shown then carries the flux that elements
 * receive, and is nearer to the light over their areas, as the best fit by straight lines is.
 */
public final class VertexBulge {

    private final int channels;
    private final LongIndex index = new LongIndex(1024);
    /** channels per vertex: sum over the elements around it of area times bulge, W/m² of the scene's squared size. */
    private double[] flux;
    /** 1 per vertex: area of those elements, of the scene's squared size. */
    private double[] area = new double[1024];

    public VertexBulge(int channels) {
        this.channels = channels;
        flux = new double[channels * area.length];
    }

    /**
     * Adds all elements of some blocks; nothing of those that gather anew.
     *
     * @param dark the round whose new vertices have not gathered yet; 0 where there is none
     */
    public void add(RadiosityNodes nodes, int dark) {
        for (int node = 0; node < nodes.nodes(); node++) {
            if (nodes.isElement(node) && !nodes.isPoint(node) && !nodes.isSetAside()) {
                add(nodes, node, hasGathered(nodes, nodes.parent(node), dark));
            }
        }
    }

    /** Whether an inner node knows the light at the middles of its edges. */
    private static boolean hasGathered(RadiosityNodes nodes, int parent, int dark) {
        boolean all = parent >= 0;
        for (int k = 0; k < 3 && all && dark != 0; k++) {
            all = nodes.made(nodes.corner(nodes.child(parent) + 3, k)) != dark;
        }
        return all;
    }

    private void add(RadiosityNodes nodes, int node, boolean curves) {
        double its = nodes.area(node);
        for (int k = 0; k < 3; k++) {
            int v = index.findOrAdd(nodes.vertexKey(nodes.corner(node, k)), index.size());
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

    /** The irradiance that a vertex shows, W/m²: it takes away no more than has arrived. */
    public double shown(long vertexKey, int channel, double arrived) {
        int v = index.find(vertexKey);
        double more = v < 0 ? 0 : flux[channels * v + channel] / area[v];
        return arrived + Math.max(more, -Math.max(0, arrived));
    }
}
