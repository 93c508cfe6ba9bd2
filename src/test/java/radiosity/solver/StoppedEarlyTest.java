package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Vec3;
import radiosity.settings.StopRule;
import radiosity.solution.EnergyLedger;
import radiosity.solution.Solution;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/**
 * A lamp above a hole in the ceiling, whose light the first mesh receives a third too much of: a calculation that is
 * stopped before it takes that back shows no light that was not emitted.
 */
class StoppedEarlyTest {

    private static final double[] X = {0, .98, 1.23, 2.45};
    private static final double[] Z = {0, .3, .38, .76};
    private static final double CEILING = .9;

    private static Scene recessedLamp() {
        SceneBuilder builder = new SceneBuilder();
        Box room = new Box(Vec3.ZERO, new Vec3(X[3], CEILING, Z[3]));
        Box recess = new Box(new Vec3(X[1], CEILING, Z[1]), new Vec3(X[2], CEILING + .15, Z[2]));
        for (int side = 0; side < 6; side++) {
            if (side != 3) {
                builder.polygon(RoomScenes.grey("wall", 0, .7), room.inside(side));
            }
            if (side != 2) {
                builder.polygon(RoomScenes.grey("recess", side == 3 ? 100 : 0, .7), recess.inside(side));
            }
        }
        for (int i = 0; i < 9; i++) {
            if (i != 4) {
                Box part = new Box(new Vec3(X[i / 3], 0, Z[i % 3]), new Vec3(X[i / 3 + 1], CEILING, Z[i % 3 + 1]));
                builder.polygon(RoomScenes.grey("ceiling", 0, .7), part.inside(3));
            }
        }
        return builder.scene("recessed lamp");
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4, 8, 12, 16})
    void receivesNoMoreThanWasShot(int shots) {
        Solve byDefault = Solve.byDefault().accurate(.5);
        Solution stopped = new Solve(byDefault.settings(), new StopRule(shots, StopRule.DEFAULT_UNSENT), 2)
                .solution(recessedLamp());
        EnergyLedger ledger = stopped.ledger();
        assertTrue(ledger.deficit(0) >= -1e-9 * ledger.shot()[0], "not received: " + ledger.deficit(0) + " W");
        assertEquals(0, ledger.imbalance(0), 1e-9);
        assertEquals(ledger.received()[0], shown(stopped), 1e-3 * ledger.received()[0]);
    }

    /** Flux that arrives by the solution's triangles, W. */
    private static double shown(Solution solution) {
        double flux = 0;
        for (int e = 0; e < solution.elements(); e++) {
            int[] c = {solution.corners()[3 * e], solution.corners()[3 * e + 1], solution.corners()[3 * e + 2]};
            Vec3 p = at(solution, c[0]);
            double area = at(solution, c[1]).minus(p).cross(at(solution, c[2]).minus(p)).length() / 2;
            double[] irradiance = solution.irradiance();
            flux += area / 3 * (irradiance[c[0]] + irradiance[c[1]] + irradiance[c[2]]);
        }
        return flux;
    }

    private static Vec3 at(Solution solution, int vertex) {
        double[] p = solution.positions();
        return new Vec3(p[3 * vertex], p[3 * vertex + 1], p[3 * vertex + 2]);
    }
}
