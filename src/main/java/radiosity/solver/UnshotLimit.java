package radiosity.solver;

import java.util.List;
import radiosity.mesh.Weights;
import radiosity.prediction.CoarseSystem;
import radiosity.protocol.Answer;
import radiosity.protocol.Shot;
import radiosity.settings.StopRule;
import radiosity.setup.InitialMesh;

/** How much unshot flux the default schedule may leave before it divides the mesh or estimates the error. */
final class UnshotLimit {

    /**
     * Sum of |unshot flux| over emitted flux that may be left, per relative error: most unshot flux has both signs. The
     * root mean square of the change of radiosity that unshot light is predicted to cause has the same limit.
     */
    private static final double ENOUGH = 0.3;
    /** |Sum of unshot flux| over emitted flux, or mean of the change, per relative error asked for: this is a bias. */
    private static final double ENOUGH_ONE_SIDED = 0.1;

    private final InitialMesh mesh;
    private final SolveCounters counters;
    private final CoarseSystem coarse;
    private final AccuracyLoop loop;
    private final double wanted;
    private final double[] weight;

    /**
     * @param counters flux of the calculation so far
     * @param coarse   predicts what unshot light changes; null where nothing is predicted
     * @param loop     errors asked for and estimated
     * @param wanted   unshot flux over emitted flux at which the calculation may end
     * @param weight   see {@link Weights}; kept, and read whenever a method is called
     */
    UnshotLimit(InitialMesh mesh, SolveCounters counters, CoarseSystem coarse, AccuracyLoop loop, double wanted,
            double[] weight) {
        this.mesh = mesh;
        this.counters = counters;
        this.coarse = coarse;
        this.loop = loop;
        this.wanted = wanted;
        this.weight = weight;
    }

    /**
     * Unshot flux over emitted flux at which shooting ends: a part of the larger of the estimated error and the error
     * asked for, or the user's own limit where that is lower than the default.
     */
    double flux() {
        return wanted < StopRule.DEFAULT_UNSENT ? wanted : Math.max(wanted, ENOUGH * error());
    }

    private double error() {
        return Math.max(loop.asked(), loop.found());
    }

    /** |Sum of unshot flux| over emitted flux at which shooting ends. */
    double oneSided() {
        return Math.max(wanted, ENOUGH_ONE_SIDED * loop.asked());
    }

    /**
     * Whether the unshot flux itself is a small part of the error.
     *
     * @param unsent unshot flux over emitted flux
     */
    boolean isMet(Answer last, double unsent) {
        return unsent <= flux() && counters.flux.oneSided(last) <= oneSided();
    }

    /**
     * Whether the radiosity changes by a small part of the error by the light that unshot flux is predicted to cause.
     * After new vertices have gathered, most unshot flux is their noise, of both signs, which cancels where it arrives.
     *
     * @param h      predicted irradiance, channels per vertex of the coarse mesh, W/m²
     * @param totals radiosity that every patch has shot so far
     */
    boolean changesLittle(double[] h, List<Shot> totals) {
        double[] radiosity = coarse.restrict(totals);
        Weights weights = new Weights(mesh.rooms, mesh.faces.channels(), weight);
        for (int c = 0; c < mesh.faces.channels(); c++) {
            CoarseSystem.Change change = coarse.change(h, radiosity, weights, c);
            if (change.size() > ENOUGH * error() || Math.abs(change.bias()) > ENOUGH_ONE_SIDED * loop.asked()) {
                return false;
            }
        }
        return true;
    }

    /**
     * Whether the rest that {@link #isMet} and {@link #changesLittle} leave is shot before an estimate all the same, by
     * few rays. The coarse system does not see everything that unshot light changes: in a gap between a wall and the
     * back of a cabinet, where both were lit as the mesh was coarse, each would keep the light that it has received of
     * the other. Not in white rooms, where rays must be the same in every round.
     *
     * @param unsent unshot flux over emitted flux
     */
    boolean leavesTooMuch(double unsent) {
        return wanted == StopRule.DEFAULT_UNSENT && !mesh.rounding.exact()
                && unsent > Math.max(wanted, ENOUGH * loop.asked());
    }
}
