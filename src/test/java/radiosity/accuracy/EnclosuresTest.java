package radiosity.accuracy;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.output.points.Points;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.testkit.Claim;
import radiosity.testkit.Figure;
import radiosity.testkit.NeedsReference;
import radiosity.testkit.Prism;
import radiosity.testkit.SharedData;
import radiosity.testkit.Solve;
import radiosity.testkit.Spread;

/**
 * Closed enclosures whose solution others computed ({@code truth/enclosures.json}). A furnace has one radiosity
 * everywhere; the continuous solution of a box is compared at its points. The mean B of a scene is what errors are
 * quoted in.
 */
@Tag("slow")
@NeedsReference("truth/enclosures.json")
public class EnclosuresTest {

    private static final String FILE = "enclosures.json";

    /** What is asked of the continuous solution. */
    static final double ASKED = 3e-3;

    public static Stream<Claim> furnaces() {
        return cases("furnace").map(c -> new Claim("enclosures: furnaces", c.get("id").asText(), () -> furnace(c)));
    }

    /** @param accuracy what the program is asked for */
    public static Stream<Claim> continuous(double accuracy) {
        return cases("box").map(c -> new Claim("enclosures: continuous", c.get("id").asText(),
                () -> continuous(c, accuracy)));
    }

    static Stream<Claim> continuous() {
        return continuous(4 * ASKED);
    }

    static Stream<JsonNode> cases(String kind) {
        return SharedData.cases(FILE).stream().filter(c -> c.get("kind").asText().equals(kind));
    }

    @ParameterizedTest
    @MethodSource("furnaces")
    void furnace_isExactOnAverage(Claim claim) {
        claim.check();
    }

    /** For less time than the command takes, which asks for what must be reached. */
    @ParameterizedTest
    @MethodSource("continuous")
    void box_isThatOfTheContinuousSolution(Claim claim) {
        claim.check();
    }

    private static List<Figure> furnace(JsonNode c) {
        Solution solution = Solve.byDefault().unsent(1e-5)
                .solution(SharedData.scene(c.get("id").asText(), c.get("surfaces")));
        List<Figure> figures = new ArrayList<>();
        for (int channel = 0; channel < 3; channel++) {
            double exact = c.get("exact_B").get(channel).asDouble();
            figures.add(Figure.relative("mean", 1e-4, exact, spread(solution, c, channel).mean()));
        }
        return figures;
    }

    /** The floor runs on under a block. */
    private static Spread spread(Solution solution, JsonNode c, int channel) {
        List<Prism> blocks = new ArrayList<>();
        for (JsonNode s : c.get("surfaces")) {
            if (s.get("name").asText().equals("block0.top")) {
                blocks.add(new Prism(0, Arrays.stream(SharedData.polygon(s.get("vertices")))
                        .flatMapToDouble(p -> DoubleStream.of(p.x(), p.z())).toArray()));
            }
        }
        return Spread.of(solution, p -> blocks.stream().noneMatch(block -> block.covers(p)),
                (e, k) -> solution.radiosityAt(e, k).channel(channel));
    }

    /** In the worst channel: root mean square over all points of a box, and the largest. */
    private static List<Figure> continuous(JsonNode c, double accuracy) {
        Solution solution = Solve.byDefault().accurate(accuracy)
                .solution(SharedData.scene(c.get("id").asText(), c.get("surfaces")));
        Points points = new Points(solution);
        JsonNode asked = c.get("continuous").get("points");
        double rmse = 0;
        double most = 0;
        for (int channel = 0; channel < 3; channel++) {
            double squares = 0;
            double mean = Spread.radiosity(solution, channel).mean();
            for (JsonNode p : asked) {
                Vec3 normal = FormFactorsTest.normal(SharedData.polygon(
                        c.get("surfaces").get(p.get("surface").asInt()).get("vertices")));
                Rgb found = points.at(SharedData.vector(p.get("x")), normal).radiosity();
                double error = Math.abs(found.channel(channel) - p.get("B").get(channel).asDouble()) / mean;
                squares += error * error;
                most = Math.max(most, error);
            }
            rmse = Math.max(rmse, Math.sqrt(squares / asked.size()));
        }
        return List.of(new Figure("rmse", ASKED, rmse), Figure.told("worst point", most));
    }
}
