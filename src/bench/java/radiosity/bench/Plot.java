package radiosity.bench;

import java.util.List;

/** Curves on logarithmic axes, as SVG. */
final class Plot {

    private static final int WIDTH = 640;
    private static final int HEIGHT = 420;
    private static final int LEFT = 60;
    private static final int BOTTOM = 50;
    private static final int TOP = 40;
    private static final int LEGEND = 150;
    /** Powers of ten that the axes reach. */
    private static final int FROM_X = -2;
    private static final int TO_X = 3;
    private static final int FROM_Y = -1;
    private static final int TO_Y = 2;
    private static final List<String> COLOURS = List.of("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#8a6d00");

    private final StringBuilder body = new StringBuilder();
    private int curves;

    Plot(String title, String xAxis, String yAxis) {
        text(LEFT, TOP - 15, "start", title);
        text((LEFT + WIDTH - LEGEND) / 2.0, HEIGHT - 10, "middle", xAxis);
        body.append(String.format("<g transform='rotate(-90 15 %d)'>", HEIGHT / 2));
        text(15, HEIGHT / 2.0, "middle", yAxis);
        body.append("</g>\n");
        for (int p = FROM_X; p <= TO_X; p++) {
            double x = x(Math.pow(10, p));
            line(x, TOP, x, HEIGHT - BOTTOM, "#ddd");
            text(x, HEIGHT - BOTTOM + 18, "middle", label(p));
        }
        for (int p = FROM_Y; p <= TO_Y; p++) {
            double y = y(Math.pow(10, p));
            line(LEFT, y, WIDTH - LEGEND, y, "#ddd");
            text(LEFT - 6, y + 4, "end", label(p));
        }
    }

    private static String label(int power) {
        return power < 0 ? "0." + "0".repeat(-power - 1) + "1" : "1" + "0".repeat(power);
    }

    /** @param points x, y above 0 of each */
    void curve(String name, List<double[]> points) {
        String colour = COLOURS.get(curves % COLOURS.size());
        StringBuilder way = new StringBuilder();
        for (double[] p : points) {
            way.append(String.format("%.1f,%.1f ", x(p[0]), y(p[1])));
            body.append(String.format("<circle cx='%.1f' cy='%.1f' r='3.5' fill='%s'/>%n", x(p[0]), y(p[1]), colour));
        }
        body.append(String.format("<polyline points='%s' fill='none' stroke='%s' stroke-width='1.5'/>%n",
                way.toString().trim(), colour));
        double y = TOP + 10 + 20.0 * curves++;
        line(WIDTH - LEGEND + 10, y, WIDTH - LEGEND + 30, y, colour);
        text(WIDTH - LEGEND + 36, y + 4, "start", name);
    }

    private static double x(double value) {
        return LEFT + (WIDTH - LEGEND - LEFT) * (Math.log10(value) - FROM_X) / (TO_X - FROM_X);
    }

    private static double y(double value) {
        return HEIGHT - BOTTOM - (HEIGHT - BOTTOM - TOP) * (Math.log10(value) - FROM_Y) / (TO_Y - FROM_Y);
    }

    private void line(double x1, double y1, double x2, double y2, String colour) {
        body.append(String.format("<line x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f' stroke='%s'/>%n", x1, y1, x2, y2,
                colour));
    }

    private void text(double x, double y, String anchor, String words) {
        body.append(String.format("<text x='%.1f' y='%.1f' text-anchor='%s'>%s</text>%n", x, y, anchor, words));
    }

    String svg() {
        return String.format("<svg xmlns='http://www.w3.org/2000/svg' width='%d' height='%d' font-family='sans-serif' "
                + "font-size='12'>%n<rect width='100%%' height='100%%' fill='white'/>%n", WIDTH, HEIGHT) + body
                        + "</svg>\n";
    }
}
