package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Disabled;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.output.Points;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.world.Solution;

/**
 * Closed enclosures whose solution others computed ({@code truth/enclosures.json}). A furnace has one radiosity
 * everywhere; the continuous solution of a box is compared at its points and, with less room for error, in the mean of
 * each face. The mean B of a scene is what errors are quoted in.
 */
class EnclosuresTest {

    private static final String FILE = "enclosures.json";

    private static final Set<String> WHITE = Set.of("furnace-block-0.9");

    static Stream<String> furnaces() {
        return ids("furnace").filter(id -> !WHITE.contains(id));
    }

    static Stream<String> whiteFurnaces() {
        return ids("furnace").filter(WHITE::contains);
    }

    static Stream<String> boxes() {
        return ids("box");
    }

    private static Stream<String> ids(String kind) {
        return Shared.cases(FILE).stream().filter(c -> c.get("kind").asText().equals(kind)).map(c -> c.get("id").asText());
    }

    @ParameterizedTest
    @MethodSource("furnaces")
    void furnace_isExactOnAverage(String id) {
        JsonNode c = Shared.find(FILE, id);
        Solution solution = Solve.byDefault().unsent(1e-5).solution(Shared.scene(id, c.get("surfaces")));
        for (int channel = 0; channel < 3; channel++) {
            double exact = c.get("exact_B").get(channel).asDouble();
            assertEquals(exact, spread(solution, c, channel).mean(), 1e-3 * exact);
        }
    }

    @ParameterizedTest
    @MethodSource("whiteFurnaces")
    void whiteFurnace_isExactOnAverage(String id) {
        furnace_isExactOnAverage(id);
    }

    /** The floor runs on under a block. */
    private static Spread spread(Solution solution, JsonNode c, int channel) {
        List<Prism> blocks = new ArrayList<>();
        for (JsonNode s : c.get("surfaces")) {
            if (s.get("name").asText().equals("block0.top")) {
                blocks.add(new Prism(0, Arrays.stream(Shared.polygon(s.get("vertices")))
                        .flatMapToDouble(p -> DoubleStream.of(p.x(), p.z())).toArray()));
            }
        }
        return Spread.of(solution, p -> blocks.stream().noneMatch(block -> block.covers(p)),
                (e, k) -> solution.radiosityAt(e, k).channel(channel));
    }

    @ParameterizedTest
    @MethodSource("boxes")
    void box_isThatOfTheContinuousSolution(String id) {
        JsonNode c = Shared.find(FILE, id);
        Scene room = Shared.scene(id, c.get("surfaces"));
        Solution solution = Solve.byDefault().solution(room);
        Points points = new Points(solution);
        double[] mean = {0, 0, 0};
        for (int channel = 0; channel < 3; channel++) {
            mean[channel] = Spread.radiosity(solution, channel).mean();
        }
        JsonNode continuous = c.get("continuous");
        double[] squares = {0, 0, 0};
        for (JsonNode p : continuous.get("points")) {
            Vec3 normal = FormFactorsTest.normal(Shared.polygon(
                    c.get("surfaces").get(p.get("surface").asInt()).get("vertices")));
            Rgb found = points.at(Shared.vector(p.get("x")), normal).radiosity();
            Rgb exact = Shared.rgb(p.get("B"));
            for (int channel = 0; channel < 3; channel++) {
                squares[channel] += Math.pow((found.channel(channel) - exact.channel(channel)) / mean[channel], 2);
            }
        }
        for (int channel = 0; channel < 3; channel++) {
            double rmse = Math.sqrt(squares[channel] / continuous.get("points").size());
            assertTrue(rmse <= 0.02, "rmse " + rmse + " in channel " + channel);
        }
    }
}
