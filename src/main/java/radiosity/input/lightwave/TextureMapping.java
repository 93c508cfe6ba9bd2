package radiosity.input.lightwave;

import radiosity.input.lightwave.lwo.CornerCoordinates;
import radiosity.input.lightwave.lwo.Layer;
import radiosity.input.lightwave.lwo.TextureBlock;
import radiosity.input.lightwave.lws.Turn;
import radiosity.scene.Affine;

/**
 * The mapping of one image onto the triangles of a layer: computes texture coordinates of their corners.
 *
 * <p>Planar and cubic projections are exact within a triangle. For a cylinder or a sphere the coordinates are exact at
 * the corners and linear between them; u of a triangle across the seam is continuous and so may leave [0, 1].
 *
 * <p>Source of the formulas: the examples of image projections in the LightWave software development kit (NewTek).
 */
final class TextureMapping {

    private final TextureBlock texture;
    private final Layer layer;
    private final CornerCoordinates coordinates;
    private final Affine turned;

    TextureMapping(TextureBlock texture, Layer layer) {
        this.texture = texture;
        this.layer = layer;
        this.turned = Turn.of(texture.rotation[0], texture.rotation[1], texture.rotation[2]);
        this.coordinates = texture.projection == TextureBlock.Projection.UV
                ? new CornerCoordinates(layer, texture.map) : null;
    }

    /**
     * Texture coordinates of a triangle.
     *
     * @param polygon index of the polygon from which the triangle was cut
     * @param corners the triangle's 3 corners, as indices into all polygon corners of the layer
     * @param uv      receives u, v of each corner, 6 entries; NaN where the object gives no coordinates
     */
    void map(int polygon, int[] corners, double[] uv) {
        if (coordinates != null) {
            for (int k = 0; k < 3; k++) {
                coordinates.get(polygon, layer.polygons.point(corners[k]), uv, 2 * k);
            }
            return;
        }
        double[][] places = {place(corners[0]), place(corners[1]), place(corners[2])};
        switch (texture.projection) {
            case PLANAR -> planar(scaled(places), texture.axis, uv);
            case CUBIC -> planar(scaled(places), mainAxis(places), uv);
            default -> round(places, uv);
        }
    }

    /** A corner in the texture's own space: relative to its centre, rotated back. */
    private double[] place(int corner) {
        int p = 3 * layer.polygons.point(corner);
        double[] d = new double[3];
        for (int k = 0; k < 3; k++) {
            d[k] = layer.points.get(p + k) - texture.centre[k];
        }
        return turned.unturn(d);
    }

    /** Places divided by the texture's size. */
    private double[][] scaled(double[][] places) {
        double[][] scaled = new double[3][3];
        for (int c = 0; c < 3; c++) {
            for (int k = 0; k < 3; k++) {
                scaled[c][k] = over(places[c][k], k);
            }
        }
        return scaled;
    }

    private double over(double length, int axis) {
        return texture.size[axis] == 0 ? 0 : length / texture.size[axis];
    }

    /** Projects along x: u from z and v from y; along y: u from x and v from z; along z: u from x and v from y. */
    private static void planar(double[][] places, int axis, double[] uv) {
        for (int k = 0; k < 3; k++) {
            uv[2 * k] = places[k][axis == 0 ? 2 : 0] + 0.5;
            uv[2 * k + 1] = places[k][axis == 1 ? 2 : 1] + 0.5;
        }
    }

    private static int mainAxis(double[][] p) {
        int main = 0;
        double most = -1;
        for (int k = 0; k < 3; k++) {
            int u = (k + 1) % 3;
            int v = (k + 2) % 3;
            double n = Math.abs((p[1][u] - p[0][u]) * (p[2][v] - p[0][v]) - (p[1][v] - p[0][v]) * (p[2][u] - p[0][u]));
            if (n > most) {
                most = n;
                main = k;
            }
        }
        return main;
    }

    /** Angles about the axis, of which the size changes nothing; on a cylinder the size counts along the axis. */
    private void round(double[][] places, double[] uv) {
        for (int k = 0; k < 3; k++) {
            double[] q = upright(places[k]);
            double distance = StrictMath.hypot(q[0], q[2]);
            uv[2 * k] = distance == 0 ? Double.NaN : 1 - heading(q[0], q[2]) / (2 * Math.PI);
            uv[2 * k + 1] = texture.projection == TextureBlock.Projection.CYLINDRICAL ? over(q[1], texture.axis) + 0.5
                    : 0.5 + StrictMath.atan2(q[1], distance) / Math.PI;
        }
        keepTogether(uv);
        for (int k = 0; k < 3; k++) {
            uv[2 * k] *= texture.turns[0];
            uv[2 * k + 1] *= texture.projection == TextureBlock.Projection.SPHERICAL ? texture.turns[1] : 1;
        }
    }

    /** The point with the texture's axis turned upwards. */
    private double[] upright(double[] p) {
        return switch (texture.axis) {
            case 0 -> new double[] {p[2], p[0], -p[1]};
            case 1 -> new double[] {-p[0], p[1], p[2]};
            default -> new double[] {-p[0], p[2], -p[1]};
        };
    }

    /** Angle about the axis, radians, from -pi/2 to 3 pi/2. */
    private static double heading(double x, double z) {
        double angle = -StrictMath.atan2(x, z);
        return angle < -Math.PI / 2 ? angle + 2 * Math.PI : angle;
    }

    /** Moves each u by whole turns to within half a turn of the first; corners on the axis get the others' mean u. */
    private static void keepTogether(double[] uv) {
        double first = Double.isNaN(uv[0]) ? uv[2] : uv[0];
        double sum = 0;
        int n = 0;
        for (int k = 0; k < 3; k++) {
            if (!Double.isNaN(uv[2 * k])) {
                uv[2 * k] -= Math.rint(uv[2 * k] - first);
                sum += uv[2 * k];
                n++;
            }
        }
        for (int k = 0; k < 3 && n > 0; k++) {
            uv[2 * k] = Double.isNaN(uv[2 * k]) ? sum / n : uv[2 * k];
        }
    }
}
