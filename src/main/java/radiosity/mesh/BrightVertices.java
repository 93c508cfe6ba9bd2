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
        int channels = nodes.faces().channels();
        for (int v = 0; v < nodes.vertices(); v++) {
            nodes.points().setBright(v, powers(nodes.faces(), nodes.points().face(v), nodes.light().irradiance(),
                    channels * v, weights));
        }
    }

    /**
     * Number of powers of two, from 0 to {@link Patcher#MOST_SLACK}, by which the tolerance for light at a place is
     * raised, as the place is bright.
     *
     * @param irradiance at the place, one per channel from {@code at}, W/m²; not modified
     * @param weights    1 / mean reflected radiosity
     */
    public static int powers(Faces faces, int face, double[] irradiance, int at, Weights weights) {
        double times = times(faces, face, irradiance, at, weights) / Accuracy.BRIGHT;
        int powers = 0;
        while (powers < Patcher.MOST_SLACK && times >= 2L << powers) {
            powers++;
        }
        return powers;
    }

    /** Reflected radiosity relative to the mean, in the channel with light in which that is least. */
    private static double times(Faces faces, int face, double[] irradiance, int at, Weights weights) {
        double least = Double.POSITIVE_INFINITY;
        for (int c = 0; c < faces.channels(); c++) {
            double weight = faces.reflectance(face, c) * weights.at(face, c);
            least = weight > 0 ? Math.min(least, weight * irradiance[at + c]) : least;
        }
        return least < Double.POSITIVE_INFINITY ? least : 0;
    }
}
