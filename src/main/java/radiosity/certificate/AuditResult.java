package radiosity.certificate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import radiosity.mesh.face.Faces;
import radiosity.scene.Surface;
import radiosity.settings.Accuracy;
import radiosity.setup.InitialMesh;
import radiosity.solution.Certificate;
import radiosity.solution.EnergyLedger;

/** What the points of an {@link Audit} come to. */
final class AuditResult {

    /** Points of which one may be taken for an outlier. */
    private static final int MANY = 100;

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
     * The largest share of the sum is counted as the second largest: few points are far off, and one that is met by
     * chance could be most of the sum, hundreds of times what it is part of (once-winsorized mean: L.-P. Rivest,
     * Statistical properties of Winsorized means for skewed distributions, Biometrika 81, 1994).
     */
    private static double winsorizedMean(List<AuditPoint> some, ToDoubleFunction<AuditPoint> value) {
        double[] shares = some.stream().mapToDouble(p -> p.area * value.applyAsDouble(p)).toArray();
        winsorize(shares);
        double area = some.stream().mapToDouble(p -> p.area).sum();
        return area == 0 ? 0 : Arrays.stream(shares).sum() / area;
    }

    /** The largest of many becomes the second largest. */
    static void winsorize(double[] shares) {
        if (shares.length < MANY) {
            return;
        }
        double[] sorted = shares.clone();
        Arrays.sort(sorted);
        double second = sorted[sorted.length - 2];
        Arrays.setAll(shares, i -> Math.min(shares[i], second));
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
        double square = Math.max(0, winsorizedMean(some, p -> square(p.error(colour) / unit(p.radiosity(colour), mean)))
                - noise);
        double atVertex = winsorizedMean(some,
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
                error[i] += some.get(i).area * square(some.get(i).error(c) / unit(some.get(i).radiosity(c), mean));
            }
        }
        winsorize(error);
        double sum = Arrays.stream(error).sum();
        double area = some.stream().mapToDouble(p -> p.area).sum();
        double deviation = 0;
        for (int i = 0; i < error.length; i++) {
            deviation += square(error[i] - some.get(i).area / area * sum);
        }
        return sum > 0 ? Math.sqrt(deviation) / sum : 0;
    }

    private static double square(double x) {
        return x * x;
    }
}
