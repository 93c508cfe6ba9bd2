package radiosity.prediction;

import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.mesh.face.Subdivision;
import radiosity.setup.InitialMesh;

/**
 * An irradiance on the coarse mesh that {@link CoarseSystem#irradiance} has predicted, linear between the corners of
 * each patch, as the finer mesh receives it.
 *
 * <p>In the terms of multigrid methods this is the correction on a coarse grid and its prolongation (A. Brandt,
 * Multi-level adaptive solutions to boundary-value problems, 1977): what is left to distribute is small and smooth, so
 * that the coarse mesh's form factors are exact enough for it.
 */
public final class CoarseIrradiance {

    private final Faces faces;
    private final int channels;
    private final RadiosityNodes nodes;
    private final double[] corners;

    /** @param corners see {@link CoarseSystem#corners}; not copied, not modified */
    public CoarseIrradiance(InitialMesh mesh, double[] corners) {
        faces = mesh.faces;
        channels = faces.channels();
        nodes = new RadiosityNodes(mesh.coarse, mesh.clusters.clusters);
        this.corners = corners;
    }

    /**
     * Adds the irradiance at a point. Any thread may call.
     *
     * @param f     the face on which the point lies
     * @param point x, y, z in the scene brought to size 1, 3 from {@code at}; not modified
     * @param to    modified: 1 per channel, W/m², from {@code toAt}
     */
    public void add(int f, float[] point, int at, double[] to, int toAt) {
        double[] weight = weights(f, point, at);
        long path = NodePath.FACE;
        int node = nodes.find(f, path);
        while (node < 0 || !nodes.isElement(node)) {
            if (NodePath.level(path) == NodePath.MAX_LEVEL) {
                throw new IllegalStateException("coarse mesh: expected a patch on face " + f + ", found none");
            }
            int step = Subdivision.enter(weight);
            path = NodePath.child(path, step);
            node = node < 0 ? nodes.find(f, path) : nodes.child(node) + step;
        }
        for (int i = 0; i < 3 * channels; i++) {
            to[toAt + i % channels] += weight[i / channels] * corners[3 * channels * node + i];
        }
    }

    /** Weights of a face's corners at the point of the face that is nearest to a point, or nearly so. */
    private double[] weights(int f, float[] point, int at) {
        double bb = 0;
        double bc = 0;
        double cc = 0;
        double pb = 0;
        double pc = 0;
        for (int a = 0; a < 3; a++) {
            double b = (double) faces.corner(f, 1, a) - faces.corner(f, 0, a);
            double c = (double) faces.corner(f, 2, a) - faces.corner(f, 0, a);
            double p = (double) point[at + a] - faces.corner(f, 0, a);
            bb += b * b;
            bc += b * c;
            cc += c * c;
            pb += p * b;
            pc += p * c;
        }
        double area = bb * cc - bc * bc;
        double b = area > 0 ? Math.max(0, (cc * pb - bc * pc) / area) : 0;
        double c = area > 0 ? Math.max(0, (bb * pc - bc * pb) / area) : 0;
        double sum = Math.max(1, b + c);
        return new double[] {1 - (b + c) / sum, b / sum, c / sum};
    }
}
