package radiosity.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.scene.Scene;
import radiosity.settings.FormFactors;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Certificate;
import radiosity.solution.Solution;
import radiosity.testkit.Evaluate;
import radiosity.testkit.PointSet;
import radiosity.testkit.Score;
import radiosity.testkit.Solve;
import radiosity.testkit.TruthFile;

/**
 * Prints how far the scenes with path-traced truth are from it and what that cost.
 *
 * <p>{@code scripts/accuracy [--patch-area A | --patches N] [--rays N] [--meshing D] [--tolerance T]
 * [--mesh-error M] [--accuracy PERCENT] [--schedule S] [--form-factors F] [--unsent P] [--threads N] [--repeat N]
 * [--certificate] [scene ...]}
 */
public final class TruthTable {

    public static final List<String> SCENES = List.of("cornell_empty", "cornell_blocks", "many_occluders", "two_room",
            "thin_wall", "touching", "high_albedo", "corridor30", "bright_ratio");

    private final Path truth;
    private RadiositySettings settings = RadiositySettings.defaults();
    private double unsent = StopRule.DEFAULT_UNSENT;
    private int patches;
    private int threads = 1;
    private int repeat = 1;
    private boolean certify;
    private final List<String> scenes = new ArrayList<>();

    private TruthTable(Path truth) {
        this.truth = truth;
    }

    /** @param arguments the folder of the truth, then options and scenes */
    public static void main(String[] arguments) throws IOException {
        Locale.setDefault(Locale.ROOT);
        TruthTable table = new TruthTable(Path.of(arguments[0]));
        try {
            table.read(arguments);
        } catch (IllegalArgumentException e) {
            System.err.println("accuracy: expected options as in --help, got " + e.getMessage());
            System.exit(2);
        }
        table.print();
    }

    private void read(String[] arguments) {
        for (int i = 1; i < arguments.length; i++) {
            if (arguments[i].equals("--certificate")) {
                certify = true;
            } else if (arguments[i].startsWith("--")) {
                if (i + 1 == arguments.length) {
                    throw new IllegalArgumentException(arguments[i] + " without a value");
                }
                option(arguments[i], arguments[++i]);
            } else {
                scenes.add(arguments[i]);
            }
        }
        if (scenes.isEmpty()) {
            scenes.addAll(SCENES);
        }
    }

    private void option(String name, String value) {
        RadiositySettings s = settings;
        double number = name.equals("--schedule") || name.equals("--form-factors") ? 0 : Double.parseDouble(value);
        switch (name) {
            case "--patch-area" -> set(number, s.rays(), s.meshing(), s.schedule(), s.tolerance(), s.meshError());
            case "--rays" -> set(s.patchArea(), (int) number, s.meshing(), s.schedule(), s.tolerance(), s.meshError());
            case "--meshing" -> set(s.patchArea(), s.rays(), number, s.schedule(), s.tolerance(), s.meshError());
            case "--tolerance" -> set(s.patchArea(), s.rays(), s.meshing(), s.schedule(), number, s.meshError());
            case "--mesh-error" -> set(s.patchArea(), s.rays(), s.meshing(), s.schedule(), s.tolerance(), number);
            case "--schedule" -> set(s.patchArea(), s.rays(), s.meshing(),
                    Schedule.valueOf(value.toUpperCase(Locale.ROOT)), s.tolerance(), s.meshError());
            case "--form-factors" -> settings = s.factors(FormFactors.valueOf(value.toUpperCase(Locale.ROOT)));
            case "--accuracy" -> settings = s.accurate(number / 100);
            case "--patches" -> patches = (int) number;
            case "--unsent" -> unsent = number;
            case "--threads" -> threads = (int) number;
            case "--repeat" -> repeat = (int) number;
            default -> throw new IllegalArgumentException(name);
        }
    }

    private void set(double area, int rays, double meshing, Schedule schedule, double tolerance, double meshError) {
        settings = new RadiositySettings(area, rays, meshing, schedule, tolerance, meshError)
                .factors(settings.factors());
    }

    private void print() throws IOException {
        System.out.printf("%-15s %8s %8s %8s %8s %8s %8s %7s %9s %7s", "scene", "rmse", "bias", "near", "dark",
                "max", "noise", "CPU s", "elements", "shots");
        System.out.println(certify ? " expected     bias sampling  meshing recipr.   factors     most" : "");
        for (String scene : scenes) {
            TruthFile points = TruthFile.read(truth.resolve(Path.of("truth", scene + ".csv")));
            Scene read = LightWaveReader.read(truth.resolve(Path.of("lightwave", scene + ".lws")),
                    ReadOptions.defaults(), System.err::println);
            for (int i = 0; i < repeat; i++) {
                line(scene, read, points);
            }
        }
    }

    private void line(String name, Scene scene, TruthFile truthFile) {
        Solve solve = new Solve(settings, new StopRule(Integer.MAX_VALUE, unsent), threads);
        if (patches > 0) {
            solve = solve.patches(scene, patches);
        }
        double start = cpuSeconds();
        Solution solution = solve.solution(scene);
        double seconds = cpuSeconds() - start;
        Certificate certificate = certify ? solve.certified(scene, true).certificate() : null;
        double[] found = Evaluate.radiosity(solution, truthFile.places());
        Score all = Score.rgb(truthFile, PointSet.REFLECTORS, found);
        Score near = Score.rgb(truthFile, PointSet.NEAR, found);
        Score dark = Score.rgb(truthFile, PointSet.DARK, found);
        System.out.printf("%-15s %s %s %s %s %s %s %7.2f %9d %7d", name, percent(all.rmse()), percent(all.bias()),
                percent(near.rmse()), percent(dark.rmse()), percent(all.max()), percent(all.noise()), seconds,
                solution.elements(), solution.shots());
        System.out.println(certificate == null ? "" : " " + percent(certificate.expected()) + " "
                + percent(certificate.bias()) + " " + percent(certificate.sampling()) + " "
                + percent(certificate.meshing()) + " " + percent(certificate.reciprocity())
                + String.format(" %8.4f %8.4f", certificate.factors(), certificate.mostFactors()));
    }

    private static String percent(double part) {
        return Double.isNaN(part) ? "       -" : String.format("%7.3f%%", 100 * part);
    }

    /** User and system time of all threads of this process so far. */
    static double cpuSeconds() {
        var bean = (com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        return bean.getProcessCpuTime() * 1e-9;
    }
}
