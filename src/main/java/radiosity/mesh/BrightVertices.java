package radiosity.mesh;

import radiosity.mesh.face.Faces;
import radiosity.settings.Accuracy;

/**
 * Finds vertices that are so bright that an error there counts relative to their own radiosity (see
 * {@link Accuracy#BRIGHT}) and not to the mean of the scene. Rays may carry more light there: beside a lamp most rays
 * would otherwise be spent on places whose error hardly counts.
 */
public final class BrightVertices {

    private BrightVertices() { }

    /**
     * Sets for all vertices, from their present irradiance, how bright they are, see {@link ReceivingPoints#bright}.
     *
     * @param weights 1 / mean reflected radiosity
     */
    public static void find(RadiosityNodes nodes, Weights weights) {
        for (int v = 0; v < nodes.vertices(); v++) {
            double times = times(nodes, weights, v) / Accuracy.BRIGHT;
            int powers = 0;
            while (powers < Patcher.MOST_SLACK && times >= 2L << powers) {
                powers++;
            }
            nodes.points().setBright(v, powers);
        }
    }

    /** Reflected radiosity of a vertex relative to the mean, in the channel with light in which that is least. */
    private static double times(RadiosityNodes nodes, Weights weights, int v) {
        Faces faces = nodes.faces();
        int channels = faces.channels();
        int face = nodes.points().face(v);
        double least = Double.POSITIVE_INFINITY;
        for (int c = 0; c < channels; c++) {
            double weight = faces.reflectance(face, c) * weights.at(face, c);
            double times = weight * nodes.light().irradiance()[channels * v + c];
            least = weight > 0 ? Math.min(least, times) : least;
        }
        return least < Double.POSITIVE_INFINITY ? least : 0;
    }
}
