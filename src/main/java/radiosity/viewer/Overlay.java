package radiosity.viewer;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Units;

/** Draws texts and scales that lie over the picture. */
final class Overlay {

    private static final Color PANEL = new Color(20, 20, 24, 210);
    private static final Color INK = new Color(235, 235, 235);
    private static final Font FONT = new Font(Font.MONOSPACED, Font.PLAIN, 13);
    /** Characters of a line that a window of 800 pixels shows. */
    private static final int LONGEST_LINE = 90;
    private static final int EDGE = 8;
    private static final int SCALE_WIDTH = 120;
    private static final int SCALE_HEIGHT = 240;
    private static final int BAR = 22;
    /** Width and height of a mark, pixels; odd. */
    static final int MARK = 17;

    private Overlay() { }

    /**
     * An image and its position in the window.
     *
     * @param image image with transparency
     * @param x     pixels from the left of the window
     * @param y     pixels from the top of the window
     */
    record Label(BufferedImage image, int x, int y) { }

    /**
     * Draws all labels into one image, because Java 3D cuts a second image to the size of the first.
     *
     * @param width  width of the window, pixels
     * @param height height of the window, pixels
     * @return null where there are no labels
     */
    static BufferedImage of(List<Label> labels, int width, int height) {
        if (labels.isEmpty()) {
            return null;
        }
        BufferedImage whole = new BufferedImage(Math.max(1, width), Math.max(1, height),
                BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = whole.createGraphics();
        for (Label label : labels) {
            g.drawImage(label.image(), label.x(), label.y(), null);
        }
        g.dispose();
        return whole;
    }

    /** Draws lines of text on a dark panel; long lines go on below. */
    static BufferedImage text(List<String> written) {
        List<String> lines = written.stream().flatMap(line -> wrapped(line).lines()).toList();
        FontMetrics metrics = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB).createGraphics()
                .getFontMetrics(FONT);
        int width = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0);
        BufferedImage image = panel(width + 2 * EDGE, metrics.getHeight() * lines.size() + 2 * EDGE);
        Graphics2D g = graphics(image);
        for (int i = 0; i < lines.size(); i++) {
            g.drawString(lines.get(i), EDGE, EDGE + metrics.getAscent() + i * metrics.getHeight());
        }
        g.dispose();
        return image;
    }

    /** A line with breaks between words, where it is longer than a small window is wide. */
    static String wrapped(String line) {
        return line.length() <= LONGEST_LINE ? line.isEmpty() ? " " : line
                : line.replaceAll("(.{1," + LONGEST_LINE + "})(\\s+|$)", "$1\n");
    }

    /** Draws a ring that is visible on light and on dark surfaces. */
    static BufferedImage mark() {
        BufferedImage image = new BufferedImage(MARK, MARK, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = graphics(image);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setStroke(new BasicStroke(4));
        g.setColor(Color.BLACK);
        g.drawOval(3, 3, MARK - 7, MARK - 7);
        g.setStroke(new BasicStroke(2));
        g.setColor(Color.WHITE);
        g.drawOval(3, 3, MARK - 7, MARK - 7);
        g.dispose();
        return image;
    }

    /** Draws the list of keys. */
    static BufferedImage help() {
        return text(Arrays.stream(Keys.HELP)
                .map(line -> String.format(Locale.ROOT, "%-20s %s", line[0], line[1])).toList());
    }

    /** Draws the scale of false colours: luminance in the unit of the scene's light. */
    static BufferedImage scale(ToneMapping toneMapping, Units units) {
        BufferedImage image = panel(SCALE_WIDTH, SCALE_HEIGHT);
        Graphics2D g = graphics(image);
        int height = SCALE_HEIGHT - 5 * EDGE;
        for (int y = 0; y < height; y++) {
            g.setColor(new Color(TurboColourMap.turbo(1 - y / (height - 1.0))));
            g.drawLine(EDGE, 4 * EDGE + y, EDGE + BAR, 4 * EDGE + y);
        }
        g.setColor(INK);
        g.drawString(Units.raised(units.luminanceScale()), EDGE, 2 * EDGE + 2);
        for (int decade = 0; decade <= TurboColourMap.DECADES; decade++) {
            double value = TurboColourMap.top(toneMapping, units) * Math.pow(10, -decade);
            int y = 4 * EDGE + (int) Math.round(decade * (height - 1.0) / TurboColourMap.DECADES);
            g.drawString(String.format(Locale.ROOT, "%.3g", value), 2 * EDGE + BAR, y + 4);
        }
        g.dispose();
        return image;
    }

    private static BufferedImage panel(int width, int height) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = image.createGraphics();
        g.setColor(PANEL);
        g.fillRect(0, 0, width, height);
        g.dispose();
        return image;
    }

    private static Graphics2D graphics(BufferedImage image) {
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setFont(FONT);
        g.setColor(INK);
        return g;
    }
}
