package radiosity.solver;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import radiosity.settings.Accuracy;
import radiosity.setup.InitialMesh;
import radiosity.solution.Certificate;

/**
 * The tolerances of rays and mesh. They begin at values that are expected to reach the error asked for, and are lowered
 * as long as the certificate's independent points find a larger error.
 */
final class AccuracyLoop {

    /**
     * Mean square error aimed at, over the mean square error asked for. Estimates are uncertain by up to about a sixth,
     * and one that is too large by chance costs a finer mesh and another estimate, which takes as long as that.
     */
    private static final double MARGIN = 0.75;
    /** Part of the mean square error aimed at that is left to mesh and bias where they need it; rays have the rest. */
    private static final double LEAST_FOR_MESH = 0.4;
    /** Largest variance of a second sample over that of the first: with still fewer rays it takes as long. */
    private static final double MOST_VARIANCE = 4;
    /** Largest reduction of a mean square error from one estimate to the next, as a factor. */
    private static final double STEP = 0.4;
    /**
     * An estimate is in vain where the error fell so slowly that the error asked for, or half of the present error
     * where that is more, would take more than this multiple of the work, work being elements times rays. Noise falls
     * as the square root of rays, and the mesh error at shadow edges as that of elements.
     */
    private static final double MOST_WORK = 16;
    /** Growth of the work from which on an estimate in vain is counted. */
    private static final double GROWTH = 1.2;
    /** Estimates in vain, in a row, that end the loop: one of them may have met the worst element of the scene. */
    private static final int MOST_IN_VAIN = 2;
    /** An estimate in vain ends the loop where a tolerance is below this part of its value at the beginning. */
    private static final double LEAST = 0.01;

    /** What is to be refined. */
    enum Refine { NOTHING, MESH, RAYS }

    private double asked;
    /** Irradiance that one ray may carry at vertices made from now on, over the mean irradiance. */
    private double tolerance;
    /** Irradiance that one ray has carried at the present vertices, over the mean irradiance. */
    private double gathered;
    /** Error that interpolation on one element may add to the error of the whole solution. */
    private double meshError;
    /**
     * Relative error of the last estimate; infinite before the first one. NaN before the first one at a new aim, where
     * that asks for a finer mesh than the last estimate: the mesh is divided then, whatever the estimate says.
     */
    private double reached = Double.POSITIVE_INFINITY;
    /** Work at the last estimate: number of elements over {@link #tolerance}; 0 before the first estimate. */
    private double work;
    /** Number of estimates in vain in a row. */
    private int inVain;

    AccuracyLoop(InitialMesh mesh) {
        asked = mesh.accuracy();
        tolerance = mesh.tolerance();
        gathered = tolerance;
        meshError = mesh.meshError();
    }

    /** The relative error asked for. */
    double asked() {
        return asked;
    }

    /** The relative error of the last estimate; the error asked for where there was no estimate. */
    double found() {
        return reached < Double.POSITIVE_INFINITY ? reached : asked;
    }

    /**
     * Lowers the relative error asked for, and the tolerances to those with which a calculation of that accuracy
     * begins. If an estimate is known, they are lowered no further than mean square errors have to fall since then: a
     * scene whose error is half of what its tolerances promise needs no finer ones to halve it.
     */
    void aim(double error) {
        asked = error;
        double falls = reached < Double.POSITIVE_INFINITY ? MARGIN * square(error / reached) : 0;
        double rays = Math.max(Accuracy.tolerance(error), tolerance * StrictMath.pow(falls, Accuracy.POWER / 2));
        double mesh = Math.max(Accuracy.meshError(error), meshError * falls);
        reached = mesh < meshError ? Double.NaN : Double.POSITIVE_INFINITY;
        tolerance = Math.min(tolerance, rays);
        meshError = Math.min(meshError, mesh);
    }

    /** Forgets earlier estimates, which were those of another scene. */
    void forget() {
        reached = Double.POSITIVE_INFINITY;
        work = 0;
        inVain = 0;
    }

    double tolerance() {
        return tolerance;
    }

    double meshError() {
        return meshError;
    }

    /*---- A second, independent sample of the irradiance at all vertices, and its average with the first ----*/

