package radiosity.bench;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Curves on logarithmic axes, as SVG. */
final class Plot {

    private static final int WIDTH = 640;
    private static final int HEIGHT = 420;
    private static final int LEFT = 60;
    private static final int BOTTOM = 50;
    private static final int TOP = 40;
    private static final int LEGEND = 150;
    private static final List<String> COLOURS = List.of("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#8a6d00");

    private final String title;
    private final String xAxis;
    private final String yAxis;
    /** The points of each curve: x, y above 0. */
    private final Map<String, List<double[]>> curves = new LinkedHashMap<>();

    Plot(String title, String xAxis, String yAxis) {
        this.title = title;
        this.xAxis = xAxis;
        this.yAxis = yAxis;
    }

    /**
     * Writes a plot of the lines on standard input: name of a curve, x and y of a point, with tabulators between.
     *
     * @param arguments title, names of the axes, file
     */
    public static void main(String[] arguments) throws IOException {
        Locale.setDefault(Locale.ROOT);
        Plot plot = new Plot(arguments[0], arguments[1], arguments[2]);
        for (String line : new String(System.in.readAllBytes(), StandardCharsets.UTF_8).lines().toList()) {
            String[] parts = line.split("\t");
            plot.point(parts[0], Double.parseDouble(parts[1]), Double.parseDouble(parts[2]));
        }
        Files.writeString(Path.of(arguments[3]), plot.svg());
    }

    /** Adds a point, with x and y above 0, to a curve. */
    void point(String curve, double x, double y) {
        curves.computeIfAbsent(curve, name -> new ArrayList<>()).add(new double[] {x, y});
    }

    String svg() {
        return new Drawing(new Axis(values(0), LEFT, WIDTH - LEGEND), new Axis(values(1), HEIGHT - BOTTOM, TOP)).svg();
    }

    private double[] values(int axis) {
        return curves.values().stream().flatMap(List::stream).mapToDouble(point -> point[axis]).toArray();
    }

    /** An axis over whole powers of ten. */
    private static final class Axis {

        final int from;
        final int to;
        private final int begin;
        private final int end;

        /** @param begin place of the lowest power; end: that of the highest */
        Axis(double[] values, int begin, int end) {
            from = (int) Math.floor(Math.log10(Arrays.stream(values).min().orElseThrow()));
            to = (int) Math.ceil(Math.log10(Arrays.stream(values).max().orElseThrow()));
            this.begin = begin;
            this.end = end;
        }

        double at(double value) {
            return begin + (end - begin) * (Math.log10(value) - from) / Math.max(1, to - from);
        }

        static String label(int power) {
            return power < 0 ? "0." + "0".repeat(-power - 1) + "1" : "1" + "0".repeat(power);
        }
    }

    private final class Drawing {

        private final Axis across;
        private final Axis up;
        private final StringBuilder body = new StringBuilder();

        Drawing(Axis across, Axis up) {
            this.across = across;
            this.up = up;
        }

        String svg() {
            grid();
            int drawn = 0;
            for (Map.Entry<String, List<double[]>> curve : curves.entrySet()) {
                curve(curve.getKey(), curve.getValue(), drawn++);
            }
            return String.format("<svg xmlns='http://www.w3.org/2000/svg' width='%d' height='%d' "
                    + "font-family='sans-serif' font-size='12'>%n<rect width='100%%' height='100%%' fill='white'/>%n",
                    WIDTH, HEIGHT) + body + "</svg>\n";
        }

        private void grid() {
            text(LEFT, TOP - 15, "start", title);
            text((LEFT + WIDTH - LEGEND) / 2.0, HEIGHT - 10, "middle", xAxis);
            body.append(String.format("<g transform='rotate(-90 15 %d)'>", HEIGHT / 2));
            text(15, HEIGHT / 2.0, "middle", yAxis);
            body.append("</g>\n");
            for (int p = across.from; p <= across.to; p++) {
                double x = across.at(Math.pow(10, p));
                line(x, TOP, x, HEIGHT - BOTTOM, "#ddd");
                text(x, HEIGHT - BOTTOM + 18, "middle", Axis.label(p));
            }
            for (int p = up.from; p <= up.to; p++) {
                double y = up.at(Math.pow(10, p));
                line(LEFT, y, WIDTH - LEGEND, y, "#ddd");
                text(LEFT - 6, y + 4, "end", Axis.label(p));
            }
        }

        private void curve(String name, List<double[]> points, int number) {
            String colour = COLOURS.get(number % COLOURS.size());
            StringBuilder way = new StringBuilder();
            for (double[] p : points) {
                double x = across.at(p[0]);
                double y = up.at(p[1]);
                way.append(String.format("%.1f,%.1f ", x, y));
                body.append(String.format("<circle cx='%.1f' cy='%.1f' r='3.5' fill='%s'/>%n", x, y, colour));
            }
            body.append(String.format("<polyline points='%s' fill='none' stroke='%s' stroke-width='1.5'/>%n",
                    way.toString().trim(), colour));
            double y = TOP + 10 + 20.0 * number;
            line(WIDTH - LEGEND + 10, y, WIDTH - LEGEND + 30, y, colour);
            text(WIDTH - LEGEND + 36, y + 4, "start", name);
        }

        private void line(double x1, double y1, double x2, double y2, String colour) {
            body.append(String.format("<line x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f' stroke='%s'/>%n", x1, y1, x2, y2,
                    colour));
        }

        private void text(double x, double y, String anchor, String words) {
            body.append(String.format("<text x='%.1f' y='%.1f' text-anchor='%s'>%s</text>%n", x, y, anchor, words));
        }
    }
}
