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
    /** Part of that which is left to interpolation at least. */
    private static final double LEAST_FOR_MESH = 0.4;
    /** From one look at the solution to the next the mean square error is asked to fall to this part at most. */
    private static final double STEP = 0.25;
    /**
     * The mean square error falls as this power of what one element may add: N elements leave 1 / N of the error where
     * light is smooth, so each of them adds 1 / N^3 to the mean square, the square of what is asked of it.
     */
    private static final double MESH_POWER = 4.0 / 3;
    /** The loop ends where so many times as many elements leave more than this part of the error. */
    private static final double PROGRESS = 0.95;
    private static final double GROWTH = 1.2;
    /** And where this part of what is usual for the error that is asked for leaves it: that is not its cause. */
    private static final double LEAST = 0.01;

    private double asked;
    /** What one ray may carry, relative to the mean irradiance. */
    private double tolerance;
    /** What interpolation on one element may add to the whole error. */
    private double meshError;
    /** What points found last: relative error; NaN where that was before there was a new aim. */
    private double reached = Double.POSITIVE_INFINITY;
    /** Elements that there were then. */
    private int elements;

    AccuracyLoop(InitialMesh mesh) {
        asked = mesh.accuracy();
        tolerance = mesh.tolerance();
        meshError = mesh.meshError();
    }

    /** Relative error. */
    double asked() {
        return asked;
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

    /**
     * Whether the solution is less exact than was asked for, and can become more exact: then rays and elements may add
     * less from now on, each as far as the error is its own.
     *
     * <p>At the edge of a shadow the mean square error of a mesh falls as what one element may add, elsewhere faster.
     */
    boolean goesOn(Certificate certificate, int elementsNow) {
        boolean isNewAim = Double.isNaN(reached);
        boolean hasGrown = elementsNow > GROWTH * elements;
        boolean isBetter = certificate.expected() <= PROGRESS * reached;
        reached = certificate.expected();
        if (isNewAim || reached <= asked || !isBetter && (hasGrown || isFinest())) {
            return isNewAim && reached > asked;
        }
        elements = elementsNow;
        double wanted = MARGIN * asked * asked;
        double mesh = certificate.meshing() * certificate.meshing();
        double rest = Math.max(0, reached * reached - mesh);
        double forRest = Math.min(rest, (1 - LEAST_FOR_MESH) * wanted);
        if (rest > forRest) {
            tolerance = Accuracy.tolerance(Accuracy.of(tolerance) * Math.sqrt(Math.max(STEP, forRest / rest)));
        }
        if (mesh > wanted - forRest) {
            meshError *= StrictMath.pow(Math.max(STEP, (wanted - forRest) / mesh), 1 / MESH_POWER);
        }
        return true;
    }

    private boolean isFinest() {
        return meshError < LEAST * Accuracy.meshError(asked) || tolerance < LEAST * Accuracy.tolerance(asked);
    }

    void write(DataOutput out) throws IOException {
        out.writeDouble(asked);
        out.writeDouble(tolerance);
        out.writeDouble(meshError);
        out.writeDouble(reached);
        out.writeInt(elements);
    }

    void read(DataInput in) throws IOException {
        asked = in.readDouble();
        tolerance = in.readDouble();
        meshError = in.readDouble();
        reached = in.readDouble();
        elements = in.readInt();
    }
}
