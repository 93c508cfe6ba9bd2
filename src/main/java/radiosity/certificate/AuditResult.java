package radiosity.certificate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.DoubleBinaryOperator;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import radiosity.mesh.face.Faces;
import radiosity.protocol.Mark;
import radiosity.scene.Surface;
import radiosity.settings.Accuracy;
import radiosity.setup.InitialMesh;
import radiosity.solution.Certificate;
import radiosity.solution.EnergyLedger;

/** Combines the points of an {@link Audit} into a {@link Certificate}. */
final class AuditResult {

    /** Share of the area, with the largest errors, that the expected error leaves out. */
    private static final double TAIL = 1.0 / 2000;

    private final Faces faces;
    /** Points that are not buried and see other surfaces or have light. */
    private final List<AuditPoint> points;
    private final EnergyLedger ledger;
    /** 1 per colour. */
    private final AuditBias[] bias;
    /** 1 per colour: mean radiosity at the points that reflect, W/m². */
    private final double[] means;
    /** Errors of all points that reflect. */
    private final Errors errors;

    /**
     * @param all     all points, buried ones included
     * @param batches number of batches; each batch represents the whole scene
     */
    AuditResult(InitialMesh mesh, List<AuditPoint> all, int batches, EnergyLedger ledger) {
        faces = mesh.faces;
        points = all.stream().filter(p -> !p.isBuried && !p.isDark()).toList();
        this.ledger = ledger;
        bias = new AuditBias[faces.colours()];
        Arrays.setAll(bias, c -> new AuditBias(mesh, all, batches, ledger, c));
        List<AuditPoint> reflecting = reflecting();
        means = new double[faces.colours()];
        Arrays.setAll(means, c -> mean(reflecting, p -> p.radiosity(c)));
        errors = errors(reflecting);
    }

    /** Expected error, relative to the mean radiosity. */
    double expected() {
        return Math.sqrt(errors.total);
    }

    /** Standard error of the bias, relative to the mean radiosity: part of {@link #expected}. */
    double biasUncertainty() {
        return Math.sqrt(errors.uncertainty);
    }

    Certificate certificate(double unshotFlux, double reciprocity) {
        List<AuditPoint> detailed = detailed(points);
        double most = detailed.stream().mapToDouble(AuditPoint::factors).max().orElse(0);
        return new Certificate(points.size(), missing(unshotFlux, most), mean(detailed, AuditPoint::factors), most,
                reciprocity, expected(), Math.sqrt(errors.sampling), Math.sqrt(errors.meshing), errors.bias,
                biasUncertainty(), surfaces(reflecting()));
    }

    /** Returns the points that reflect and do not emit; where there are none, all points that reflect. */
    private List<AuditPoint> reflecting() {
        List<AuditPoint> all = points.stream().filter(AuditPoint::reflects).toList();
        List<AuditPoint> dark = all.stream().filter(point -> !point.emits()).toList();
        return dark.isEmpty() ? all : dark;
    }

    private static List<AuditPoint> detailed(List<AuditPoint> some) {
        return some.stream().filter(point -> point.isDetailed).toList();
    }

