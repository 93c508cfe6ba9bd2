package radiosity.mesh.face;

import java.util.Arrays;
import java.util.Optional;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.util.Hash;

/**
 * The mean reflectance or exitance of a face and of the nodes below it, as an image and colours at corners make it,
 * down to the size of pixels and to small differences of colour.
 *
 * <p>The mean of a node is the mean of its four children, so a sum over elements is the same on every mesh. A node that
 * is smaller than the smallest stored one has the value of the stored node around it.
 */
final class FaceMap {

    /** Most levels below the face: 4096 nodes on the deepest. */
    private static final int DEEPEST = 6;
    /** A node that covers fewer pixels is not divided. */
    private static final double PIXELS = 4;
    /**
     * A node with a smaller share of the area of all faces is not divided: few elements are as small, and images that
     * repeat over a hundred thousand faces would fill the memory.
     */
    private static final double LEAST_SHARE = 1.0 / (1 << 22);
    /** Largest number of samples along an edge of a node that is as small. */
    private static final int FEW_STEPS = 8;
    /** A node is not divided where the colours at its corners differ by less. */
    private static final double STEP = 1.0 / 64;

    private final int depth;
    /** 3 per node, level by level; within a level in the order of {@link NodePath}. */
    private final float[] mean;

    /**
     * The values on a triangle from which means are taken.
     *
     * @param raster     the image, if there is one
     * @param everywhere the value where there is no image
     * @param u          texture coordinate at each corner; not modified
     * @param v          texture coordinate at each corner, upwards; not modified
     * @param colours    factors for red, green and blue: 3 arrays with a value per corner; not modified
     * @param share      of the triangle in the area of all faces, above 0
     */
    record Look(Optional<Raster> raster, Rgb everywhere, double[] u, double[] v, double[][] colours, double share) {

        /** The part that child k of the triangle has. */
        Look child(int k) {
            double[][] parts = new double[3][];
            Arrays.setAll(parts, c -> Subdivision.values(colours[c], 1, k));
            return new Look(raster, everywhere, Subdivision.values(u, 1, k), Subdivision.values(v, 1, k), parts,
                    share / 4);
        }

        Rgb mean() {
            Rgb colour = new Rgb(mean(colours[0]), mean(colours[1]), mean(colours[2]));
            int steps = share > LEAST_SHARE ? Raster.MOST_STEPS : FEW_STEPS;
            return raster.map(picture -> picture.mean(u, v, steps)).orElse(everywhere).times(colour);
        }

        private static double mean(double[] of) {
            return (of[0] + of[1] + of[2]) / 3;
        }

        /** Number of levels to which the triangle is to be divided. */
        int levels() {
            int levels = 0;
            double pixels = raster.map(picture -> picture.pixels(u, v)).orElse(0.0);
            double step = 0;
            for (double[] of : colours) {
                step = Math.max(step, Arrays.stream(of).max().orElse(0) - Arrays.stream(of).min().orElse(0));
            }
            for (double left = share; (pixels > PIXELS || step > STEP) && left > LEAST_SHARE && levels < DEEPEST;
                 left /= 4) {
                pixels /= 4;
                step /= 2;
                levels++;
            }
            return levels;
        }
    }

    FaceMap(Look look) {
        depth = look.levels();
        mean = new float[3 * first(depth + 1)];
        fill(look, 0, 0);
    }

    /** Number of nodes above a level. */
    private static int first(int level) {
        return ((1 << 2 * level) - 1) / 3;
    }

    private void fill(Look look, int level, int number) {
        int at = 3 * (first(level) + number);
        if (level == depth) {
            Rgb here = look.mean();
            for (int c = 0; c < 3; c++) {
                mean[at + c] = (float) here.channel(c);
            }
            return;
        }
        for (int k = 0; k < 4; k++) {
            fill(look.child(k), level + 1, 4 * number + k);
        }
        int child = 3 * (first(level + 1) + 4 * number);
        for (int c = 0; c < 3; c++) {
            mean[at + c] = (mean[child + c] + mean[child + 3 + c] + mean[child + 6 + c] + mean[child + 9 + c]) / 4;
        }
    }

    /** The mean of a node; of its nearest stored ancestor where it is deeper. */
    double at(long path, int colour) {
        int level = Math.min(depth, NodePath.level(path));
        int number = (int) (path >>> 2 * (NodePath.level(path) - level)) & (1 << 2 * level) - 1;
        return mean[3 * (first(level) + number) + colour];
    }

    /** Mixes the means over all nodes into a digest. */
    long digest(long before) {
        long digest = before;
        for (float value : mean) {
            digest = Hash.mix(digest, Float.floatToIntBits(value));
        }
        return digest;
    }
}
