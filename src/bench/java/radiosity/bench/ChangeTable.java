package radiosity.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import radiosity.Radiosity;
import radiosity.edit.LightDifference;
import radiosity.output.gltf.SceneFile;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.StopRule;
import radiosity.solution.Certificate;
import radiosity.solution.EnergyLedger;
import radiosity.solution.Progress;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.testkit.ColouredRoom;
import radiosity.testkit.Edits;
import radiosity.testkit.RandomEdits;

/**
 * Prints what changes of the study cost and how exact they are, see {@code scripts/change --help}.
 *
 * <p>CPU-seconds of all threads of the process, from the scene to the solution, without the last look of the certificate,
 * which is listed apart. What is changed is changed twice, and the second time counts, as the first has the program
 * compiled, too.
 */
public final class ChangeTable {

    private static final int POINTS = 4000;
    private static final int EDITS = 50;
    private static final int FRAMES = 20;
    /** Of which so many are rendered anew. */
    private static final int ANEW = 4;
    /** A certificate that takes less than this part of what a run does after its last round is that of the run. */
    private static final double KNOWN = 0.1;

    private final RadiositySettings settings;
    private final double truth;
    private final int threads;

    private ChangeTable(double error, double truth, int threads) {
        settings = RadiositySettings.defaults().accurate(error);
        this.truth = truth;
        this.threads = threads;
    }

    /**
     * What a calculation came to.
     *
     * @param seconds    of the CPU, without those of the last look of the certificate
     * @param certifying those
     * @param anew       why it was rendered anew, or nothing
     */
    private record Run(Solution solution, Certificate certificate, double seconds, double certifying, String anew) { }

    /** @param arguments scene, error in per cent, error of the reference in per cent (0: none), threads, rows */
    public static void main(String[] arguments) throws IOException {
        Locale.setDefault(Locale.ROOT);
        Scene scene = Radiosity.read(Path.of(arguments[0]), line -> { });
        ChangeTable table = new ChangeTable(Double.parseDouble(arguments[1]) / 100,
                Double.parseDouble(arguments[2]) / 100, Integer.parseInt(arguments[3]));
        List<String> rows = List.of(arguments).subList(4, arguments.length);
        if (rows.contains("edits")) {
            table.edits(EDITS);
        } else if (rows.contains("frames")) {
            table.frames(scene);
        } else if (rows.contains("room")) {
            table.print(ofRoom(ColouredRoom.SCENE), rows.subList(1, rows.size()));
        } else {
            table.print(edits(scene), rows);
        }
    }

    private static Map<String, Scene> edits(Scene scene) {
        Map<String, Scene> edits = new LinkedHashMap<>();
        edits.put("nothing", scene);
        edits.put("repaint", Edits.repainted(scene, Edits.object(scene, "pillow-teal"), new Rgb(.6, .15, .1)));
        edits.put("wall", Edits.with(scene, "accent wall",
                s -> new Surface(s.name(), s.exitance(), new Rgb(.45, .55, .6), s.twoSided())));
        edits.put("chair", Edits.moved(scene, Edits.object(scene, "chair"), new Vec3(0, 0, -1)));
        edits.put("removed", Edits.without(scene, Edits.object(scene, "plant")));
        edits.put("lamp", Edits.moved(scene, Edits.object(scene, "floor-lamp"), new Vec3(-.1, 0, 1)));
        return edits;
    }

