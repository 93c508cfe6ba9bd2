package radiosity.mesh.face;

import radiosity.scene.Raster;
import radiosity.scene.Rgb;

/**
 * The means of a picture under a face and under the nodes below it, down to the size of its pixels.
 *
 * <p>The mean under a node is that of its four children, so what is summed over elements is the same on every mesh. A
 * node that is smaller than the smallest here has what the one around it has.
 */
final class FaceMap {

    /** Levels below the face: 4096 parts. */
    private static final int DEEPEST = 6;
    /** A part that covers fewer pixels is not divided. */
    private static final double PIXELS = 4;

    private final int depth;
    /** 3 per node, level by level; within a level in the order of {@link NodePath}. */
    private final float[] mean;

    /**
     * @param u of the face's corners, in the face's order; not modified
     * @param v of the face's corners, upwards; not modified
     */
    FaceMap(Raster raster, double[] u, double[] v) {
        int levels = 0;
        for (double pixels = raster.pixels(u, v); pixels > PIXELS && levels < DEEPEST; pixels /= 4) {
            levels++;
        }
        depth = levels;
        mean = new float[3 * first(depth + 1)];
        fill(raster, u, v, 0, 0);
    }

    /** Number of nodes above a level. */
    private static int first(int level) {
        return ((1 << 2 * level) - 1) / 3;
    }

    private void fill(Raster raster, double[] u, double[] v, int level, int number) {
        int at = 3 * (first(level) + number);
        if (level == depth) {
            Rgb here = raster.mean(u, v);
            for (int c = 0; c < 3; c++) {
                mean[at + c] = (float) here.channel(c);
            }
            return;
        }
        for (int k = 0; k < 4; k++) {
            fill(raster, Subdivision.values(u, 1, k), Subdivision.values(v, 1, k), level + 1, 4 * number + k);
        }
        int child = 3 * (first(level + 1) + 4 * number);
        for (int c = 0; c < 3; c++) {
            mean[at + c] = (mean[child + c] + mean[child + 3 + c] + mean[child + 6 + c] + mean[child + 9 + c]) / 4;
        }
    }

    /** Under a node. */
    double at(long path, int colour) {
        int level = Math.min(depth, NodePath.level(path));
        int number = (int) (path >>> 2 * (NodePath.level(path) - level)) & (1 << 2 * level) - 1;
        return mean[3 * (first(level) + number) + colour];
    }
}
