package radiosity.certificate;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import radiosity.mesh.face.Faces;
import radiosity.scene.Surface;
import radiosity.setup.InitialMesh;
import radiosity.solution.EnergyLedger;

/**
 * By how much all light of a colour is off, as interreflection makes many times more of what is lost, or is too much,
 * at every point.
 *
 * <p>What the points tell of it is uncertain, in white rooms 10,000 times as uncertain. But it is known in another way
 * too: what the solution has received is counted, and all that leaves it arrives, but for what escapes; in a room
 * that is proven closed nothing does. So the mean of the points' errors is corrected by as much as the mean of what
 * they have received is found to be off from what is counted.
 */
final class AuditBias {

    /*
     * Regression estimator, and the variance of a weighted mean by squared deviations: W. G. Cochran, Sampling
     * techniques, 1977, chapters 7 and 6. What is counted has a variance v too, that of the rays by which escaping is
     * found; the slope covariance / (variance + v) leaves the least variance of both together.
     */
    private final Faces faces;
    private final EnergyLedger ledger;
    private final int colour;
    /** 1 per point: area, which they have in common between them, of the scene's squared size. */
    private final double[] area;
    /** All flux that leaves surfaces, of the scene's squared size: what all others are relative to. */
    private final double unit;
    /**
     * 1 per point each: flux too much that it reflects, that it has received, and that is not to be expected elsewhere.
     */
    private final double[] reflected;
    private final double[] received;
    private final double[] unaccounted;
    /** Of the reflected one, and its standard error. */
    private final double flux;
    private final double error;
    /** Mean reflectance times whole area. */
    private final double reflecting;

    /** @param points all, those too that are buried */
    AuditBias(InitialMesh mesh, List<AuditPoint> points, int batches, EnergyLedger ledger, int colour) {
        faces = mesh.faces;
        this.ledger = ledger;
        this.colour = colour;
        double squared = faces.size() * faces.size();
        double leaving = (sum(ledger.shot()) + sum(ledger.unshot())) / squared;
        unit = leaving > 0 ? leaving : 1;
        area = points.stream().mapToDouble(p -> p.area / batches).toArray();
        reflected = each(i -> points.get(i).reflectance(colour) * points.get(i).excess(colour));
        received = each(i -> points.get(i).excess(colour));
        unaccounted = each(i -> points.get(i).unaccounted(colour));
        double strongest = IntStream.range(0, area.length).filter(i -> !isClosed(mesh, points.get(i)))
                .mapToDouble(i -> area[i] * points.get(i).leaving(colour) / unit / Escape.RAYS).max().orElse(0);
        // that no ray escapes does not tell that none would: the strongest might
        double uncertain = moment(unaccounted, unaccounted) + strongest * strongest;
        double spread = moment(received, received) + uncertain;
        double slope = spread > 0 ? moment(reflected, received) / spread : 0;
        double counted = sum(ledger.received()) / squared / unit - leaving / unit + Arrays.stream(unaccounted).sum();
        flux = Arrays.stream(reflected).sum() - slope * (Arrays.stream(received).sum() - counted);
        error = Math.sqrt(Math.max(0, moment(reflected, reflected) - slope * moment(reflected, received)));
        reflecting = IntStream.range(0, area.length).mapToDouble(i -> area[i] * points.get(i).reflectance(colour))
                .sum();
    }

    private double[] each(IntToDoubleFunction perArea) {
        return IntStream.range(0, area.length).mapToDouble(i -> area[i] * (perArea.applyAsDouble(i) / unit)).toArray();
    }

    private static boolean isClosed(InitialMesh mesh, AuditPoint point) {
        return point.isBuried || mesh.rooms.room(point.face) >= 0;
    }

    /** Covariance of the sums of two. */
    private double moment(double[] a, double[] b) {
        double all = Arrays.stream(area).sum();
        double meanA = Arrays.stream(a).sum() / all;
        double meanB = Arrays.stream(b).sum() / all;
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += (a[i] - area[i] * meanA) * (b[i] - area[i] * meanB);
        }
        return sum;
    }

    /** Mean radiosity by which interreflection alone puts surfaces off that reflect so much on average, W/m². */
    double spread(double reflectance) {
        return flux * unit * perReflectance() * reflectance;
    }

    /** Standard error of that. */
    double uncertainty(double reflectance) {
        return error * unit * perReflectance() * reflectance;
    }

    private double perReflectance() {
        return reflecting > 0 ? (amplification() - 1) / reflecting : 0;
    }

    /**
     * How often light that is lost at a point is lost by interreflection: 1 / (1 - share that comes back). Where by the
     * form factors all does, as often as it is at the largest reflectance.
     */
    private double amplification() {
        double shot = sum(ledger.shot());
        double absorbed = sum(ledger.absorbed());
        double lost = shot - sum(ledger.received()) + absorbed;
        return shot <= 0 || absorbed <= 0 ? 1 : lost > 0 ? shot / lost : 1 / (1 - Surface.MAX_REFLECTANCE);
    }

    private double sum(double[] channels) {
        return DoubleStream.iterate(colour, c -> c < channels.length, c -> c + faces.colours())
                .map(c -> channels[(int) c]).sum();
    }
}
