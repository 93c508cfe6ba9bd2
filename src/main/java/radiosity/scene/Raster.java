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
    public static final int MOST_STEPS = 32;
    /** Most pixels of a row of which a pixel of the row that is half as long covers a part. */
    private static final int MOST_COVERED = 3;

    private final ImageMap.Wrap wrapU;
    private final ImageMap.Wrap wrapV;
    private final Rgb outside;
    /** The largest value of a pixel. */
    private float most;
    /** The full image first, each further level half as wide and high, the last one a single pixel. */
    private final List<Level> levels;
    /** Levels of the first and the last column alone, which continue the image under {@link ImageMap.Wrap#EDGE}. */
    private final List<List<Level>> columns = new ArrayList<>();
    /** Levels of the first and the last row alone. */
    private final List<List<Level>> rows = new ArrayList<>();

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
     * @throws IllegalArgumentException where the number of values is another, or a value is negative, infinite or NaN
     */
    public Raster(int width, int height, float[] rgb, ImageMap.Wrap wrapU, ImageMap.Wrap wrapV, Rgb outside) {
        if (width < 1 || height < 1 || rgb.length != 3L * width * height) {
            throw new IllegalArgumentException("raster: expected 3 values for each of " + width + " x " + height
                    + " pixels, got " + rgb.length);
        }
        for (float value : rgb) {
            if (!(value >= 0 && value <= Float.MAX_VALUE)) {
                throw new IllegalArgumentException("raster: expected values of at least 0, got " + value);
            }
            most = Math.max(most, value);
        }
        this.wrapU = wrapU;
        this.wrapV = wrapV;
        this.outside = outside;
        Level whole = new Level(width, height, rgb);
        levels = levels(whole);
        if (wrapU == ImageMap.Wrap.EDGE) {
            columns.add(levels(part(whole, 0, 0, 1, height)));
            columns.add(levels(part(whole, width - 1, 0, 1, height)));
        }
        if (wrapV == ImageMap.Wrap.EDGE) {
            rows.add(levels(part(whole, 0, 0, width, 1)));
            rows.add(levels(part(whole, 0, height - 1, width, 1)));
        }
    }

    /** The part of an image whose first pixel is (x, y). */
    private static Level part(Level of, int x, int y, int width, int height) {
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = value(of, x + i / 3 % width, y + i / 3 / width, i % 3);
        }
        return new Level(width, height, rgb);
    }

    private static List<Level> levels(Level whole) {
        List<Level> levels = new ArrayList<>(List.of(whole));
        while (levels.get(levels.size() - 1).rgb().length > 3) {
            levels.add(half(levels.get(levels.size() - 1)));
        }
        return levels;
    }

    /** Each pixel is the mean of what it covers: of 2 x 2 pixels, or of parts of up to 3 where their number is odd. */
    private static Level half(Level of) {
        int w = (of.width + 1) / 2;
        int h = (of.height + 1) / 2;
        double[] across = parts(of.width, w);
        double[] down = parts(of.height, h);
        float[] rgb = new float[3 * w * h];
        for (int i = 0; i < w * h; i++) {
            int x = i % w;
            int y = i / w;
            int from = 3 * (first(y, of.height, h) * of.width + first(x, of.width, w));
            double r = 0;
            double g = 0;
            double b = 0;
            for (int row = 0; row < MOST_COVERED && down[MOST_COVERED * y + row] > 0; row++) {
                for (int column = 0; column < MOST_COVERED && across[MOST_COVERED * x + column] > 0; column++) {
                    double weight = down[MOST_COVERED * y + row] * across[MOST_COVERED * x + column];
                    int at = from + 3 * (row * of.width + column);
                    r += weight * of.rgb[at];
                    g += weight * of.rgb[at + 1];
                    b += weight * of.rgb[at + 2];
                }
            }
            rgb[3 * i] = (float) r;
            rgb[3 * i + 1] = (float) g;
            rgb[3 * i + 2] = (float) b;
        }
        return new Level(w, h, rgb);
    }

    /** The first pixel of many of which pixel i of few covers a part, both in a row of the same length. */
    private static int first(int i, int many, int few) {
        return (int) ((long) i * many / few);
    }

    /**
     * Parts of each pixel of few that pixels of many cover, both in a row of the same length: {@link #MOST_COVERED}
     * entries per pixel of few, for the pixels of many from {@link #first} on; not above 0 where there is no part.
     */
    private static double[] parts(int many, int few) {
        double[] parts = new double[MOST_COVERED * few];
        for (int i = 0; i < few; i++) {
            int k = first(i, many, few);
            for (int j = 0; j < MOST_COVERED && k + j < many; j++) {
                double from = Math.max((k + (double) j) * few, (double) i * many);
                double to = Math.min((k + j + 1.0) * few, (i + 1.0) * many);
                parts[MOST_COVERED * i + j] = (to - from) / many;
            }
        }
        return parts;
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

    /** The largest value of any pixel, and beyond the edges. */
    double most() {
        return wrapU == ImageMap.Wrap.NONE || wrapV == ImageMap.Wrap.NONE ? Math.max(most, outside.max()) : most;
    }

    /** Number of pixels of the full image. */
    public long pixels() {
        return (long) width() * height();
    }

    /** Number of pixels of the largest level that has at most {@code most}, or one. */
    long pixelsWithin(long most) {
        Level level = within(most);
        return (long) level.width * level.height;
    }

    /** This image, halved until it has at most {@code most} pixels, or one. */
    Raster atMost(long most) {
        Level level = within(most);
        return level == levels.get(0) ? this : new Raster(level.width, level.height, level.rgb, wrapU, wrapV, outside);
    }

    private Level within(long most) {
        return levels.stream().filter(level -> (long) level.width * level.height <= most).findFirst()
                .orElse(levels.get(levels.size() - 1));
    }

    /** The mean of the whole image. */
    public Rgb mean() {
        return pixel(levels.size() - 1, 0, 0);
    }

    /** Value at a point, linear between the centres of pixels; v points upwards. */
    public Rgb at(double u, double v) {
        double x = u * width() - 0.5;
        double y = (1 - v) * height() - 0.5;
        double i = Math.floor(x);
        double j = Math.floor(y);
        double a = x - i;
        double b = y - j;
        Rgb above = pixel(0, i, j).times(1 - a).plus(pixel(0, i + 1, j).times(a));
        Rgb below = pixel(0, i, j + 1).times(1 - a).plus(pixel(0, i + 1, j + 1).times(a));
        return above.times(1 - b).plus(below.times(b));
    }

    /** A pixel of level l or of what continues it: beyond an edge, the edge of the full image, not of the level. */
    private Rgb pixel(int l, double x, double y) {
        Level level = levels.get(l);
        int i = wrapped(x, level.width, wrapU);
        int j = wrapped(y, level.height, wrapV);
        if (i < 0 || j < 0) {
            return outside;
        }
        boolean isBeside = wrapU == ImageMap.Wrap.EDGE && i != x;
        boolean isAboveOrBelow = wrapV == ImageMap.Wrap.EDGE && j != y;
        if (isBeside && isAboveOrBelow) {
            return rgb(levels.get(0), x < 0 ? 0 : width() - 1, y < 0 ? 0 : height() - 1);
        }
        if (isBeside) {
            return rgb(level(columns.get(x < 0 ? 0 : 1), l), 0, j);
        }
        return isAboveOrBelow ? rgb(level(rows.get(y < 0 ? 0 : 1), l), i, 0) : rgb(level, i, j);
    }

    /** Level l; the last one where there are fewer, as columns and rows may have. */
    private static Level level(List<Level> of, int l) {
        return of.get(Math.min(l, of.size() - 1));
    }

    private static Rgb rgb(Level level, int i, int j) {
        return new Rgb(value(level, i, j, 0), value(level, i, j, 1), value(level, i, j, 2));
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
        return mean(u, v, MOST_STEPS);
    }

    /**
     * The mean over a triangle with at most {@code most} x {@code most} samples; with fewer samples it is less exact
     * along the triangle's edges.
     */
    public Rgb mean(double[] u, double[] v, int most) {
        double pixels = pixels(u, v);
        int n = (int) Math.max(1, Math.min(most, Math.ceil(Math.sqrt(pixels))));
        int l = 0;
        for (double left = pixels / ((double) n * n); left > 2 && l < levels.size() - 1; left /= 4) {
            l++;
        }
        Rgb sum = Rgb.BLACK;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n - i; j++) {
                sum = sum.plus(at(l, u, v, (i + 1.0 / 3) / n, (j + 1.0 / 3) / n));
                if (i + j < n - 1) {
                    sum = sum.plus(at(l, u, v, (i + 2.0 / 3) / n, (j + 2.0 / 3) / n));
                }
            }
        }
        return sum.times(1.0 / ((double) n * n));
    }

    /**
     * @param s weight of corner 1
     * @param t weight of corner 2
     */
    private Rgb at(int l, double[] u, double[] v, double s, double t) {
        Level level = levels.get(l);
        double x = (u[0] + s * (u[1] - u[0]) + t * (u[2] - u[0])) * level.width;
        double y = (1 - v[0] - s * (v[1] - v[0]) - t * (v[2] - v[0])) * level.height;
        return pixel(l, Math.floor(x), Math.floor(y));
    }
}
