package radiosity.world;

import radiosity.patch.Faces;
import radiosity.patch.RadiosityNodes;
import radiosity.visibility.RadiosityBounds;

/**
 * Which vertices lie inside a solid, where a floor runs on below a block: whatever they look at turns its back.
 *
 * <p>Such a vertex stays black and would darken the elements around it.
 */
final class Burial {

    /** Directions about the normal: up, and five that lean by 55 degrees; x, y in the surface and z up. */
    private static final double[] DIRECTIONS = {
        0, 0, 1,
        0.819, 0, 0.574,
        0.253, 0.779, 0.574,
        -0.663, 0.481, 0.574,
        -0.663, -0.481, 0.574,
        0.253, -0.779, 0.574};
    /** Of the scene's size: where a look begins, above the surface; and how far it goes. */
    private static final float LIFT = 1e-5f;
    private static final float FAR = 4;

    private final Faces faces;
    private final RadiosityBounds bounds;
    /** 3 per original triangle: its front's normal, 0 for one with two sides. */
    private final float[] front;

    Burial(Faces faces, RadiosityBounds bounds) {
        this.faces = faces;
        this.bounds = bounds;
        front = new float[3 * faces.scene().triangles()];
        for (int f = 0; f < faces.count(); f++) {
            for (int a = 0; a < 3 && !faces.scene().surface(faces.triangle(f)).twoSided(); a++) {
                front[3 * faces.triangle(f) + a] = faces.normal(f, a);
            }
        }
    }

    /** Marks those of the vertices from first on that are buried. */
    void look(RadiosityNodes nodes, int first, int last) {
        for (int v = first; v < last; v++) {
            if (isBuried(nodes, v)) {
                nodes.bury(v);
            }
        }
    }

    private boolean isBuried(RadiosityNodes nodes, int v) {
        return isBuried(nodes.receivers(), 3 * v, nodes.vertexFace(v));
    }

    /**
     * Whether a point lies inside a solid.
     *
     * @param place x, y, z of the scene brought to size 1, 3 from {@code at}
     * @param f     the face on which it lies
     */
    boolean isBuried(float[] place, int at, int f) {
        float nx = faces.normal(f, 0);
        float ny = faces.normal(f, 1);
        float nz = faces.normal(f, 2);
        double[] frame = frame(nx, ny, nz);
        float x = place[at] + LIFT * nx;
        float y = place[at + 1] + LIFT * ny;
        float z = place[at + 2] + LIFT * nz;
        float[] hit = new float[3];
        for (int i = 0; i < DIRECTIONS.length; i += 3) {
            float[] d = new float[3];
            for (int a = 0; a < 3; a++) {
                d[a] = (float) (DIRECTIONS[i] * frame[a] + DIRECTIONS[i + 1] * frame[3 + a]
                        + DIRECTIONS[i + 2] * faces.normal(f, a));
            }
            int t = bounds.nearest(x, y, z, d[0], d[1], d[2], FAR, hit);
            if (t < 0 || front[3 * t] * d[0] + front[3 * t + 1] * d[1] + front[3 * t + 2] * d[2] <= 0) {
                return false;
            }
        }
        return true;
    }

    /** Two directions in a plane, at right angles to each other and to its normal. */
    private static double[] frame(double nx, double ny, double nz) {
        double ax = Math.abs(nx) < 0.6 ? 1 : 0;
        double ay = 1 - ax;
        double ux = -ay * nz;
        double uy = ax * nz;
        double uz = ay * nx - ax * ny;
        double length = Math.sqrt(ux * ux + uy * uy + uz * uz);
        ux /= length;
        uy /= length;
        uz /= length;
        return new double[] {ux, uy, uz, ny * uz - nz * uy, nz * ux - nx * uz, nx * uy - ny * ux};
    }
}