    /** Whether present vertices have gathered with a larger tolerance than new vertices do. */
    boolean lacksRays() {
        return gathered > tolerance;
    }

    /**
     * Variance of the second sample over the variance of the first, such that their average, weighted by inverse
     * variance, has the variance of new vertices; at most {@link #MOST_VARIANCE}.
     */
    private double varianceAnew() {
        double left = StrictMath.pow(tolerance / gathered, 2 / Accuracy.POWER);
        return left < 1 ? Math.min(MOST_VARIANCE, left / (1 - left)) : 1;
    }

    /** Irradiance that one ray may carry in the second sample, over the mean irradiance. */
    double toleranceAnew() {
        return gathered * StrictMath.pow(varianceAnew(), Accuracy.POWER / 2);
    }

    /** Weight of the second sample in the average, from 0 to 1. */
    double weightAnew() {
        return 1 / (1 + varianceAnew());
    }

    /** Notes that the second sample was averaged with the first. */
    void gatheredAnew() {
        gathered = tolerance;
    }

    /**
     * Chooses what to refine and lowers its tolerance: of rays and mesh, to which the bias is counted, the one whose
     * mean square error is the larger multiple of its part of the one aimed at; nothing where the error, without the
     * uncertainty of its bias, is at most the error asked for, or where the error no longer falls.
     *
     * <p>At shadow edges the mean square error of a mesh is proportional to {@link #meshError}; elsewhere the mean
     * square error falls faster: where light is smooth, N elements have an error of 1 / N, and each adds 1 / N^3 to its
     * square.
     *
     * @param marked   part of the mean square error that falls away as marked elements are divided, from 0 to 1; not
     *                 relied on where the error has not fallen since the last estimate
     * @param elements number of elements in the scene
     */
    Refine refine(Certificate certificate, double marked, int elements) {
        double found = certificate.expected();
        double certain = Math.sqrt(Math.max(0, square(found) - square(certificate.uncertainty())));
        double now = elements / tolerance;
        boolean isNewAim = Double.isNaN(reached);
        double slowest = StrictMath.log(Math.max(1, Math.min(2, found / asked))) / StrictMath.log(MOST_WORK);
        boolean isBetter = isNewAim || work == 0 || found < reached * StrictMath.pow(now / work, -slowest);
        inVain = isBetter ? 0 : now > GROWTH * work ? inVain + 1 : inVain;
        reached = found;
        work = now;
        if (certain <= asked || inVain == MOST_IN_VAIN || !isBetter && isFinest()) {
            return Refine.NOTHING;
        }
        if (isNewAim) {
            return Refine.MESH;
        }
        double wanted = MARGIN * asked * asked;
        double rays = square(certificate.sampling());
        double mesh = Math.max(0, square(certain) - rays);
        double forRays = Math.min(rays, Math.max((1 - LEAST_FOR_MESH) * wanted, wanted - mesh));
        double forMesh = wanted - forRays;
        if (rays == 0 || mesh * forRays > rays * forMesh) {
            double left = isBetter ? mesh * (1 - marked) : mesh;
            if (left > forMesh) {
                meshError *= Math.max(STEP, forMesh / left);
            }
            return Refine.MESH;
        }
        tolerance *= StrictMath.pow(Math.max(STEP, forRays / rays), Accuracy.POWER / 2);
        return Refine.RAYS;
    }

    private static double square(double x) {
        return x * x;
    }

    private boolean isFinest() {
        return meshError < LEAST * Accuracy.meshError(asked) || meshError == Double.POSITIVE_INFINITY
                || tolerance < LEAST * Accuracy.tolerance(asked);
    }

    void write(DataOutput out) throws IOException {
        out.writeDouble(asked);
        out.writeDouble(tolerance);
        out.writeDouble(gathered);
        out.writeDouble(meshError);
        out.writeDouble(reached);
        out.writeDouble(work);
        out.writeInt(inVain);
    }

    void read(DataInput in) throws IOException {
        asked = in.readDouble();
        tolerance = in.readDouble();
        gathered = in.readDouble();
        meshError = in.readDouble();
        reached = in.readDouble();
        work = in.readDouble();
        inVain = in.readInt();
    }
}
