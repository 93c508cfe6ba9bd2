package radiosity.extremes;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.testkit.Claim;
import radiosity.testkit.Figure;
import radiosity.testkit.Moves;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;
import radiosity.testkit.Spread;

/**
 * Radiosity does not depend on the unit of length, on where the origin is, or on how the room is turned. A scene is
 * brought to size 1 around the origin in double, so only rounding of its coordinates is left: 1e-10 of its size where
 * it is moved by a million times that.
 */
@Tag("slow")
public class ScaleAndPlaceTest {

    private static final Surface WALL = new Surface("wall", new Rgb(1, 0.1, 0), new Rgb(0.7, 0.5, 0.3), false);
    private static final Scene ROOM = RoomScenes.withBlocks(WALL);
    private static final double[] EXPECTED = irradiance(ROOM);

    private static double[] irradiance(Scene scene) {
        return Solve.byDefault().patches(scene, 100).solution(scene).irradiance();
    }

    public static Stream<Claim> claims() {
        Stream<Claim> scaled = DoubleStream.of(1e-6, 1e-3, 1e3, 1e6).mapToObj(factor -> Claim.of("scale and place",
                "times " + factor, () -> worst(Moves.scaled(ROOM, factor))));
        return Stream.concat(scaled, Stream.of(Claim.of("scale and place", "moved by a million times its size",
                () -> worst(Moves.moved(ROOM, new Vec3(1 << 22, -(1 << 23), 1 << 22))))));
    }

    private static Figure worst(Scene other) {
        double[] found = irradiance(other);
        assertEquals(EXPECTED.length, found.length, "mesh");
        double worst = 0;
        for (int i = 0; i < found.length; i++) {
            double error = Math.abs(found[i] - EXPECTED[i]);
            worst = Math.max(worst, error == 0 ? 0 : error / EXPECTED[i]);
        }
        return new Figure("every vertex", 1e-4, worst);
    }

    @ParameterizedTest
    @MethodSource("claims")
    void sceneElsewhere_hasTheSameRadiosities(Claim claim) {
        claim.check();
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
