package radiosity.solver;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import radiosity.settings.Accuracy;
import radiosity.setup.InitialMesh;
import radiosity.solution.Certificate;

/**
 * How exactly to sample and to mesh: at first as is expected to be exact enough, then, as long as independent points
 * find more error than was asked for, more exactly.
 */
final class AccuracyLoop {

    /** What is aimed at, relative to the mean square error that is asked for: what points find is uncertain. */
    private static final double MARGIN = 0.9;
    /** Part of that which is left to interpolation at least; what surfaces have too much or too little is its, too. */
    private static final double LEAST_FOR_MESH = 0.4;
    /** From one look at the solution to the next the mean square error is asked to fall to this part at most. */
    private static final double STEP = 0.4;
    /**
     * The loop ends where the error falls as a smaller power of the work, elements times rays: noise falls as the root
     * of rays, and the error of a mesh at the edges of shadows as that of elements. So many times the work tells.
     */
    private static final double SLOWEST = 0.25;
    private static final double GROWTH = 1.2;
    /** Looks: one of them may have met the worst element of all. */
    private static final int MOST_IN_VAIN = 2;
    /** And where this part of what is usual for the error that is asked for leaves it, or nothing is to be divided. */
    private static final double LEAST = 0.01;

    /** What is to be refined. */
    enum Refine { NOTHING, MESH, RAYS }

    private double asked;
    /** What one ray may carry, relative to the mean irradiance: at vertices that are made from now on. */
    private double tolerance;
    /** The same at the vertices that there are. */
    private double gathered;
    /** What interpolation on one element may add to the whole error. */
    private double meshError;
    /** Relative error that points found in the last look; NaN where none was made at a new aim. */
    private double reached = Double.POSITIVE_INFINITY;
    /** Work of that look: elements, over what a ray carried; 0 before the first. */
    private double work;
    /** Looks in a row that found it no better than the one before, for the work. */
    private int inVain;

    AccuracyLoop(InitialMesh mesh) {
        asked = mesh.accuracy();
        tolerance = mesh.tolerance();
        gathered = tolerance;
        meshError = mesh.meshError();
    }

    /** Relative error. */
    double asked() {
        return asked;
    }

    /** Relative error that points found in the last look; the one asked for before the first look. */
    double found() {
        return reached < Double.POSITIVE_INFINITY ? reached : asked;
    }

    /** Asks for less error than before. */
    void aim(double error) {
        asked = error;
        tolerance = Math.min(tolerance, Accuracy.tolerance(error));
        meshError = Math.min(meshError, Accuracy.meshError(error));
        reached = Double.NaN;
    }

    double tolerance() {
        return tolerance;
    }

    double meshError() {
        return meshError;
    }

    /*---- Light that is gathered anew and averaged with what there is: the noise of both is independent ----*/

    /** Whether the vertices that there are have gathered less exactly than new ones do. */
    boolean lacksRays() {
        return gathered > tolerance;
    }

    /**
     * Variance of light that is gathered anew, over that of what there is, for the average of both, each weighed by the
     * other's variance, to be as exact as new vertices are; at most 1.
     */
    private double varianceAnew() {
        double left = StrictMath.pow(tolerance / gathered, 2 / Accuracy.POWER);
        return left < 1 ? Math.min(1, left / (1 - left)) : 1;
    }

    /** What one ray may carry where light is gathered anew. */
    double toleranceAnew() {
        return gathered * StrictMath.pow(varianceAnew(), Accuracy.POWER / 2);
    }

    /** Weight of light that was gathered anew. */
    double weightAnew() {
        return 1 / (1 + varianceAnew());
    }

    /** All vertices have gathered anew. */
    void gatheredAnew() {
        gathered = tolerance;
    }

    /**
     * What to refine: nothing where the solution is as exact as was asked for, or cannot become so. The mesh where its
     * part of the error is too large, and then the elements that it still has; rays otherwise.
     *
     * <p>At the edge of a shadow the mean square error of a mesh falls as what one element may add, elsewhere faster:
     * where light is smooth, N elements leave 1 / N of the error, and each of them adds 1 / N^3 to the mean square.
     */
    Refine refine(Certificate certificate, int elements) {
        double found = certificate.expected();
        double now = elements / tolerance;
        boolean isNewAim = Double.isNaN(reached);
        boolean isBetter = isNewAim || work == 0 || found < reached * StrictMath.pow(now / work, -SLOWEST);
        inVain = isBetter ? 0 : now > GROWTH * work ? inVain + 1 : inVain;
        reached = found;
        work = now;
        if (found <= asked || inVain == MOST_IN_VAIN || !isBetter && isFinest()) {
            return Refine.NOTHING;
        }
        if (isNewAim) {
            return Refine.MESH;
        }
        double wanted = MARGIN * asked * asked;
        double rays = certificate.sampling() * certificate.sampling();
        double mesh = Math.max(0, found * found - rays);
        double forRays = Math.min(rays, (1 - LEAST_FOR_MESH) * wanted);
        if (mesh > wanted - forRays) {
            meshError *= Math.max(STEP, (wanted - forRays) / mesh);
            return Refine.MESH;
        }
        tolerance *= StrictMath.pow(Math.max(STEP, forRays / rays), Accuracy.POWER / 2);
        return Refine.RAYS;
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
