package radiosity.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import radiosity.Radiosity;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.Accuracy;
import radiosity.settings.RadiositySettings;
import radiosity.settings.StopRule;
import radiosity.solution.Certificate;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.testkit.Edits;
import radiosity.testkit.Evaluate;

/**
 * Prints what changes of the study cost and how exact they are, see {@code scripts/change --help}.
 *
 * <p>CPU-seconds of all threads of the process, from the scene to the solution, after the render before the change, which
 * warms up.
 */
public final class ChangeTable {

    private static final int POINTS = 4000;

    private final RadiositySettings settings;
    private final double truth;
    private final int threads;

    private ChangeTable(double error, double truth, int threads) {
        settings = RadiositySettings.defaults().accurate(error);
        this.truth = truth;
        this.threads = threads;
    }

    /** What a calculation came to. */
    private record Run(Solution solution, Certificate certificate, double seconds, double certifying, String anew) { }

    /** @param arguments scene, error in per cent, error of the reference in per cent (0: none), threads, rows */
    public static void main(String[] arguments) throws IOException {
        Locale.setDefault(Locale.ROOT);
        Scene scene = Radiosity.read(Path.of(arguments[0]), line -> { });
        ChangeTable table = new ChangeTable(Double.parseDouble(arguments[1]) / 100,
                Double.parseDouble(arguments[2]) / 100, Integer.parseInt(arguments[3]));
        table.print(scene, List.of(arguments).subList(4, arguments.length));
    }

    private static Map<String, Scene> edits(Scene scene) {
        Map<String, Scene> edits = new LinkedHashMap<>();
        edits.put("nothing", scene);
        edits.put("repaint", Edits.with(scene, surface(scene, "pillow-cream"),
                s -> new Surface(s.name(), s.exitance(), new Rgb(.5, .1, .1), s.twoSided())));
        edits.put("wall", Edits.with(scene, "wall",
                s -> new Surface(s.name(), s.exitance(), new Rgb(.45, .55, .6), s.twoSided())));
        edits.put("chair", Edits.moved(scene, Edits.object(scene, "chair"), new Vec3(0, 0, -1)));
        edits.put("removed", Edits.without(scene, Edits.object(scene, "plant")));
        edits.put("lamp", Edits.moved(scene, Edits.object(scene, "floor-lamp"), new Vec3(-.1, 0, 1)));
        return edits;
    }

    /** The first surface of an object. */
    private static String surface(Scene scene, String object) {
        for (int t = 0; t < scene.triangles(); t++) {
            if (Edits.object(scene, object).test(t)) {
                return scene.surface(t).name();
            }
        }
        throw new IllegalArgumentException("no object " + object);
    }

    private void print(Scene scene, List<String> rows) throws IOException {
        Run old = run(scene, settings, Optional.empty());
        System.out.printf("before: %d elements, %.2f CPU s, expected %.2f %%%n", old.solution.elements(), old.seconds,
                100 * old.certificate.expected());
        System.out.println("| change | CPU s anew | CPU s changed | ratio | certificate, CPU s | elements anew"
                + " | changed | expected anew | changed | difference | true error anew | changed | certificate over"
                + " true |");
        System.out.println("|---|---|---|---|---|---|---|---|---|---|---|---|---|");
        for (Map.Entry<String, Scene> edit : edits(scene).entrySet()) {
            if (rows.isEmpty() || rows.contains(edit.getKey())) {
                line(edit.getKey(), edit.getValue(), old.solution.state());
            }
        }
    }

    private void line(String name, Scene scene, SavedState before) throws IOException {
        Run changed = run(scene, settings, Optional.of(before));
        Run anew = run(scene, settings, Optional.empty());
        double[] places = Edits.places(scene, POINTS);
        double[] a = Evaluate.radiosity(anew.solution, places);
        double[] b = Evaluate.radiosity(changed.solution, places);
        double[] c = truth > 0 ? Evaluate.radiosity(run(scene, RadiositySettings.defaults().accurate(truth),
                Optional.empty()).solution, places) : null;
        double error = truth > 0 ? difference(scene, c, b, places) : Double.NaN;
        System.out.printf("| %s | %.2f | %.2f | %.1f %% | %.2f | %d | %d | %.2f %% | %.2f %% | %.2f %% | %.2f %%"
                + " | %.2f %% | %.2f |%n", name + changed.anew, anew.seconds, changed.seconds,
                100 * changed.seconds / anew.seconds, changed.certifying, anew.solution.elements(),
                changed.solution.elements(), 100 * anew.certificate.expected(), 100 * changed.certificate.expected(),
                100 * difference(scene, a, b, places), truth > 0 ? 100 * difference(scene, c, a, places) : Double.NaN,
                100 * error, changed.certificate.expected() / error);
    }

    private Run run(Scene scene, RadiositySettings how, Optional<SavedState> from) throws IOException {
        double begin = TruthTable.cpuSeconds();
        try (LocalWorld world = new LocalWorld(scene, how, threads)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world,
                    new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT));
            String anew = from.isEmpty() ? "" : radiosity.change(from.get()).map(why -> " (anew: " + why + ")")
                    .orElse("");
            radiosity.run(progress -> {
                if (Boolean.getBoolean("rounds")) {
                    System.out.printf("  %s %.2f CPU s%n", progress, TruthTable.cpuSeconds() - begin);
                }
                return true;
            });
            Solution solution = radiosity.solution();
            double done = TruthTable.cpuSeconds();
            Certificate certificate = radiosity.certificate(threads).orElseThrow();
            return new Run(solution, certificate, done - begin, TruthTable.cpuSeconds() - done, anew);
        }
    }

    /** As {@link Certificate#expected} has it: of what reflects, relative to the mean or to a third of what is there. */
    private static double difference(Scene scene, double[] expected, double[] got, double[] places) {
        double squares = 0;
        for (int c = 0; c < 3; c++) {
            int channel = c;
            double mean = Arrays.stream(indices(expected, got, channel)).mapToDouble(i -> expected[i]).average()
                    .orElse(Double.NaN);
            squares += Arrays.stream(indices(expected, got, channel))
                    .mapToDouble(i -> (expected[i] - got[i]) / Math.max(mean, expected[i] / Accuracy.BRIGHT))
                    .map(x -> x * x).average().orElse(Double.NaN) / 3;
        }
        return Math.sqrt(squares);
    }

    private static int[] indices(double[] expected, double[] got, int channel) {
        return java.util.stream.IntStream.range(0, expected.length).filter(i -> i % 3 == channel
                && !Double.isNaN(expected[i]) && !Double.isNaN(got[i])).toArray();
    }
}
