package radiosity.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.testkit.Evaluate;
import radiosity.testkit.PointSet;
import radiosity.testkit.Score;
import radiosity.testkit.Solve;
import radiosity.testkit.TruthFile;

/**
 * Time and memory: growth, threads, adaptive meshing, and what is saved where a scene does not need everything.
 *
 * <p>{@code scripts/performance growth|threads|adaptive|savings}
 */
public final class Performance {

    private static final Path CORNELL = Path.of("scenes", "cornell-box.lws");
    private static final StopRule STOP = new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT);
    /** No element is subdivided for its light. */
    private static final double UNIFORM = 1e9;
    /** Patches that are asked for; there are up to four times as many. */
    private static final int[] GROWTH = {10_000, 100_000, 500_000};
    private static final int[] MESHES = {4_000, 16_000, 64_000, 256_000};
    private static final double[] FINENESS = {8, 4, 2, 1};
    private static final double MESH_ERROR = 4e-4;
    private static final int WARM = 3;

    private Performance() {
    }

    /** What a solve took: elements, CPU-seconds, wall seconds, bytes of heap that it holds at the end. */
    record Cost(int elements, double cpu, double wall, double bytes) {
    }

    /** @param arguments what to measure, and the folder of the truth where that needs it */
    public static void main(String[] arguments) throws IOException {
        Locale.setDefault(Locale.ROOT);
        switch (arguments[0]) {
            case "growth" -> growth();
            case "threads" -> threads();
            case "adaptive" -> adaptive(Path.of(arguments[1]));
            case "savings" -> Savings.print(read(CORNELL));
            default -> throw new IllegalArgumentException(
                    "performance: expected growth, threads, adaptive or savings, got " + arguments[0]);
        }
    }

    private static Scene read(Path file) throws IOException {
        return LightWaveReader.read(file, ReadOptions.defaults(), System.err::println);
    }

    static RadiositySettings uniform(Scene scene, int patches) {
        return settings(scene.area() / patches, UNIFORM);
    }

    private static RadiositySettings settings(double patchArea, double meshError) {
        return new RadiositySettings(patchArea, 0, Double.POSITIVE_INFINITY, Schedule.PREDICT, 0, meshError);
    }

    private static Cost cost(Scene scene, RadiositySettings settings, int threads) throws IOException {
        long before = held();
        long start = System.nanoTime();
        double cpu = TruthTable.cpuSeconds();
        try (LocalWorld world = new LocalWorld(scene, settings, threads)) {
            ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, STOP);
            rounds.run(progress -> true);
            cpu = TruthTable.cpuSeconds() - cpu;
            double wall = (System.nanoTime() - start) * 1e-9;
            long bytes = held() - before;
            return new Cost(rounds.solution().elements(), cpu, wall, bytes);
        }
    }

    /** Bytes of heap in use once what nobody needs is gone. */
    private static long held() {
        System.gc();
        System.gc();
        return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
    }

    static Cost warm(Scene scene, RadiositySettings settings, int threads) throws IOException {
        Cost last = cost(scene, settings, threads);
        for (int i = 0; i < WARM; i++) {
            Cost next = cost(scene, settings, threads);
            last = next.cpu() < last.cpu() ? next : last;
        }
        return last;
    }

    private static void growth() throws IOException {
        Scene scene = read(CORNELL);
        warm(scene, uniform(scene, GROWTH[0]), 1);
        System.out.println("| elements | CPU s | CPU us per element | bytes per element |\n|---|---|---|---|");
        for (int n : GROWTH) {
            Cost c = cost(scene, uniform(scene, n), 1);
            System.out.printf("| %d | %.2f | %.1f | %.0f |%n", c.elements(), c.cpu(), 1e6 * c.cpu() / c.elements(),
                    c.bytes() / c.elements());
        }
    }

    /** The threads take turns. */
    private static void threads() throws IOException {
        Scene scene = read(CORNELL);
        RadiositySettings settings = settings(0, MESH_ERROR / 4);
        System.out.println("| threads | wall s | CPU s |\n|---|---|---|");
        cost(scene, settings, 2);
        for (int turn = 0; turn < WARM; turn++) {
            for (int threads = 1; threads <= 2; threads++) {
                Cost c = cost(scene, settings, threads);
                System.out.printf("| %d | %.2f | %.2f |%n", threads, c.wall(), c.cpu());
            }
        }
    }

    private static void adaptive(Path truth) throws IOException {
        String name = "cornell_blocks";
        Scene scene = read(truth.resolve(Path.of("lightwave", name + ".lws")));
        TruthFile points = TruthFile.read(truth.resolve(Path.of("truth", name + ".csv")));
        System.out.println("| mesh | elements | rmse |\n|---|---|---|");
        for (double fineness : FINENESS) {
            score("adaptive", scene, settings(0, MESH_ERROR * fineness), points);
        }
        for (int n : MESHES) {
            score("uniform", scene, uniform(scene, n), points);
        }
    }

    private static void score(String mesh, Scene scene, RadiositySettings settings, TruthFile points) {
        var solution = new Solve(settings, STOP, 1).solution(scene);
        Score score = Score.rgb(points, PointSet.REFLECTORS, Evaluate.radiosity(solution, points.places()));
        System.out.printf("| %s | %d | %.2f %% |%n", mesh, solution.elements(), 100 * score.rmse());
    }
}
