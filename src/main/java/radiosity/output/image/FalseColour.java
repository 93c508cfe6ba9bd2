package radiosity.output.image;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import radiosity.output.file.AtomicFile;
import radiosity.scene.Camera;
import radiosity.scene.Units;
import radiosity.solution.Solution;

/**
 * A picture in which colours stand for illuminance (irradiance in radiometric scenes), with lines of equal illuminance
 * and a legend in the scene's unit.
 *
 * <p>The step of the legend is 1, 2 or 5 times a power of ten; the legend ends at the least multiple of the step, at
 * least five steps, that 99 % of the samples do not exceed.
 */
public final class FalseColour {

    /** Samples per pixel along each axis. */
    private static final int SAMPLES = 2;
    private static final double SHOWN = 0.99;
    private static final int FEWEST_STEPS = 5;
    private static final int LEGEND = 120;
    private static final Color NOTHING = new Color(40, 40, 40);
    private static final int LINE = 0x202020;
    /** Colours 0xRRGGBB from 0 to the end of the legend, at equal distances. */
    private static final int[] COLOURS = {0x10104a, 0x2545b8, 0x1b8fd0, 0x12b5a0, 0x3fc04a, 0xa5d02a, 0xf5d020,
        0xf58c1e, 0xe03a1e, 0xb0101e};

    private final Snapshot.Values values;
    private final double step;
    private final int steps;

    private FalseColour(Snapshot.Values values) {
        this.values = values;
        double[] seen = new double[values.value().length];
        int n = 0;
        for (float value : values.value()) {
            if (!Float.isNaN(value)) {
                seen[n++] = value;
            }
        }
        Arrays.sort(seen, 0, n);
        double most = n == 0 ? 0 : seen[(int) (SHOWN * (n - 1))];
        step = step(most);
        steps = (int) Math.max(FEWEST_STEPS, Math.ceil(most / step - 1e-9));
    }

    /** The step of a legend, which fits 4 to 10 times into the value: 1, 2 or 5 times a power of ten; 1 for 0. */
    static double step(double most) {
        if (!(most > 0)) {
            return 1;
        }
        double ten = StrictMath.pow(10, Math.floor(StrictMath.log10(most / FEWEST_STEPS)));
        double times = most / FEWEST_STEPS / ten;
        return ten * (times > 4 ? 5 : times >= 2 ? 2 : 1);
    }

    /**
     * Writes the picture as PNG.
     *
     * @param width   pixels, without the legend beside the picture; the height follows from the camera's aspect
     * @param threads number of threads that draw, at least 1
     */
    public static void write(Path file, Solution solution, Camera camera, int width, int threads) throws IOException {
        FalseColour picture = new FalseColour(Snapshot.irradiance(solution, camera, SAMPLES * width, threads));
        AtomicFile.write(file, PictureFormat.png(picture.image(solution.scene().units())));
    }

    private BufferedImage image(Units units) {
        int width = values.width() / SAMPLES;
        int height = Math.max(1, values.height() / SAMPLES);
        BufferedImage image = new BufferedImage(width + LEGEND, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                image.setRGB(x, y, pixel(x, y));
            }
        }
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        legend(g, width, height, units);
        g.dispose();
        return image;
    }

    /** The mean colour of a pixel's samples, 0xRRGGBB. */
    private int pixel(int x, int y) {
        int[] sum = new int[3];
        for (int s = 0; s < SAMPLES * SAMPLES; s++) {
            int colour = sample(SAMPLES * x + s % SAMPLES, Math.min(values.height() - 1, SAMPLES * y + s / SAMPLES));
            for (int c = 0; c < 3; c++) {
                sum[c] += colour >> 8 * c & 255;
            }
        }
        int all = 0;
        for (int c = 0; c < 3; c++) {
            all |= sum[c] / (SAMPLES * SAMPLES) << 8 * c;
        }
        return all;
    }

    private int sample(int x, int y) {
        int i = y * values.width() + x;
        float value = values.value()[i];
        if (Float.isNaN(value)) {
            return NOTHING.getRGB() & 0xffffff;
        }
        boolean line = x + 1 < values.width() && isLine(i, i + 1)
                || y + 1 < values.height() && isLine(i, i + values.width());
        return line ? LINE : colour(value / (step * steps));
    }

    /** Whether a line of equal illuminance passes between two neighbouring samples, which must lie in one plane. */
    private boolean isLine(int i, int k) {
        return values.plane()[i] == values.plane()[k]
                && Math.floor(Math.min(values.value()[i] / step, steps))
                != Math.floor(Math.min(values.value()[k] / step, steps));
    }

    private static int colour(double part) {
        double at = Math.max(0, Math.min(1, part)) * (COLOURS.length - 1);
        int i = (int) Math.min(at, COLOURS.length - 2);
        int mixed = 0;
        for (int c = 0; c < 3; c++) {
            int a = COLOURS[i] >> 8 * c & 255;
            int b = COLOURS[i + 1] >> 8 * c & 255;
            mixed |= (int) Math.round(a + (b - a) * (at - i)) << 8 * c;
        }
        return mixed;
    }

    private void legend(Graphics2D g, int left, int height, Units units) {
        int text = Math.max(6, Math.min(13, height / 16));
        int bottom = height - 2 * text;
        int top = Math.min(bottom - 1, 4 * text);
        g.setColor(Color.WHITE);
        g.fillRect(left, 0, LEGEND, height);
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, text));
        g.setStroke(new BasicStroke(1));
        for (int y = top; y <= bottom; y++) {
            g.setColor(new Color(colour((bottom - y) / (double) (bottom - top))));
            g.drawLine(left + 12, y, left + 36, y);
        }
        g.setColor(Color.BLACK);
        g.drawString(units.irradianceWord(), left + 12, 3 * text / 2);
        g.drawString("[" + Units.raised(units.irradiance()) + "]", left + 12, 11 * text / 4);
        for (int k = 0; k <= steps; k++) {
            int y = bottom - (bottom - top) * k / steps;
            g.drawLine(left + 12, y, left + 42, y);
            g.drawString(number(k * step, step), left + 47, y + 2 * text / 5);
        }
    }

    /** A number of the legend, with as many decimals as the steps have. */
    private static String number(double value, double step) {
        int digits = (int) Math.max(0, Math.ceil(-StrictMath.log10(step) - 1e-9));
        return value == 0 ? "0" : digits > 3 || value >= 1e7 ? String.format(Locale.ROOT, "%.1e", value)
                : String.format(Locale.ROOT, "%,." + digits + "f", value);
    }
}
