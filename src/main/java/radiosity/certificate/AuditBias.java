package radiosity.certificate;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import radiosity.formfactor.EscapingLight;
import radiosity.mesh.face.Faces;
import radiosity.scene.Surface;
import radiosity.setup.InitialMesh;
import radiosity.solution.EnergyLedger;

/**
 * Estimates the error that all light of a colour has in common: interreflection multiplies any flux that is lost, or is
 * in excess, and spreads it over all surfaces.
 *
 * <p>The mean error of the points is a poor estimate: its uncertainty is multiplied too, 10,000 times in a white
 * room. But the flux that the solution has received is known exactly from the ledger, and all flux that leaves
 * surfaces arrives, except for what escapes; from a room that is proven closed nothing escapes. So the mean error of
 * the points is corrected by the difference between the excess of received flux that the points find and the excess
 * that follows from the ledger.
 */
final class AuditBias {

    /*
     * Regression estimator, and the variance of a weighted mean by squared deviations: W. G. Cochran, Sampling
     * techniques, 1977, chapters 7 and 6. The excess from the ledger has a variance v too, as escaping flux is found by
     * rays; the slope covariance / (variance + v) minimises the variance of the combined estimate.
     */
    private final Faces faces;
    private final EnergyLedger ledger;
    private final int colour;
    /** 1 per point: area that the point represents among all batches, in units of the squared scene size. */
    private final double[] area;
    /** All flux that leaves surfaces, W over the squared scene size; all fluxes below are relative to this flux. */
    private final double unit;
    /**
     * 1 per point each: excess of reflected flux, excess of received flux, and flux leaving the point that is not
     * expected to arrive elsewhere.
     */
    private final double[] reflected;
    private final double[] received;
    private final double[] unaccounted;
    /** Estimated excess of reflected flux in the whole scene, and its standard error. */
    private final double flux;
    private final double error;
    /** Mean reflectance times area of all faces, in units of the squared scene size. */
    private final double reflecting;

    /**
     * @param points  all points, buried ones included
     * @param batches number of batches of points; each batch represents the whole scene
     */
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
                .mapToDouble(i -> area[i] * points.get(i).leaving(colour) / unit / EscapingLight.RAYS).max().orElse(0);
        // even where no ray escapes, the ray that carries most light might have escaped
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

    /** Estimated covariance of the sums of two quantities, each given as one value per point. */
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

    /** Error that interreflection adds to surfaces of this mean reflectance, W/m²; positive: too bright. */
    double spread(double reflectance) {
        return flux * unit * perReflectance() * reflectance;
    }

    /** Standard error of {@link #spread}, W/m². */
    double uncertainty(double reflectance) {
        return error * unit * perReflectance() * reflectance;
    }

    private double perReflectance() {
        return reflecting > 0 ? (amplification() - 1) / reflecting : 0;
    }

    /**
     * Returns the factor by which interreflection multiplies a loss of flux: 1 / (1 - share of shot flux that is
     * reflected); 1 where nothing was shot or absorbed. Where at least as much is reflected as was shot, because form
     * factors are not exact, the factor of the largest reflectance allowed.
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
