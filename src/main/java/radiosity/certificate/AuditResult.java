package radiosity.certificate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import radiosity.mesh.face.Faces;
import radiosity.scene.Surface;
import radiosity.settings.Accuracy;
import radiosity.setup.InitialMesh;
import radiosity.solution.Certificate;
import radiosity.solution.EnergyLedger;

/** What the points of an {@link Audit} come to. */
final class AuditResult {

    /** Part of the area, that of the largest errors, which the expected error leaves out. */
    private static final double TAIL = 1.0 / 2000;

    private final Faces faces;
    /** That see anything. */
    private final List<AuditPoint> points;
    private final EnergyLedger ledger;
    /** 1 per colour. */
    private final AuditBias[] bias;

    /** @param batches each of which stands for the whole scene */
    AuditResult(InitialMesh mesh, List<AuditPoint> all, int batches, EnergyLedger ledger) {
        faces = mesh.faces;
        points = all.stream().filter(p -> !p.isBuried && !p.isDark()).toList();
        this.ledger = ledger;
        bias = new AuditBias[faces.colours()];
        Arrays.setAll(bias, c -> new AuditBias(mesh, all, batches, ledger, c));
    }

    /** Expected error, relative. */
    double expected() {
        return Math.sqrt(errors(reflecting()).total);
    }

    Certificate certificate(double unshotFlux, double reciprocity) {
        double most = points.stream().mapToDouble(p -> p.factors).max().orElse(0);
        List<AuditPoint> reflecting = reflecting();
        Errors all = errors(reflecting);
        return new Certificate(points.size(), missing(unshotFlux, most), mean(points, p -> p.factors), most,
                reciprocity,
                Math.sqrt(all.total), Math.sqrt(all.sampling), Math.sqrt(all.meshing), all.bias, surfaces(reflecting));
    }

    /** Where nothing only reflects, all that reflects. */
    private List<AuditPoint> reflecting() {
        List<AuditPoint> all = points.stream().filter(AuditPoint::reflects).toList();
        List<AuditPoint> dark = all.stream().filter(point -> !point.emits()).toList();
        return dark.isEmpty() ? all : dark;
    }

    /**
     * U rho c / (1 - rho c): unshot flux reflected for ever, at most c of it arriving each time; c is the largest sum
     * of form factors at a point, and no less than 1, as the points may have missed where it is largest, nor than the
     * part of the flux shot so far that has arrived, as factors are not quite reciprocal.
     */
    private Double missing(double unshotFlux, double mostFactors) {
        double rho = 0;
        double arriving = Math.max(1, mostFactors);
        for (int c = 0; c < faces.channels(); c++) {
            arriving = Math.max(arriving, ledger.shot()[c] > 0 ? ledger.received()[c] / ledger.shot()[c] : 0);
        }
        for (int f = 0; f < faces.count(); f++) {
            for (int c = 0; c < faces.colours(); c++) {
                rho = Math.max(rho, faces.reflectance(f, c) * arriving);
            }
        }
        return rho < 1 ? unshotFlux * rho / (1 - rho) : null;
    }

    private static double mean(List<AuditPoint> some, ToDoubleFunction<AuditPoint> value) {
        double area = some.stream().mapToDouble(p -> p.area).sum();
        return area == 0 ? 0 : some.stream().mapToDouble(p -> p.area * value.applyAsDouble(p)).sum() / area;
    }

    private List<Certificate.SurfaceError> surfaces(List<AuditPoint> reflecting) {
        Map<Surface, List<AuditPoint>> bySurface = new LinkedHashMap<>();
        for (AuditPoint point : reflecting) {
            Surface surface = faces.scene().surface(faces.triangle(point.face));
            bySurface.computeIfAbsent(surface, s -> new ArrayList<>()).add(point);
        }
        List<Certificate.SurfaceError> errors = new ArrayList<>();
        bySurface.forEach((surface, some) -> {
            Errors of = errors(some);
            double mean = 0;
            for (int c = 0; c < faces.colours(); c++) {
                int colour = c;
                mean += mean(some, p -> p.radiosity(colour)) / faces.colours();
            }
            errors.add(new Certificate.SurfaceError(surface.name(), some.size(), mean, Math.sqrt(of.sampling),
                    Math.sqrt(of.meshing)));
        });
        return errors;
    }