    /**
     * Returns U rho c / (1 - rho c), the unshot flux U reflected for ever with at most the part c arriving each time,
     * in W; null where rho c is 1 or more. c is the largest sum of form factors at a point; at least 1, as the points
     * may have missed the largest sum; and at least the part of all shot flux that has arrived, as form factors are not
     * quite reciprocal.
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
        Map<Surface, Double> squares = new LinkedHashMap<>();
        Trimmed square = Trimmed.of(reflecting, sums(reflecting, (e, noise) -> square(e) - square(noise)));
        for (int i = 0; i < square.area.length; i++) {
            Surface surface = faces.scene().surface(faces.triangle(reflecting.get(i).face));
            bySurface.computeIfAbsent(surface, s -> new ArrayList<>()).add(reflecting.get(i));
            squares.merge(surface, square.area[i] * square.values[i], Double::sum);
        }
        squares.replaceAll((surface, sum) -> Math.max(0, sum));
        double all = squares.values().stream().mapToDouble(x -> x).sum();
        List<Certificate.SurfaceError> errors = new ArrayList<>();
        bySurface.forEach((surface, some) -> {
            Errors of = errors(some);
            double mean = 0;
            for (int c = 0; c < faces.colours(); c++) {
                int colour = c;
                mean += mean(some, p -> p.radiosity(colour)) / faces.colours();
            }
            errors.add(new Certificate.SurfaceError(surface.name(), some.size(), mean, Math.sqrt(of.sampling),
                    Math.sqrt(of.meshing), all == 0 ? 0 : squares.get(surface) / all));
        });
        return errors;
    }

    /**
     * Mean square of an error, minus the square of the noise of the audit's rays: the mean product of two independent
     * estimates of the error. The share {@link #TAIL} of the area where that product is largest by absolute value is
     * left out. Errors have a heavy tail: a gap of millimetres beside a lamp may err by ten times the mean of the
     * scene. A point that falls there by chance would be half of the mean square, and no affordable number of points
     * tells how much area of this kind there is (R. R. Wilcox, Introduction to Robust Estimation and Hypothesis
     * Testing, 2012, on trimmed means). Noise has such a tail, too: one estimate of a point may hold the error of a
     * bright place near by, and the other not. Their product is far below 0 then.
     */
    private static double meanSquare(List<AuditPoint> some, ToDoubleFunction<AuditPoint> error,
                                     ToDoubleFunction<AuditPoint> noise) {
        return Math.max(0, Trimmed.of(some, some.stream()
                .mapToDouble(p -> square(error.applyAsDouble(p)) - square(noise.applyAsDouble(p))).toArray()).mean());
    }

    /**
     * Areas that points represent, less the share {@link #TAIL} of their sum that has the largest absolute values.
     *
     * @param values 1 per area
     * @param whole  sum of the areas left
     * @param sum    sum of these areas times the values
     */
    record Trimmed(double[] area, double[] values, double whole, double sum) {

        private static Trimmed of(List<AuditPoint> some, double[] values) {
            return of(some.stream().mapToDouble(p -> p.area).toArray(), values);
        }

        /**
         * @param areas  1 per point, not modified
         * @param values 1 per point, of either sign; not modified
         */
        static Trimmed of(double[] areas, double[] values) {
            double[] area = trimmed(Arrays.stream(values).map(Math::abs).toArray(), areas);
            double sum = 0;
            for (int i = 0; i < area.length; i++) {
                sum += area[i] * values[i];
            }
            return new Trimmed(area, values, Arrays.stream(area).sum(), sum);
        }

        /** Mean of the values over the areas left; 0 where no area is left. */
        double mean() {
            return whole == 0 ? 0 : sum / whole;
        }
    }

    /**
     * Returns the areas less the share {@link #TAIL} of their sum that has the largest values.
     *
     * @param values 1 per area, not modified; nor are areas
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

    /** Mean squares relative to the squared mean radiosity; the bias relative to the mean radiosity. */
    private record Errors(double total, double sampling, double meshing, double bias, double uncertainty) { }

    /** Returns the mean over the colours that have light. */
    private Errors errors(List<AuditPoint> some) {
        double[] sum = new double[5];
        int lit = 0;
        for (int c = 0; c < faces.colours(); c++) {
            int colour = c;
            double mean = mean(some, p -> p.radiosity(colour));
            if (mean > 0) {
                lit++;
                add(some, colour, mean, sum);
            }
        }
        return lit == 0 ? new Errors(0, 0, 0, 0, 0)
                : new Errors(sum[0] / lit, sum[1] / lit, sum[2] / lit, sum[3] / lit, sum[4] / lit);
    }

    /**
     * Adds the errors of one colour. Errors at the corners reach a point weakened by interpolation, and the rest of the
     * error there is due to interpolation itself. The noise of the audit's own rays is subtracted. The error that
     * interreflection makes of the mean error is taken to be no less than its standard error.
     *
     * @param sum modified: 5, in the order of {@link Errors}
     */
    private void add(List<AuditPoint> some, int colour, double mean, double[] sum) {
        double local = mean(some, p -> p.error(colour) / unit(p.radiosity(colour), mean));
        double square = meanSquare(some, p -> p.error(colour) / unit(p.radiosity(colour), mean),
                p -> p.noise(colour) / unit(p.radiosity(colour), mean));
        double raysLeft = atCorners(detailed(some), colour, mean) * mean(some, p -> p.spread);
        double reflectance = mean(some, p -> p.reflectance(colour));
        double all = local + bias[colour].spread(reflectance) / mean;
        double uncertain = bias[colour].uncertainty(reflectance) / mean;
        sum[0] += Math.max(0, square - local * local) + Math.max(square(all), square(uncertain));
        sum[1] += raysLeft;
        sum[2] += Math.max(0, square - raysLeft);
        sum[3] += all;
        sum[4] += square(uncertain);
    }

