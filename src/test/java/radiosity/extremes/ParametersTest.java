package radiosity.extremes;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Solution;
import radiosity.testkit.Claim;
import radiosity.testkit.Figure;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;
import radiosity.testkit.Spread;

/** Settings at their limits: the calculation ends, every number is finite, and the ledger closes. */
public class ParametersTest {

    private static final Scene ROOM = RoomScenes.withBlocks(RoomScenes.grey("wall", 1, 0.5));
    private static final double NEVER = Double.POSITIVE_INFINITY;

    private record Limit(RadiositySettings settings, StopRule stop) { }

    private static Map<String, Limit> limits() {
        RadiositySettings usual = RadiositySettings.defaults();
        StopRule some = new StopRule(60, 1e-3);
        Map<String, Limit> limits = new TreeMap<>();
        limits.put("-nr 1", new Limit(new RadiositySettings(1, 1, NEVER, Schedule.PAPER), some));
        limits.put("-pa larger than everything",
                new Limit(new RadiositySettings(1e30, 0, NEVER, Schedule.PREDICT), some));
        limits.put("-mt 0", new Limit(new RadiositySettings(1, 0, 0, Schedule.PAPER), new StopRule(4, 0)));
        limits.put("-se 0", new Limit(usual, new StopRule(200, 0)));
        limits.put("-se 1", new Limit(usual, new StopRule(200, 1)));
        limits.put("-it 0", new Limit(usual, new StopRule(0, 1e-3)));
        limits.put("--accuracy 50%", new Limit(usual.accurate(0.5), some));
        limits.put("--accuracy 0.01%", new Limit(usual.accurate(1e-4), some));
        return limits;
    }

    public static Stream<Claim> claims() {
        return limits().keySet().stream().map(name -> new Claim("settings at their limits", name, () -> figures(name)));
    }

    @ParameterizedTest
    @MethodSource("claims")
    void limit_givesNumbers(Claim claim) {
        claim.check();
    }

    /** That it is a number is seen to by {@link Solution}. */
    private static List<Figure> figures(String name) {
        Limit limit = limits().get(name);
        Solution solution = new Solve(limit.settings(), limit.stop(), 2).solution(ROOM);
        double low = Spread.radiosity(solution, 0).low();
        return List.of(new Figure("lowest below what is emitted", 1e-2, Math.max(0, 1 - low)),
                new Figure("ledger: flux that is unaccounted for", 1e-12, Math.abs(solution.ledger().imbalance(0))));
    }
}