    /**
     * The mean over all of the area but that where a value is largest, {@link #TAIL} of it. Errors have a heavy tail: a
     * gap of millimetres beside a lamp may err by ten times the mean of the scene. A point that is met there by chance
     * would be half of the mean square, and how much such places are in all no number of points tells that is worth its
     * time (R. R. Wilcox, Introduction to Robust Estimation and Hypothesis Testing, 2012, on trimmed means).
     */
    private static double trimmedMean(List<AuditPoint> some, ToDoubleFunction<AuditPoint> value) {
        double[] values = some.stream().mapToDouble(value).toArray();
        double[] area = trimmed(values, some.stream().mapToDouble(p -> p.area).toArray());
        double whole = Arrays.stream(area).sum();
        double sum = 0;
        for (int i = 0; i < area.length; i++) {
            sum += area[i] * values[i];
        }
        return whole == 0 ? 0 : sum / whole;
    }

    /**
     * The areas without the part of them in which values are largest.
     *
     * @param values not modified, nor are areas
     */
    static double[] trimmed(double[] values, double[] areas) {
        double[] left = areas.clone();
        double tail = TAIL * Arrays.stream(areas).sum();
        int[] order = IntStream.range(0, values.length).boxed()
                .sorted(Comparator.comparingDouble(i -> -values[i])).mapToInt(i -> i).toArray();
        for (int i = 0; i < order.length && tail > 0; i++) {
            double out = Math.min(tail, left[order[i]]);
            left[order[i]] -= out;
            tail -= out;
        }
        return left;
    }

    /** Mean squares, relative to the squared mean radiosity; the bias relative to the mean. */
    private record Errors(double total, double sampling, double meshing, double bias) { }

    /** Mean over the colours that have light. */
    private Errors errors(List<AuditPoint> some) {
        double[] sum = new double[4];
        int lit = 0;
        for (int c = 0; c < faces.colours(); c++) {
            int colour = c;
            double mean = mean(some, p -> p.radiosity(colour));
            if (mean > 0) {
                lit++;
                add(some, colour, mean, sum);
            }
        }
        return lit == 0 ? new Errors(0, 0, 0, 0)
                : new Errors(sum[0] / lit, sum[1] / lit, sum[2] / lit, sum[3] / lit);
    }

    /**
     * What corners err by reaches a point by as much as interpolation leaves of it; the rest is interpolation's own.
     * What the rays of this audit leave is in none of it. What interreflection makes of the mean error is taken to be
     * no less than its standard error.
     */
    private void add(List<AuditPoint> some, int colour, double mean, double[] sum) {
        double noise = mean(some, p -> square(p.noise(colour) / unit(p.radiosity(colour), mean)));
        double local = mean(some, p -> p.error(colour) / unit(p.radiosity(colour), mean));
        double square = Math.max(0, trimmedMean(some, p -> square(p.error(colour) / unit(p.radiosity(colour), mean)))
                - noise);
        double atVertex = trimmedMean(some,
                p -> square(p.errorAtVertex(colour) / unit(p.radiosityAtVertex(colour), mean)));
        double rays = Math.max(0, atVertex - AuditPoint.TIMES * noise);
        double raysLeft = rays * mean(some, p -> p.spread);
        double reflectance = mean(some, p -> p.reflectance(colour));
        double all = local + bias[colour].spread(reflectance) / mean;
        double uncertain = bias[colour].uncertainty(reflectance) / mean;
        sum[0] += Math.max(0, square - local * local) + Math.max(square(all), square(uncertain));
        sum[1] += rays;
        sum[2] += Math.max(0, square - raysLeft);
        sum[3] += all;
    }

    /** What an error counts by, W/m²: the mean, and where it is far brighter than that, what is there. */
    private static double unit(double radiosity, double mean) {
        return Math.max(mean, radiosity / Accuracy.BRIGHT);
    }

    /** Standard error of the mean square error, relative to it. */
    double uncertainty() {
        List<AuditPoint> some = reflecting();
        double[] error = new double[some.size()];
        for (int c = 0; c < faces.colours(); c++) {
            int colour = c;
            double mean = mean(some, p -> p.radiosity(colour));
            for (int i = 0; i < error.length && mean > 0; i++) {
                error[i] += square(some.get(i).error(c) / unit(some.get(i).radiosity(c), mean));
            }
        }
        double[] area = trimmed(error, some.stream().mapToDouble(p -> p.area).toArray());
        double whole = Arrays.stream(area).sum();
        double sum = 0;
        for (int i = 0; i < error.length; i++) {
            sum += area[i] * error[i];
        }
        double deviation = 0;
        for (int i = 0; i < error.length; i++) {
            deviation += square(area[i] * error[i] - area[i] / whole * sum);
        }
        return sum > 0 ? Math.sqrt(deviation) / sum : 0;
    }

    private static double square(double x) {
        return x * x;
    }
}