    /** Returns the mean square error at the corners of elements, relative to the mean radiosity. */
    private static double atCorners(List<AuditPoint> detailed, int colour, double mean) {
        return meanSquare(detailed, p -> p.errorAtVertex(colour) / unitAtVertex(p, colour, mean),
                p -> p.noiseAtVertex(colour) / unitAtVertex(p, colour, mean));
    }

    private static double unitAtVertex(AuditPoint point, int colour, double mean) {
        return unit(point.radiosityAtVertex(colour), mean);
    }

    /** Returns the larger of mean radiosity and a part of the point's radiosity: unit of errors, W/m². */
    private static double unit(double radiosity, double mean) {
        return Math.max(mean, radiosity / Accuracy.BRIGHT);
    }

    /**
     * Standard error of the mean square error, relative to the mean square error; 0 where no point errs, infinite where
     * all of the error may be noise.
     */
    double uncertainty() {
        List<AuditPoint> some = reflecting();
        double[] error = sums(some, (e, noise) -> square(e) - square(noise));
        Trimmed left = Trimmed.of(some, error);
        double deviation = 0;
        for (int i = 0; i < error.length; i++) {
            deviation += square(left.area[i] * error[i] - left.area[i] / left.whole * left.sum);
        }
        return deviation == 0 ? 0 : left.sum > 0 ? Math.sqrt(deviation) / left.sum : Double.POSITIVE_INFINITY;
    }

    /**
     * The elements to be divided, and their share of the mean square. That has the noise of all points in it, which
     * makes the share smaller than it is: elements are marked where errors are clearly more than noise, so without the
     * noise the share would be chosen by its own result, near 1 always.
     *
     * @param meshError largest error times square root of the share of area that an element may have, above 0
     */
    Marked marked(double meshError) {
        List<AuditPoint> some = reflecting();
        Set<Mark> marks = new LinkedHashSet<>();
        double[] square = sums(some, (e, noise) -> square(e));
        Trimmed left = Trimmed.of(some, square);
        double sum = 0;
        for (int i = 0; i < square.length; i++) {
            double ratio = certain(some.get(i)) * Math.sqrt(some.get(i).elementArea / faces.area()) / meshError;
            if (ratio > 1) {
                marks.add(some.get(i).mark(divisions(ratio)));
                sum += left.area[i] * square[i];
            }
        }
        return new Marked(List.copyOf(marks), left.sum > 0 ? sum / left.sum : 0);
    }

    /** How often an element is divided until an error times the root of its area has fallen by a factor above 1. */
    private static int divisions(double factor) {
        int divisions = 1;
        for (double fallen = 2; fallen < factor; fallen *= 2) {
            divisions++;
        }
        return divisions;
    }

    /** Error of a point but for the noise of its rays, relative to the mean radiosity; the largest over the colours. */
    private double certain(AuditPoint point) {
        double largest = 0;
        for (int c = 0; c < faces.colours(); c++) {
            double mean = means[c];
            if (mean > 0) {
                largest = Math.max(largest, (Math.abs(point.error(c)) - Math.abs(point.noise(c)))
                        / unit(point.radiosity(c), mean));
            }
        }
        return largest;
    }

    /**
     * One sum per point: a function of the error and the noise of the point, both relative to the mean radiosity, added
     * up over the colours that have light.
     */
    private double[] sums(List<AuditPoint> some, DoubleBinaryOperator ofErrorAndNoise) {
        double[] sum = new double[some.size()];
        for (int c = 0; c < faces.colours(); c++) {
            for (int i = 0; i < sum.length && means[c] > 0; i++) {
                AuditPoint point = some.get(i);
                double unit = unit(point.radiosity(c), means[c]);
                sum[i] += ofErrorAndNoise.applyAsDouble(point.error(c) / unit, point.noise(c) / unit);
            }
        }
        return sum;
    }

    private static double square(double x) {
        return x * x;
    }
}