    /** The chair moves by a metre in so many frames, each from the one before. */
    private void frames(Scene first) throws IOException {
        run(ColouredRoom.SCENE, settings, Optional.empty());
        double seconds = 0;
        double anew = 0;
        Run frame = null;
        for (int n = 0; n < FRAMES; n++) {
            Scene scene = Edits.moved(first, Edits.object(first, "chair"), new Vec3(0, 0, -1.0 * n / (FRAMES - 1)));
            frame = run(scene, settings, Optional.ofNullable(frame).map(before -> before.solution.state()));
            double whole = frame.seconds + frame.certifying;
            seconds += whole;
            System.out.printf("frame %d: %.2f CPU s, expected %.2f %%%s%n", n, whole,
                    100 * frame.certificate.expected(), frame.anew);
            if (n % (FRAMES / ANEW) == FRAMES / ANEW - 1) {
                Run other = run(scene, settings, Optional.empty());
                double[] places = LightDifference.places(scene, POINTS);
                anew += (other.seconds + other.certifying) / ANEW;
                System.out.printf("  anew: %.2f CPU s, expected %.2f %%, difference %.2f %%%n",
                        other.seconds + other.certifying, 100 * other.certificate.expected(),
                        100 * LightDifference.of(LightDifference.radiosity(other.solution, places),
                                LightDifference.radiosity(frame.solution, places)));
            }
        }
        System.out.printf("%d frames: %.2f CPU s with certificates, %.1f %% of as many renders by the mean of %d%n",
                FRAMES, seconds, 100 * seconds / (FRAMES * anew), ANEW);
    }

    /** Edits of the coloured room one after another, each from the one before. */
    private void edits(int count) throws IOException {
        Scene scene = RandomEdits.room(0);
        Run now = run(scene, settings, Optional.empty());
        double seconds = 0;
        int anews = 0;
        double worst = 0;
        double gained = 0;
        for (int n = 1; n <= count; n++) {
            scene = RandomEdits.room(n);
            now = run(scene, settings, Optional.of(now.solution.state()));
            seconds += now.seconds;
            anews += now.anew.isEmpty() ? 0 : 1;
            if (Boolean.getBoolean("edits")) {
                System.out.printf("  %d: %.2f CPU s, %d elements, %.2f %%, shots %d%s%n", n, now.seconds,
                        now.solution.elements(), 100 * now.certificate.expected(), now.solution.shots(), now.anew);
            }
            EnergyLedger ledger = now.solution.ledger();
            for (int c = 0; c < ledger.emitted().length; c++) {
                worst = Math.max(worst, Math.abs(ledger.imbalance(c)));
                gained = Math.max(gained, -ledger.deficit(c) / ledger.emitted()[c]);
            }
        }
        Run anew = run(scene, settings, Optional.empty());
        double[] places = LightDifference.places(scene, POINTS);
        double[] reference = LightDifference.radiosity(run(scene, RadiositySettings.defaults().accurate(truth),
                Optional.empty()).solution, places);
        double error = LightDifference.of(reference, LightDifference.radiosity(now.solution, places));
        double ofAnew = LightDifference.of(reference, LightDifference.radiosity(anew.solution, places));
        System.out.printf("%d edits, %d of them rendered anew: %.2f CPU s, once anew %.2f; error %.2f %%, anew %.2f %%,"
                + " ratio %.2f; certificate %.2f %%; ledger off by %.1e at most; gained %.4f %% at most; %d elements,"
                + " anew %d%n", count, anews, seconds, anew.seconds, 100 * error, 100 * ofAnew, error / ofAnew,
                100 * now.certificate.expected(), worst, 100 * gained, now.solution.elements(),
                anew.solution.elements());
    }

    /** Those of the coloured room. */
    private static Map<String, Scene> ofRoom(Scene room) {
        Map<String, Scene> edits = new LinkedHashMap<>();
        edits.put("nothing", room);
        edits.put("repaint", Edits.repainted(room, Edits.surface(room, "block"), new Rgb(.7, .1, .1)));
        edits.put("wall", Edits.repainted(room, Edits.surface(room, "wall 4"), new Rgb(.2, .3, .6)));
        edits.put("moved", Edits.moved(room, Edits.surface(room, "block"), new Vec3(-.05, 0, .25)));
        edits.put("removed", Edits.without(room, Edits.surface(room, "block")));
        edits.put("lamp dimmed", Edits.with(room, "lamp",
                s -> new Surface(s.name(), new Rgb(.8, .7, .6), s.reflectance(), s.twoSided())));
        return edits;
    }

