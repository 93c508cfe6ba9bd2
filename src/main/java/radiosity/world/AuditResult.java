package radiosity.world;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import radiosity.patch.Faces;
import radiosity.scene.Surface;

/** What the points of an {@link Audit} come to. */
final class AuditResult {

    private final Faces faces;
    private final List<AuditPoint> points;
    private final EnergyLedger ledger;

    AuditResult(Faces faces, List<AuditPoint> points, EnergyLedger ledger) {
        this.faces = faces;
        this.points = points;
        this.ledger = ledger;
    }

    Certificate certificate(double unshotFlux, double reciprocity) {
        double most = points.stream().mapToDouble(p -> p.factors).max().orElse(0);
        List<AuditPoint> reflecting = reflecting();
        Errors all = errors(reflecting);
        return new Certificate(points.size(), missing(unshotFlux, most), mean(points, p -> p.factors), most, reciprocity,
                Math.sqrt(all.total), Math.sqrt(all.sampling), Math.sqrt(all.meshing), all.bias, surfaces(reflecting));
    }

    /** Where nothing only reflects, all that reflects. */
    private List<AuditPoint> reflecting() {
        List<AuditPoint> all = points.stream().filter(AuditPoint::reflects).toList();
        List<AuditPoint> dark = all.stream().filter(point -> !point.emits()).toList();
        return dark.isEmpty() ? all : dark;
    }

    /**
     * U rho c / (1 - rho c): unshot flux reflected for ever, at most c of it arriving each time; c is the largest sum of
     * form factors at a point, and no less than 1, as the points may have missed where it is largest, nor than the part
     * of the flux shot so far that has arrived, as factors are not quite reciprocal.
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
     * What corners err by reaches a point by as much as interpolation leaves of it; the rest is interpolation's own. The
     * mean error is taken to be no less than its standard error: in white rooms it builds up to many times itself.
     */
    private void add(List<AuditPoint> some, int colour, double mean, double[] sum) {
        double bias = mean(some, p -> p.error(colour) / mean);
        double square = mean(some, p -> square(p.error(colour) / mean));
        double rays = mean(some, p -> square(p.errorAtVertex(colour) / mean));
        double raysLeft = mean(some, p -> p.spread * square(p.errorAtVertex(colour) / mean));
        double variance = Math.max(0, square - bias * bias);
        double uncertain = Math.max(bias * bias, variance / some.size());
        double times = amplification(colour);
        sum[0] += variance + uncertain * times * times;
        sum[1] += rays;
        sum[2] += Math.max(0, square - raysLeft);
        sum[3] += bias * times;
    }

    private static double square(double x) {
        return x * x;
    }

    /**
     * How often light that is lost at a point is lost by interreflection: 1 / (1 - share that comes back). Where by the
     * form factors all does, as often as it is at the largest reflectance.
     */
    private double amplification(int colour) {
        double shot = sum(ledger.shot(), colour);
        double received = sum(ledger.received(), colour);
        double absorbed = sum(ledger.absorbed(), colour);
        double lost = shot - received + absorbed;
        return shot <= 0 || absorbed <= 0 ? 1 : lost > 0 ? shot / lost : 1 / (1 - Surface.MAX_REFLECTANCE);
    }

    private double sum(double[] channels, int colour) {
        return DoubleStream.iterate(colour, c -> c < channels.length, c -> c + faces.colours())
                .map(c -> channels[(int) c]).sum();
    }
}
