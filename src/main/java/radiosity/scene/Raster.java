package radiosity.scene;

import java.util.ArrayList;
import java.util.List;

/**
 * Reflectance or exitance of a surface as an image over its texture coordinates (section 6.1 of the paper).
 *
 * <p>Held at full size and repeatedly halved (a mipmap), so that means over triangles read few pixels. Immutable.
 */
public final class Raster {

    /** Largest n where a mean over a triangle takes one sample in each of n x n parts of the triangle. */
    private static final int MOST_STEPS = 32;

    private final ImageMap.Wrap wrapU;
    private final ImageMap.Wrap wrapV;
    private final Rgb outside;
    /** The mipmap: the full image first, each further level half as wide and high, the last one a single pixel. */
    private final List<Level> levels = new ArrayList<>();

    /**
     * One image of the mipmap.
     *
     * @param rgb 3 values per pixel, row by row from the top
     */
    private record Level(int width, int height, float[] rgb) { }

    /**
     * Makes all levels of the mipmap.
     *
     * @param rgb     reflectance, or exitance in W/m²; 3 values per pixel, row by row from the top; not copied or
     *                modified
     * @param wrapU   how the image continues where u is outside of [0, 1]
     * @param wrapV   how the image continues where v is outside of [0, 1]
     * @param outside value beyond the edges under {@link ImageMap.Wrap#NONE}
     */
    public Raster(int width, int height, float[] rgb, ImageMap.Wrap wrapU, ImageMap.Wrap wrapV, Rgb outside) {
        if (width < 1 || height < 1 || rgb.length != 3L * width * height) {
            throw new IllegalArgumentException("raster: expected 3 values for each of " + width + " x " + height
                    + " pixels, got " + rgb.length);
        }
        this.wrapU = wrapU;
        this.wrapV = wrapV;
        this.outside = outside;
        levels.add(new Level(width, height, rgb));
        while (levels.get(levels.size() - 1).rgb().length > 3) {
            levels.add(half(levels.get(levels.size() - 1)));
        }
    }

    /** Each pixel is the mean of four; a last row or column without partner is counted twice. */
    private static Level half(Level of) {
        int w = (of.width + 1) / 2;
        int h = (of.height + 1) / 2;
        float[] rgb = new float[3 * w * h];
        for (int i = 0; i < rgb.length; i++) {
            int x = 2 * (i / 3 % w);
            int y = 2 * (i / 3 / w);
            int right = Math.min(x + 1, of.width - 1);
            int below = Math.min(y + 1, of.height - 1);
            int c = i % 3;
            rgb[i] = (value(of, x, y, c) + value(of, right, y, c) + value(of, x, below, c)
                    + value(of, right, below, c)) / 4;
        }
        return new Level(w, h, rgb);
    }

    private static float value(Level level, int x, int y, int c) {
        return level.rgb[3 * (y * level.width + x) + c];
    }

    public int width() {
        return levels.get(0).width;
    }

    public int height() {
        return levels.get(0).height;
    }

    public ImageMap.Wrap wrapU() {
        return wrapU;
    }

    public ImageMap.Wrap wrapV() {
        return wrapV;
    }

    public Rgb outside() {
        return outside;
    }

    /** The full image: 3 values per pixel, row by row from the top; not to be modified. */
    public float[] rgb() {
        return levels.get(0).rgb;
    }

    /** The mean of the whole image. */
    public Rgb mean() {
        return pixel(levels.get(levels.size() - 1), 0, 0);
    }

    /** Value at a point, linear between the centres of pixels; v points upwards. */
    public Rgb at(double u, double v) {
        double x = u * width() - 0.5;
        double y = (1 - v) * height() - 0.5;
        double i = Math.floor(x);
        double j = Math.floor(y);
        double a = x - i;
        double b = y - j;
        Level whole = levels.get(0);
        Rgb above = pixel(whole, i, j).times(1 - a).plus(pixel(whole, i + 1, j).times(a));
        Rgb below = pixel(whole, i, j + 1).times(1 - a).plus(pixel(whole, i + 1, j + 1).times(a));
        return above.times(1 - b).plus(below.times(b));
    }

    private Rgb pixel(Level level, double x, double y) {
        int i = wrapped(x, level.width, wrapU);
        int j = wrapped(y, level.height, wrapV);
        return i < 0 || j < 0 ? outside
                : new Rgb(value(level, i, j, 0), value(level, i, j, 1), value(level, i, j, 2));
    }

    /** Index of a column or row of the image, or -1 where the wrap mode has no pixel. */
    private static int wrapped(double x, int size, ImageMap.Wrap wrap) {
        return switch (wrap) {
            case NONE -> x >= 0 && x < size ? (int) x : -1;
            case EDGE -> (int) Math.max(0, Math.min(size - 1, x));
            case REPEAT -> (int) (x - size * Math.floor(x / size));
            case MIRROR -> {
                int twice = (int) (x - 2.0 * size * Math.floor(x / (2.0 * size)));
                yield twice < size ? twice : 2 * size - 1 - twice;
            }
        };
    }

    /** Number of pixels of the full image that a triangle covers; u and v have 3 entries, one per corner. */
    public double pixels(double[] u, double[] v) {
        double cross = (u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]);
        return Math.abs(cross) / 2 * width() * height();
    }

    /**
     * The mean over a triangle: n x n equal parts are sampled at their centroids, in the level whose pixels are about
     * as large as a part.
     *
     * @param u of three corners; not modified
     * @param v of three corners, upwards; not modified
     */
    public Rgb mean(double[] u, double[] v) {
        double pixels = pixels(u, v);
        int n = (int) Math.max(1, Math.min(MOST_STEPS, Math.ceil(Math.sqrt(pixels))));
        int l = 0;
        for (double left = pixels / ((double) n * n); left > 2 && l < levels.size() - 1; left /= 4) {
            l++;
        }
        Rgb sum = Rgb.BLACK;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n - i; j++) {
                sum = sum.plus(at(levels.get(l), u, v, (i + 1.0 / 3) / n, (j + 1.0 / 3) / n));
                if (i + j < n - 1) {
                    sum = sum.plus(at(levels.get(l), u, v, (i + 2.0 / 3) / n, (j + 2.0 / 3) / n));
                }
            }
        }
        return sum.times(1.0 / ((double) n * n));
    }

    /**
     * @param s weight of corner 1
     * @param t weight of corner 2
     */
    private Rgb at(Level level, double[] u, double[] v, double s, double t) {
        double x = (u[0] + s * (u[1] - u[0]) + t * (u[2] - u[0])) * level.width;
        double y = (1 - v[0] - s * (v[1] - v[0]) - t * (v[2] - v[0])) * level.height;
        return pixel(level, Math.floor(x), Math.floor(y));
    }
}
