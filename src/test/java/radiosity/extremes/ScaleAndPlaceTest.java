package radiosity.extremes;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.accuracy.Moves;
import radiosity.accuracy.Rooms;
import radiosity.accuracy.Solve;
import radiosity.accuracy.Spread;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.world.Solution;

/**
 * Radiosity does not depend on the unit of length, on where the origin is, or on how the room is turned. A scene is
 * brought to size 1 around the origin in double, so only rounding of its coordinates is left: 1e-10 of its size where it
 * is moved by a million times that.
 */
class ScaleAndPlaceTest {

    private static final Surface WALL = new Surface("wall", new Rgb(1, 0.1, 0), new Rgb(0.7, 0.5, 0.3), false);
    private static final Scene ROOM = Rooms.withBlocks(WALL);
    private static final double[] EXPECTED = irradiance(ROOM);

    private static double[] irradiance(Scene scene) {
        return Solve.byDefault().patches(scene, 100).solution(scene).irradiance();
    }

    private static void same(Scene other) {
        double[] found = irradiance(other);
        assertEquals(EXPECTED.length, found.length, "mesh");
        for (int i = 0; i < found.length; i++) {
            assertEquals(EXPECTED[i], found[i], 1e-4 * EXPECTED[i]);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 1e-3, 1e3, 1e6})
    void scaledScene_hasTheSameRadiosities(double factor) {
        same(Moves.scaled(ROOM, factor));
    }

    @Test
    void movedScene_hasTheSameRadiosities() {
        same(Moves.moved(ROOM, new Vec3(1 << 22, -(1 << 23), 1 << 22)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 2})
    void turnedScene_hasTheSameMean(double angle) {
        assertEquals(mean(ROOM), mean(Moves.turned(ROOM, angle)), 1e-3 * mean(ROOM));
    }

    /** Sample points are keyed by the numbers of triangles, so others are drawn. */
    @Test
    void reorderedScene_hasTheSameMeanButForSampling() {
        assertEquals(mean(ROOM), mean(Moves.reordered(ROOM, 7)), 5e-3 * mean(ROOM));
    }

    private static double mean(Scene scene) {
        Solution solution = Solve.byDefault().patches(scene, 400).solution(scene);
        return Spread.radiosity(solution, 0).mean();
    }
}
