package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.EnergyLedger;
import radiosity.testkit.ColouredRoom;
import radiosity.testkit.RoomScenes;

/** A calculation that is to leave nothing unshot ends where only rounding is left, on every schedule. */
@Tag("slow")
class RoundingTest {

    /** More than any schedule needs here. */
    private static final int MOST_CALLS = 20_000;

    private static final Scene WHITE = RoomScenes.watertight().values().iterator().next()
            .apply(RoomScenes.grey("wall", 1, .97));

    /** In the white room some 33 times as much is shot as is emitted, and rounding is as much more. */
    static Stream<Arguments> rooms() {
        return Stream.of(Schedule.values()).flatMap(schedule -> Stream.of(
                Arguments.of(schedule, "coloured", ColouredRoom.SCENE), Arguments.of(schedule, "white", WHITE)));
    }

    private static ProgressiveRadiosity radiosity(Schedule schedule, Scene scene, double unsent) {
        RadiositySettings settings = new RadiositySettings(scene.area() / 20, 1, Double.POSITIVE_INFINITY, schedule, 1,
                0.1);
        return new ProgressiveRadiosity(new LocalWorld(scene, settings, 1), new StopRule(Integer.MAX_VALUE, unsent));
    }

    @ParameterizedTest(name = "{0}, {1}")
    @MethodSource("rooms")
    void nothingToBeLeft_endsAtRounding(Schedule schedule, String name, Scene scene) throws IOException {
        ProgressiveRadiosity radiosity = radiosity(schedule, scene, 0);
        int[] calls = new int[1];
        radiosity.run(progress -> ++calls[0] < MOST_CALLS);
        double unsent = radiosity.progress().unsent();
        assertTrue(calls[0] < MOST_CALLS, "still going on: " + radiosity.progress());
        EnergyLedger ledger = radiosity.ledger();
        double all = Math.max(sum(ledger.emitted()), sum(ledger.shot())) / sum(ledger.emitted());
        assertTrue(unsent <= 1e-12 * all * (1 + 1e-9), "unsent: " + unsent);
        assertEquals(unsent > 0, radiosity.isOnlyRoundingLeft());
    }

    private static double sum(double[] channels) {
        return DoubleStream.of(channels).sum();
    }

    @Test
    void moreToBeLeft_isNotRounding() throws IOException {
        ProgressiveRadiosity radiosity = radiosity(Schedule.PAPER, ColouredRoom.SCENE, 1e-3);
        radiosity.run(progress -> true);
        assertFalse(radiosity.isOnlyRoundingLeft());
    }
}
