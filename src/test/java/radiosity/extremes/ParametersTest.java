package radiosity.extremes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.accuracy.Rooms;
import radiosity.scene.Scene;
import radiosity.world.LocalWorld;
import radiosity.world.ProgressiveRadiosity;
import radiosity.world.RadiositySettings;
import radiosity.world.Schedule;
import radiosity.world.Solution;
import radiosity.world.StopRule;
import radiosity.world.World;

/** Settings at their limits: the calculation ends, every number is finite, and the ledger closes. */
class ParametersTest {

    private static final Scene ROOM = Rooms.withBlocks(Rooms.grey("wall", 1, 0.5));
    private static final double NEVER = Double.POSITIVE_INFINITY;

    private record Limit(RadiositySettings settings, StopRule stop) { }

    private static Map<String, Limit> limits() {
        RadiositySettings usual = RadiositySettings.defaults();
        StopRule some = new StopRule(60, 1e-3);
        Map<String, Limit> limits = new TreeMap<>();
        limits.put("-nr 1", new Limit(new RadiositySettings(1, 1, NEVER, Schedule.PAPER), some));
        limits.put("-pa larger than everything", new Limit(new RadiositySettings(1e30, 0, NEVER, Schedule.PREDICT), some));
        limits.put("-mt 0", new Limit(new RadiositySettings(1, 0, 0, Schedule.PAPER), new StopRule(4, 0)));
        limits.put("-se 0", new Limit(usual, new StopRule(200, 0)));
        limits.put("-se 1", new Limit(usual, new StopRule(200, 1)));
        limits.put("-it 0", new Limit(usual, new StopRule(0, 1e-3)));
        limits.put("--accuracy 50%", new Limit(usual.accurate(0.5), some));
        limits.put("--accuracy 0.01%", new Limit(usual.accurate(1e-4), some));
        return limits;
    }

    static Iterable<String> names() {
        return limits().keySet();
    }

    @ParameterizedTest
    @MethodSource("names")
    void limit_givesNumbers(String name) throws IOException {
        Limit limit = limits().get(name);
        try (World world = new LocalWorld(ROOM, limit.settings(), 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, limit.stop());
            radiosity.run(progress -> true);
            Solution solution = radiosity.solution();
            for (int e = 0; e < solution.elements(); e++) {
                for (int k = 0; k < 3; k++) {
                    assertTrue(Double.isFinite(solution.radiosityAt(e, k).r()), "element " + e);
                }
            }
            assertEquals(0, radiosity.ledger().imbalance(0), 1e-12);
        }
    }
}