    private void print(Map<String, Scene> edits, List<String> rows) throws IOException {
        run(ColouredRoom.SCENE, settings, Optional.empty());
        Run old = run(edits.get("nothing"), settings, Optional.empty());
        System.out.printf("before: %d elements, %.2f CPU s, expected %.2f %%%n", old.solution.elements(), old.seconds,
                100 * old.certificate.expected());
        System.out.println("| change | CPU s anew | CPU s changed | ratio | certificate, CPU s | elements anew"
                + " | changed | expected anew | changed | difference | true error anew | changed | certificate over"
                + " true |");
        System.out.println("|---|---|---|---|---|---|---|---|---|---|---|---|---|");
        for (Map.Entry<String, Scene> edit : edits.entrySet()) {
            if (rows.isEmpty() || rows.contains(edit.getKey())) {
                line(edit.getKey(), edit.getValue(), old);
            }
        }
    }

    private void line(String name, Scene scene, Run before) throws IOException {
        run(scene, settings, Optional.of(before.solution.state()));
        Run changed = run(scene, settings, Optional.of(before.solution.state()));
        Run anew = name.equals("nothing") ? before : run(scene, settings, Optional.empty());
        double[] places = LightDifference.places(scene, POINTS);
        double[] a = LightDifference.radiosity(anew.solution, places);
        double[] b = LightDifference.radiosity(changed.solution, places);
        double[] c = truth > 0 ? LightDifference.radiosity(run(scene, RadiositySettings.defaults().accurate(truth),
                Optional.empty()).solution, places) : null;
        double error = truth > 0 ? LightDifference.of(c, b) : Double.NaN;
        keep(name, changed);
        keep(name + "-anew", anew);
        System.out.printf("| %s | %.2f | %.2f | %.1f %% | %.2f | %d | %d | %.2f %% | %.2f %% | %.2f %% | %.2f %%"
                + " | %.2f %% | %.2f |%n", name + changed.anew, anew.seconds, changed.seconds,
                100 * changed.seconds / anew.seconds, changed.certifying, anew.solution.elements(),
                changed.solution.elements(), 100 * anew.certificate.expected(), 100 * changed.certificate.expected(),
                100 * LightDifference.of(a, b),
                truth > 0 ? 100 * LightDifference.of(c, a) : Double.NaN, 100 * error, changed.certificate.expected() / error);
    }

    /** Writes a scene file to the directory of the system property {@code keep}, where it is set. */
    private static void keep(String name, Run run) throws IOException {
        String directory = System.getProperty("keep", "");
        if (!directory.isEmpty()) {
            SceneFile.write(Path.of(directory, name + ".scene"), run.solution, Map.of("certificate", run.certificate),
                    run.solution.scene().camera(), ToneMapping.automatic(run.solution));
        }
    }

    private Run run(Scene scene, RadiositySettings how, Optional<SavedState> from) throws IOException {
        double begin = TruthTable.cpuSeconds();
        try (LocalWorld world = new LocalWorld(scene, how, threads)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world,
                    new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT));
            String anew = from.isEmpty() ? "" : radiosity.change(from.get()).map(why -> " (anew: " + why + ")")
                    .orElse("");
            double[] last = {begin};
            Progress[] before = {null};
            radiosity.run(progress -> {
                if (!progress.equals(before[0])) {
                    last[0] = TruthTable.cpuSeconds();
                    before[0] = progress;
                }
                if (Boolean.getBoolean("rounds")) {
                    System.out.printf("  %s %.2f CPU s%n", progress, last[0] - begin);
                }
                return true;
            });
            double ran = TruthTable.cpuSeconds();
            Solution solution = radiosity.solution();
            double done = TruthTable.cpuSeconds();
            Certificate certificate = radiosity.certificate(threads).orElseThrow();
            double certifying = TruthTable.cpuSeconds() - done;
            double ofRun = ran - last[0];
            boolean isKnown = certifying < KNOWN * ofRun;
            return new Run(solution, certificate, done - begin - (isKnown ? ofRun : 0), isKnown ? ofRun : certifying,
                    anew);
        }
    }
}
