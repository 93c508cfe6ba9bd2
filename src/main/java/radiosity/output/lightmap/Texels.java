package radiosity.output.lightmap;

import java.util.Arrays;
import java.util.stream.IntStream;
import radiosity.output.image.Picture;
import radiosity.scene.Rgb;

/** A texture into which elements are drawn: each texel gets the light at its middle. */
final class Texels {

    /** How far outside an element, in barycentric weights, the middle of a texel of the element may lie. */
    private static final double EDGE = 1e-6;
    /** How far outside a triangle a filter may read at the triangle's edge, texels: the diagonal of a texel. */
    private static final double BEYOND = 1.5;

    private final int width;
    private final int height;
    /** Red, green and blue of each texel, row by row from the top. */
    private final float[] rgb;
    /** 1 per texel: whether a triangle covers the middle of the texel. */
    private final boolean[] known;
    /**
     * 1 per texel: distance to the nearest triangle drawn beyond its edges, texels; empty before {@link #drawBeyond}.
     */
    private float[] beyond = new float[0];

    Texels(int width, int height) {
        this.width = width;
        this.height = height;
        rgb = new float[3 * width * height];
        known = new boolean[width * height];
    }

    /** Gives the light at a point of a triangle. */
    interface Light {

        /**
         * @param v weight of corner 1
         * @param w weight of corner 2
         */
        Rgb at(double v, double w);
    }

    /**
     * Draws the texels whose middles lie in a triangle.
     *
     * @param x of the three corners, texels; not modified
     * @param y of the three corners, texels; not modified
     */
    void draw(double[] x, double[] y, Light light) {
        visit(x, y, 0, (texel, v, w) -> {
            if (v >= -EDGE && w >= -EDGE && v + w <= 1 + EDGE) {
                put(texel, light.at(v, w));
                known[texel] = true;
            }
        });
    }

    /**
     * Draws the texels up to {@link #BEYOND} texels outside a triangle and extrapolates the triangle's light to them,
     * so that a filter that reads across an edge finds the light of the edge. Of several triangles the nearest one
     * counts. To be called after {@link #draw} has drawn all triangles nearby.
     */
    void drawBeyond(double[] x, double[] y, Light light) {
        if (beyond.length == 0) {
            beyond = new float[width * height];
            Arrays.fill(beyond, (float) BEYOND);
        }
        visit(x, y, BEYOND, (texel, v, w) -> {
            float distance = known[texel] ? 0 : (float) distance(x, y, texel % width + 0.5, texel / width + 0.5);
            if (!known[texel] && distance < beyond[texel]) {
                beyond[texel] = distance;
                put(texel, light.at(Math.max(-1, Math.min(2, v)), Math.max(-1, Math.min(2, w))));
            }
        });
    }

    /** Clamps extrapolated light to at least 0, and to the range of the corners' light, three times as wide. */
    static Rgb within(Rgb[] h, Rgb light) {
        double[] channels = new double[3];
        Arrays.setAll(channels, c -> {
            double least = Math.min(h[0].channel(c), Math.min(h[1].channel(c), h[2].channel(c)));
            double most = Math.max(h[0].channel(c), Math.max(h[1].channel(c), h[2].channel(c)));
            return Math.max(0, Math.max(2 * least - most, Math.min(2 * most - least, light.channel(c))));
        });
        return new Rgb(channels[0], channels[1], channels[2]);
    }

    /** Is given texels, with the weights of a triangle's corners 1 and 2 at their middles. */
    private interface Visitor {
        void take(int texel, double v, double w);
    }

    /** Visits the texels of a triangle's box, enlarged by a margin on all sides; none if the triangle has no area. */
    private void visit(double[] x, double[] y, double margin, Visitor visitor) {
        double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        if (area == 0) {
            return;
        }
        int bottom = last(Math.max(y[0], Math.max(y[1], y[2])) + margin, height);
        int right = last(Math.max(x[0], Math.max(x[1], x[2])) + margin, width);
        for (int j = first(Math.min(y[0], Math.min(y[1], y[2])) - margin); j <= bottom; j++) {
            for (int i = first(Math.min(x[0], Math.min(x[1], x[2])) - margin); i <= right; i++) {
                double px = i + 0.5 - x[0];
                double py = j + 0.5 - y[0];
                double v = (px * (y[2] - y[0]) - (x[2] - x[0]) * py) / area;
                double w = ((x[1] - x[0]) * py - px * (y[1] - y[0])) / area;
                visitor.take(j * width + i, v, w);
            }
        }
    }

    /** Distance from a point outside a triangle to the triangle's nearest edge, texels. */
    private static double distance(double[] x, double[] y, double px, double py) {
        double least = Double.MAX_VALUE;
        for (int k = 0; k < 3; k++) {
            int next = (k + 1) % 3;
            double dx = x[next] - x[k];
            double dy = y[next] - y[k];
            double square = dx * dx + dy * dy;
            double along = square == 0 ? 0 : Math.max(0, Math.min(1, ((px - x[k]) * dx + (py - y[k]) * dy) / square));
            least = Math.min(least, StrictMath.hypot(px - x[k] - along * dx, py - y[k] - along * dy));
        }
        return least;
    }

    private static int first(double least) {
        return Math.max(0, (int) Math.floor(least - 0.5));
    }

    private static int last(double most, int size) {
        return Math.min(size - 1, (int) Math.ceil(most - 0.5));
    }

    private void put(int texel, Rgb light) {
        for (int c = 0; c < 3; c++) {
            rgb[3 * texel + c] = (float) light.channel(c);
        }
    }

    /**
     * Continues the drawing beyond its edges and returns it: ring by ring, the empty texels beside texels with light
     * get the mean of these neighbours. The picture shares the array of this texture.
     *
     * @param texels number of rings
     */
    Picture padded(int texels) {
        for (int t = 0; t < beyond.length; t++) {
            known[t] |= beyond[t] < BEYOND;
        }
        for (int ring = 0; ring < texels; ring++) {
            int[] edge = IntStream.range(0, known.length).filter(t -> !known[t] && isBesideKnown(t)).toArray();
            for (int t : edge) {
                setMean(t); // the mean of texels known before this ring: none of the ring is known yet
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

    /** Gives a texel the mean of its known neighbours, of which there must be at least one. */
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
