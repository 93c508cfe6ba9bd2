package radiosity.input.lightwave;

import static radiosity.input.lightwave.HostileCase.ERROR;
import static radiosity.input.lightwave.HostileCase.object;
import static radiosity.input.lightwave.Objects.CORNERS;
import static radiosity.input.lightwave.Objects.lwob;
import static radiosity.input.lightwave.Objects.polygon;

import java.util.List;

/** Polygons that a fan gets wrong, and some that have no right. */
final class HostilePolygons {

    private HostilePolygons() {
    }

    static List<HostileCase> all() {
        return List.of(
                object("1 and 2 corners", lwob(CORNERS, 1, 0, 1, 2, 0, 1, 1, 0, 1, 3, 0, 1, 2, 1), 1, ""),
                object("repeated corners", lwob(CORNERS, 6, 0, 0, 1, 2, 2, 0, 1), 1, ""),
                object("spike", lwob(CORNERS, 5, 0, 1, 2, 3, 2, 1), 1, ""),
                object("spike over the end", lwob(CORNERS, 5, 0, 1, 2, 0, 3, 1), 1, ""),
                object("only a spike", lwob(CORNERS, 4, 0, 1, 2, 1, 1), ERROR, "at least one polygon"),
                object("zero area", lwob(new double[] {0, 0, 0, 1, 1, 1, 2, 2, 2, 1, 0, 0}, 3, 0, 1, 2, 1, 3, 0, 1, 3,
                        1),
                        1, "without area"),
                object("coincident", lwob(CORNERS, 4, 0, 1, 2, 3, 1, 4, 2, 3, 0, 1, 1), 2, "lie on one another"),
                object("reversed twins", lwob(CORNERS, 3, 0, 1, 2, 1, 3, 2, 1, 0, 1), 2, ""),
                object("1,023 corners", polygon(circle(1023)), 1021, ""),
                object("60,000 corners", polygon(circle(60_000)), 59_998, ""),
                object("65,535 corners", polygon(circle(65_535)), 65_533, ""),
                object("comb of 20,000 corners", polygon(comb(10_000)), 19_998, ""),
                object("comb of 60,000 corners", polygon(comb(30_000)), HostileCase.EITHER, ""),
                object("star of 60,000 corners", polygon(star(60_000)), 59_998, ""),
                object("spiral of 20,000 corners", polygon(spiral(10_000)), 19_998, ""),
                object("keyhole", lwob(KEYHOLE, 10, 0, 1, 2, 3, 0, 4, 5, 6, 7, 4, 1), 8, ""),
                object("bow tie without area", polygon(0, 0, 0, 1, 1, 0, 1, 0, 0, 0, 1, 0), ERROR, "without area"),
                object("bow tie", polygon(0, 0, 0, 3, 3, 0, 1, 0, 0, 0, 1, 0), 2, "cross themselves"),
                object("non-planar", polygon(0, 0, 0, 0, 1, 0.3, 1, 1, 0, 1, 0, 0.3), 2, ""),
                object("60,000 corners at random", polygon(random(60_000)), HostileCase.EITHER, ""),
                object("60,000 times round", polygon(rounds(60_000)), HostileCase.EITHER, ""));
    }

    /** A square of side 4 around one of side 2 that runs the other way. */
    private static final double[] KEYHOLE = {0, 0, 0, 0, 4, 0, 4, 4, 0, 4, 0, 0, 1, 1, 0, 3, 1, 0, 3, 3, 0, 1, 3, 0};

    private static double[] circle(int n) {
        return round(n, i -> 1);
    }

    private static double[] star(int n) {
        return round(n, i -> 1 + (i & 1));
    }

    private static double[] round(int n, java.util.function.IntToDoubleFunction radius) {
        double[] points = new double[3 * n];
        for (int i = 0; i < n; i++) {
            points[3 * i] = 1e4 * radius.applyAsDouble(i) * Math.sin(2 * Math.PI * i / n);
            points[3 * i + 1] = 1e4 * radius.applyAsDouble(i) * Math.cos(2 * Math.PI * i / n);
        }
        return points;
    }

    /** Teeth side by side, 2 corners each. */
    private static double[] comb(int teeth) {
        double[] points = new double[6 * teeth];
        for (int i = 1; i < teeth; i++) {
            points[6 * i] = i;
            points[6 * i + 1] = 1;
            points[6 * i + 3] = i + 0.5;
            points[6 * i + 4] = 1000;
        }
        points[1] = 0;
        points[3] = 0;
        points[4] = 500;
        points[6 * teeth - 2] = 0;
        return points;
    }

    /** Out along a spiral and back beside it. */
    private static double[] spiral(int n) {
        double[] points = new double[6 * n];
        for (int i = 0; i < n; i++) {
            double angle = i * 0.02;
            points[3 * i] = (100 + angle) * Math.sin(angle);
            points[3 * i + 1] = (100 + angle) * Math.cos(angle);
            int back = 2 * n - 1 - i;
            points[3 * back] = (103 + angle) * Math.sin(angle);
            points[3 * back + 1] = (103 + angle) * Math.cos(angle);
        }
        return points;
    }

    private static double[] random(int n) {
        java.util.Random random = new java.util.Random(7);
        double[] points = new double[3 * n];
        for (int i = 0; i < n; i++) {
            points[3 * i] = random.nextDouble();
            points[3 * i + 1] = random.nextDouble();
        }
        return points;
    }

    /** Turns left at every corner, many times round. */
    private static double[] rounds(int n) {
        double[] points = new double[3 * n];
        for (int i = 0; i < n; i++) {
            points[3 * i] = (1 + i * 1e-5) * Math.sin(i * 2.5);
            points[3 * i + 1] = (1 + i * 1e-5) * Math.cos(i * 2.5);
        }
        return points;
    }
}
