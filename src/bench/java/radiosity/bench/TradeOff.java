package radiosity.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.BiFunction;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.scene.Scene;
import radiosity.settings.FormFactors;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Solution;
import radiosity.testkit.Evaluate;
import radiosity.testkit.PointSet;
import radiosity.testkit.Score;
import radiosity.testkit.Solve;
import radiosity.testkit.TruthFile;

/**
 * Error against time, over scenes with path-traced truth, settings, form factors and schedules: a table on standard
 * output and a plot per scene.
 *
 * <p>{@code scripts/tradeoff [scene ...]}
 */
public final class TradeOff {

    /** Errors that are asked for, per cent. */
    private static final double[] ACCURACIES = {20, 10, 5, 2, 1, 0.5};
    private static final double[] PATCHES = {75, 150, 300};

    /** Ways to solve a scene, each with a knob. */
    private static final List<Way> WAYS = List.of(
            new Way("default", ACCURACIES, (scene, asked) -> RadiositySettings.defaults().accurate(asked / 100)),
            paper(FormFactors.RAYCAST), paper(FormFactors.PLAIN), paper(FormFactors.HEMICUBE),
            paper(FormFactors.NUSSELT));

    private final Path truth;
    private final Path plots;

    private TradeOff(Path truth, Path plots) {
        this.truth = truth;
        this.plots = plots;
    }

    private record Way(String name, double[] knobs, BiFunction<Scene, Double, RadiositySettings> settings) {
    }

    private static Way paper(FormFactors factors) {
        return new Way("paper, " + factors.name().toLowerCase(Locale.ROOT), PATCHES,
                (scene, n) -> new RadiositySettings(scene.area() / n, 0, Double.POSITIVE_INFINITY, Schedule.PAPER)
                        .factors(factors));
    }

    /** @param arguments folder of the truth, folder for the plots, scenes */
    public static void main(String[] arguments) throws IOException {
        Locale.setDefault(Locale.ROOT);
        TradeOff all = new TradeOff(Path.of(arguments[0]), Path.of(arguments[1]));
        System.out.println("| scene | way | knob | elements | CPU s | rmse | near | bias |");
        System.out.println("|---|---|---|---|---|---|---|---|");
        for (String scene : List.of(arguments).subList(2, arguments.length)) {
            all.compare(scene);
        }
    }

    private void compare(String name) throws IOException {
        Scene scene = LightWaveReader.read(truth.resolve(Path.of("lightwave", name + ".lws")),
                ReadOptions.defaults(), System.err::println);
        TruthFile points = TruthFile.read(truth.resolve(Path.of("truth", name + ".csv")));
        Plot plot = new Plot(name, "CPU seconds", "rmse / mean, per cent");
        measure(scene, WAYS.get(0), WAYS.get(0).knobs()[0], points);
        for (Way way : WAYS) {
            for (double knob : way.knobs()) {
                Measured m = measure(scene, way, knob, points);
                System.out.printf("| %s | %s | %.1f | %d | %.2f | %.2f %% | %.2f %% | %.2f %% |%n", name, way.name(),
                        knob,
                        m.elements(), m.seconds(), 100 * m.all().rmse(), 100 * m.near().rmse(), 100 * m.all().bias());
                plot.point(way.name(), m.seconds(), 100 * m.all().rmse());
            }
        }
        Files.createDirectories(plots);
        Files.writeString(plots.resolve("tradeoff-" + name + ".svg"), plot.svg());
    }

    private record Measured(int elements, double seconds, Score all, Score near) {
    }

    private static Measured measure(Scene scene, Way way, double knob, TruthFile points) {
        Solve solve = new Solve(way.settings().apply(scene, knob),
                new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT), 1);
        double start = TruthTable.cpuSeconds();
        Solution solution = solve.solution(scene);
        double seconds = TruthTable.cpuSeconds() - start;
        double[] found = Evaluate.radiosity(solution, points.places());
        return new Measured(solution.elements(), seconds, Score.rgb(points, PointSet.REFLECTORS, found),
                Score.rgb(points, PointSet.NEAR, found));
    }
}
