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
    /** The loop ends where a whole turn of it leaves more than this part of the error. */
    private static final double PROGRESS = 0.95;

    private final double asked;
    /** What one ray may carry, relative to the mean irradiance. */
    private double tolerance;
    /** What interpolation on one element may add to the whole error. */
    private double meshError;
    /** What points found last: relative error. */
    private double reached = Double.POSITIVE_INFINITY;

    AccuracyLoop(InitialMesh mesh) {
        asked = mesh.accuracy();
        tolerance = mesh.tolerance();
        meshError = mesh.meshError();
    }

    double tolerance() {
        return tolerance;
    }

    double meshError() {
        return meshError;
    }

    /**
     * Whether the solution is less exact than was asked for, and the last turn has made it more exact: then rays and
     * elements may add less from now on, each as far as the error is its own.
     *
     * <p>At the edge of a shadow the mean square error of a mesh falls as what one element may add, elsewhere faster.
     */
    boolean goesOn(Certificate certificate) {
        double before = reached;
        reached = certificate.expected();
        if (reached <= asked || reached > PROGRESS * before) {
            return false;
        }
        double wanted = MARGIN * asked * asked;
        double mesh = certificate.meshing() * certificate.meshing();
        double rest = Math.max(0, reached * reached - mesh);
        double forRest = Math.min(rest, (1 - LEAST_FOR_MESH) * wanted);
        if (rest > forRest) {
            tolerance = Accuracy.tolerance(Accuracy.of(tolerance) * Math.sqrt(Math.max(STEP, forRest / rest)));
        }
        if (mesh > wanted - forRest) {
            meshError *= Math.max(STEP, (wanted - forRest) / mesh);
        }
        return true;
    }

    void write(DataOutput out) throws IOException {
        out.writeDouble(tolerance);
        out.writeDouble(meshError);
        out.writeDouble(reached);
    }

    void read(DataInput in) throws IOException {
        tolerance = in.readDouble();
        meshError = in.readDouble();
        reached = in.readDouble();
    }
}
