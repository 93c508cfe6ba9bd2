package radiosity.output.lightmap;

import java.util.stream.IntStream;
import radiosity.output.image.Picture;
import radiosity.scene.Rgb;

/** A texture into which elements are drawn: each texel takes the light at its middle. */
final class Texels {

    /** A texel whose middle lies this far outside an element, in weights, still belongs to it. */
    private static final double EDGE = 1e-6;

    private final int width;
    private final int height;
    /** 3 per texel, row by row from the top. */
    private final float[] rgb;
    /** 1 per texel: whether anything was drawn on it. */
    private final boolean[] known;

    Texels(int width, int height) {
        this.width = width;
        this.height = height;
        rgb = new float[3 * width * height];
        known = new boolean[width * height];
    }

    /** The light at a point of a triangle. */
    interface Light {

        /**
         * @param v weight of corner 1
         * @param w weight of corner 2
         */
        Rgb at(double v, double w);
    }

    /**
     * Draws a triangle.
     *
     * @param x     of its corners, texels; not modified
     * @param y     of its corners, texels; not modified
     */
    void draw(double[] x, double[] y, Light light) {
        double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        if (area == 0) {
            return;
        }
        int bottom = last(Math.max(y[0], Math.max(y[1], y[2])), height);
        int right = last(Math.max(x[0], Math.max(x[1], x[2])), width);
        for (int j = first(Math.min(y[0], Math.min(y[1], y[2]))); j <= bottom; j++) {
            for (int i = first(Math.min(x[0], Math.min(x[1], x[2]))); i <= right; i++) {
                double px = i + 0.5 - x[0];
                double py = j + 0.5 - y[0];
                double v = (px * (y[2] - y[0]) - (x[2] - x[0]) * py) / area;
                double w = ((x[1] - x[0]) * py - px * (y[1] - y[0])) / area;
                if (v >= -EDGE && w >= -EDGE && v + w <= 1 + EDGE) {
                    set(j * width + i, light.at(v, w));
                }
            }
        }
    }

    private static int first(double least) {
        return Math.max(0, (int) Math.floor(least - 0.5));
    }

    private static int last(double most, int size) {
        return Math.min(size - 1, (int) Math.ceil(most - 0.5));
    }

    private void set(int texel, Rgb light) {
        for (int c = 0; c < 3; c++) {
            rgb[3 * texel + c] = (float) light.channel(c);
        }
        known[texel] = true;
    }

    /**
     * What was drawn, continued beyond its edges: a texel on which nothing was drawn takes its neighbours' mean. The
     * picture shares the array of these texels.
     */
    Picture padded(int texels) {
        for (int ring = 0; ring < texels; ring++) {
            int[] edge = IntStream.range(0, known.length).filter(t -> !known[t] && isBesideKnown(t)).toArray();
            for (int t : edge) {
                setMean(t); // of texels that are known: none of the edge is yet
            }
            for (int t : edge) {
                known[t] = true;
            }
        }
        return new Picture(width, height, rgb);
    }

    private boolean isBesideKnown(int texel) {
        int x = texel % width;
        int y = texel / width;
        for (int j = Math.max(0, y - 1); j <= Math.min(height - 1, y + 1); j++) {
            for (int i = Math.max(0, x - 1); i <= Math.min(width - 1, x + 1); i++) {
                if (known[j * width + i]) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Gives a texel the mean of its known neighbours, of which there are some. */
    private void setMean(int texel) {
        int count = 0;
        float[] sum = new float[3];
        int x = texel % width;
        int y = texel / width;
        for (int j = Math.max(0, y - 1); j <= Math.min(height - 1, y + 1); j++) {
            for (int i = Math.max(0, x - 1); i <= Math.min(width - 1, x + 1); i++) {
                int n = j * width + i;
                if (known[n]) {
                    count++;
                    for (int c = 0; c < 3; c++) {
                        sum[c] += rgb[3 * n + c];
                    }
                }
            }
        }
        for (int c = 0; c < 3; c++) {
            rgb[3 * texel + c] = sum[c] / count;
        }
    }
}
