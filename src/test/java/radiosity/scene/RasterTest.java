package radiosity.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.ImageMap.Wrap;

/** Means of an image over triangles of any size and place, against sums over the pixels of the full image. */
class RasterTest {

    private static final int STEPS = 600;

    private static Raster raster(int width, int height, Wrap wrap, IntToDoubleFunction value) {
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) value.applyAsDouble(i / 3);
        }
        return new Raster(width, height, rgb, wrap, wrap, Rgb.BLACK);
    }

    /** The pixels of the outermost ring are 1, all others 0. */
    private static Raster frame(int size, Wrap wrap) {
        return raster(size, size, wrap, i -> i % size % (size - 1) == 0 || i / size % (size - 1) == 0 ? 1 : 0);
    }

    /** Mean over the square between two values of u and v. */
    private static double square(Raster of, double from, double to) {
        return (of.mean(new double[] {from, to, to}, new double[] {from, from, to}).r()
                + of.mean(new double[] {from, to, from}, new double[] {from, to, to}).r()) / 2;
    }

    /** Of the square from -1 to 2 eight ninths lie beyond the edges. */
    @ParameterizedTest
    @ValueSource(ints = {64, 256, 257, 300})
    void beyondClampedEdges_theEdgeContinues_andNotTheMeanBesideIt(int size) {
        double ring = (4.0 * size - 4) / ((double) size * size);
        assertEquals((8 + ring) / 9, square(frame(size, Wrap.EDGE), -1, 2), .01);
        assertEquals(ring / 9, square(frame(size, Wrap.NONE), -1, 2), .01);
    }

    /** A corner that is clamped in both directions is one pixel. */
    @Test
    void beyondACorner_itsPixelContinues() {
        Raster corner = raster(64, 64, Wrap.EDGE, i -> i == 63 * 64 ? 1 : 0);
        assertEquals(1, square(corner, -5, -1), 1e-6, "u = v = 0 is the first pixel of the last row");
        assertEquals(0, square(corner, 2, 5), 1e-6);
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "3, 1", "3, 3", "5, 4", "37, 129", "257, 256", "300, 7"})
    void meanOfTheWhole_isThatOfAllPixels(int width, int height) {
        Random random = new Random(1);
        double[] values = random.doubles((long) width * height).toArray();
        double sum = 0;
        for (double value : values) {
            sum += value;
        }
        assertEquals(sum / values.length, raster(width, height, Wrap.REPEAT, i -> values[i]).mean().r(), 1e-5);
    }

    private static double pixel(Raster of, double u, double v) {
        int i = index((int) Math.floor(u * of.width()), of.width(), of.wrapU());
        int j = index((int) Math.floor((1 - v) * of.height()), of.height(), of.wrapV());
        return i < 0 || j < 0 ? 0 : of.rgb()[3 * (j * of.width() + i)];
    }

    private static int index(int x, int size, Wrap wrap) {
        return switch (wrap) {
            case NONE -> x >= 0 && x < size ? x : -1;
            case EDGE -> Math.max(0, Math.min(size - 1, x));
            case REPEAT -> Math.floorMod(x, size);
            case MIRROR -> Math.min(Math.floorMod(x, 2 * size), 2 * size - 1 - Math.floorMod(x, 2 * size));
        };
    }

    private static double slowly(Raster of, double[] u, double[] v) {
        double sum = 0;
        for (int i = 0; i < STEPS; i++) {
            for (int j = 0; j < STEPS; j++) {
                boolean folded = i + j >= STEPS;
                double s = ((folded ? STEPS - 1 - i : i) + (folded ? 2.0 : 1.0) / 3) / STEPS;
                double t = ((folded ? STEPS - 1 - j : j) + (folded ? 2.0 : 1.0) / 3) / STEPS;
                sum += pixel(of, u[0] + s * (u[1] - u[0]) + t * (u[2] - u[0]),
                        v[0] + s * (v[1] - v[0]) + t * (v[2] - v[0]));
            }
        }
        return sum / STEPS / STEPS;
    }

    /** A disc of .4 of the width, 1 on .1, and noise of .2; triangles from a quarter of the image to four of it. */
    @ParameterizedTest
    @CsvSource({"NONE, 256", "NONE, 257", "EDGE, 256", "EDGE, 257", "EDGE, 300", "REPEAT, 257", "REPEAT, 129",
        "MIRROR, 257", "MIRROR, 300"})
    void meanOverTriangles_isThatOfTheirPixels(Wrap wrap, int size) {
        Random random = new Random(2);
        Raster of = raster(size, size, wrap, i -> (Math.hypot(i % size - size / 2.0, i / size - size / 2.0) < .4 * size
                ? 1 : .1) + .2 * random.nextDouble());
        for (int n = 0; n < 12; n++) {
            double scale = Math.pow(4, random.nextDouble() * 2 - 1);
            double turn = 2 * Math.PI * random.nextDouble();
            double[] u = new double[3];
            double[] v = new double[3];
            for (int k = 0; k < 3; k++) {
                u[k] = random.nextDouble() * .2 + .5 + scale * Math.cos(turn + 2 * k);
                v[k] = random.nextDouble() * .2 + .5 + scale * Math.sin(turn + 2 * k);
            }
            assertEquals(slowly(of, u, v), of.mean(u, v).r(), .015, n + ": scale " + scale);
        }
    }
}
