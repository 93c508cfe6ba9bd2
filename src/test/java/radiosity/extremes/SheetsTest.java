package radiosity.extremes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.testkit.Box;
import radiosity.testkit.Evaluate;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/** Whole renders of rooms with sheets: two faces back to back in one place, or one face whose back is not modelled. */
@Tag("slow")
class SheetsTest {

    private static final Surface WALL = RoomScenes.grey("wall", 0, .5);
    private static final Surface LAMP = RoomScenes.grey("lamp", 10, 0);
    private static final double ACCURACY = .05;

    private static void addDouble(SceneBuilder builder, Surface surface, Vec3... corner) {
        builder.polygon(surface, corner[0], corner[1], corner[2], corner[3]);
        builder.polygon(surface, corner[3], corner[2], corner[1], corner[0]);
    }

    /** @param isDouble whether the walls are modelled from outside, too */
    private static SceneBuilder room(boolean isDouble) {
        SceneBuilder builder = new SceneBuilder();
        for (int side = 0; side < 6; side++) {
            Vec3[] wall = Box.UNIT.inside(side);
            if (isDouble) {
                addDouble(builder, WALL, wall);
            } else {
                builder.polygon(WALL, wall);
            }
        }
        // below the ceiling, shining downwards
        builder.polygon(LAMP, new Vec3(.3, .3, .99), new Vec3(.3, .7, .99), new Vec3(.7, .7, .99),
                new Vec3(.7, .3, .99));
        return builder;
    }

    private static Solution solve(Scene scene) {
        return Solve.byDefault().accurate(ACCURACY).solution(scene);
    }

    private static double at(Solution solution, Vec3 place, Vec3 normal) {
        return Evaluate.radiosity(solution,
                new double[] {place.x(), place.y(), place.z(), normal.x(), normal.y(), normal.z()})[0];
    }

    @Test
    void roomOfDoubleWalls_isLitAsOneOfSingleWalls() {
        Solution twice = solve(room(true).scene("double"));
        Solution once = solve(room(false).scene("single"));
        assertEquals(1, twice.ledger().absorbed()[0] / once.ledger().absorbed()[0], 2 * ACCURACY);
        Vec3 floor = new Vec3(.2, .6, 0);
        Vec3 up = new Vec3(0, 0, 1);
        assertEquals(1, at(twice, floor, up) / at(once, floor, up), 3 * ACCURACY);
    }

    /** The slit of a hundredth around the panel lets in a few hundredths of the light beside it. */
    @Test
    void ceilingBehindAPanel_isDark() {
        SceneBuilder builder = new SceneBuilder();
        Box large = new Box(Vec3.ZERO, new Vec3(5, 4, 2.7));
        for (int side = 0; side < 6; side++) {
            builder.polygon(WALL, large.inside(side));
        }
        builder.polygon(LAMP, new Vec3(1.8, 1.6, 2.69), new Vec3(1.8, 2.2, 2.69), new Vec3(3.2, 2.2, 2.69),
                new Vec3(3.2, 1.6, 2.69));
        Solution solution = solve(builder.scene("panel"));
        assertTrue(most(solution, 2, 3, 1.75, 2.05) < .1 * most(solution, .5, 1.4, 1.5, 2.5));
    }

    /** The largest irradiance at the vertices within a rectangle of the ceiling, W/m². */
    private static double most(Solution solution, double x0, double x1, double y0, double y1) {
        double most = -1;
        for (int v = 0; v < solution.positions().length / 3; v++) {
            double x = solution.positions()[3 * v];
            double y = solution.positions()[3 * v + 1];
            if (solution.positions()[3 * v + 2] > 2.695 && x >= x0 && x <= x1 && y >= y0 && y <= y1) {
                most = Math.max(most, solution.irradiance()[v]);
            }
        }
        assertTrue(most >= 0, "a vertex lies there");
        return most;
    }

    /** Slats that are inclined, so that their corners are rounded, and the front may lie behind the back. */
    @Test
    void lightDoesNotEscapeThroughABlind() {
        SceneBuilder builder = room(false);
        Surface slat = RoomScenes.grey("slat", 0, .7);
        for (int i = 0; i < 12; i++) {
            double z = .1 + i / 15.0;
            addDouble(builder, slat, new Vec3(.05, .15, z), new Vec3(.05, .85, z + .013), new Vec3(.09, .85, z + .041),
                    new Vec3(.09, .15, z + .028));
        }
        Solution solution = solve(builder.scene("blind"));
        double escaped = solution.ledger().escaped()[0] / solution.ledger().emitted()[0];
        assertTrue(escaped < .002, escaped + " of the light escaped");
    }
}
