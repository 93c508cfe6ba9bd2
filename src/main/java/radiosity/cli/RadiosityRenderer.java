package radiosity.cli;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import radiosity.lightwave.LightWaveReader;
import radiosity.output.SceneInfo;
import radiosity.output.SurfaceMaps;
import radiosity.scene.Scene;
import radiosity.world.Certificate;
import radiosity.world.HostKey;
import radiosity.world.LocalWorld;
import radiosity.world.ProgressiveRadiosity;
import radiosity.world.RadiositySettings;
import radiosity.world.RemoteWorld;
import radiosity.world.Schedule;
import radiosity.world.Solution;
import radiosity.world.StopRule;
import radiosity.world.World;

/** Renders a LightWave scene and writes a scene file (appendix C.1 of the paper). */
public final class RadiosityRenderer {

    private final RendererOptions options;
    private final OutputFiles files;
    private final Warnings warnings;
    private final StopRequest stop;
    private final PrintStream err = System.err;

    private RadiosityRenderer(RendererOptions options, List<String> arguments, StopRequest stop) {
        this.options = options;
        this.stop = stop;
        files = new OutputFiles(options, arguments);
        warnings = new Warnings(err, options.scene.strict);
    }

    public static void main(String[] arguments) {
        System.exit(run(arguments));
    }

    /**
     * The program without the end of the process.
     *
     * @return its exit code
     */
    public static int run(String... arguments) {
        RendererOptions options = new RendererOptions();
        StopRequest stop = new StopRequest();
        try (SaveBeforeExit ending = new SaveBeforeExit(stop)) {
            return CommandRun.of(options, () -> options.debug, () -> {
                if (options.file.info != null) {
                    printInfo(options.file.info);
                } else {
                    options.check();
                    new RadiosityRenderer(options, List.of(arguments), stop).render(ending);
                }
            }, arguments);
        }
    }

    private static void printInfo(Path scene) throws IOException {
        new FileChecks().input(scene);
        SceneInfo.lines(scene).forEach(System.out::println);
    }

    /** Figure 7 of the paper, from top to bottom. */
    private void render(SaveBeforeExit ending) throws IOException {
        files.check();
        Scene scene = SurfaceMaps.read(
                LightWaveReader.read(options.input(), options.scene.lightWave(), warnings::print), options.scene.srgb, warnings::accept);
        SavedCalculation saved = saved();
        RadiositySettings settings = settings(scene, saved);
        check(scene, settings);
        try (World world = world(scene, settings)) {
            checkTriangles(scene, world);
            checkPatches(world);
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, stopRule());
            Journal journal = new Journal(options.output(), settings, err::println);
            if (!journal.resume(radiosity) && saved != null) {
                radiosity.resume(saved.state());
            }
            ending.begin();
            calculate(world, radiosity, settings, journal);
            save(world, radiosity);
            journal.delete();
        }
    }

    private World world(Scene scene, RadiositySettings settings) throws IOException {
        int threads = options.calculation.threads;
        if (options.host.hosts == null) {
            return new LocalWorld(scene, settings, threads);
        }
        HostKey key = options.host.key == null ? null : PartitionServer.key(options.host.key);
        return new RemoteWorld(scene, settings, options.host.hosts, key, threads, err::println);
    }

    /** What {@code -tf} names, or null. */
    private SavedCalculation saved() throws IOException {
        if (options.file.resume == null) {
            return null;
        }
        SavedCalculation saved = SavedCalculation.read(options.file.resume.file());
        saved.checkShots(options.file.resume.shots());
        return saved;
    }

    private RadiositySettings settings(Scene scene, SavedCalculation saved) {
        RadiositySettings otherwise = saved == null ? options.calculation.defaults() : saved.settings();
        RadiositySettings settings = options.calculation.settings(scene, otherwise);
        if (saved != null) {
            saved.checkSettings(settings);
        }
        return settings;
    }

    private void check(Scene scene, RadiositySettings settings) {
        SceneChecks checks = new SceneChecks(scene, warnings);
        checks.light();
        checks.layers(settings.layers());
        if (options.textures != null) {
            checks.textures(options.textures);
        }
        checks.elements(settings.patchArea(), Runtime.getRuntime().maxMemory());
    }

    private void checkTriangles(Scene scene, World world) {
        if (world.droppedTriangles() > 0) {
            warnings.accept(scene.name() + ": expected triangles large enough to radiate, got " + world.droppedTriangles()
                    + " that are not; they only block light");
        }
    }

    private static void checkPatches(World world) {
        Schedule schedule = world.settings().schedule();
        if (schedule.isForSmallScenes() && world.patches() > Schedule.MOST_PATCHES) {
            throw Failure.commandLine("--schedule " + schedule.name().toLowerCase(Locale.ROOT), "expected at most "
                    + Schedule.MOST_PATCHES + " patches, got " + world.patches() + "; give a larger -pa");
        }
        if (schedule == Schedule.MATRIX && Double.isFinite(world.settings().meshing())) {
            throw Failure.commandLine("-mt", "expected without --schedule matrix, got it with");
        }
    }

    private StopRule stopRule() {
        return options.file.disableRendering ? new StopRule(0, 1) : options.calculation.stopRule();
    }

    private void calculate(World world, ProgressiveRadiosity radiosity, RadiositySettings settings, Journal journal)
            throws IOException {
        try (ProgressDisplay display = display(); KeyListener keys = new KeyListener(stop::make)) {
            stop.tell(display::message);
            keys.listen();
            Rounds rounds = new Rounds(radiosity, settings, options, files, journal, display, stop);
            radiosity.run(options.statistics && world instanceof RemoteWorld remote
                    ? new HostLines(remote::statistics, display, rounds, System::nanoTime) : rounds);
        }
    }

    private void save(World world, ProgressiveRadiosity radiosity) throws IOException {
        Solution solution = radiosity.solution();
        Optional<Certificate> certificate = stop.made() ? Optional.empty()
                : radiosity.certificate(options.calculation.threads);
        files.saveScene(solution, world.settings(), certificate);
        Summary summary = new Summary(radiosity.progress(), solution.ledger(), certificate, world.patchArea(), seconds());
        summary.print(System.out);
        files.saveRest(solution, summary);
        if (options.statistics && world instanceof RemoteWorld remote) {
            new StatisticsTable(remote.statistics()).print(System.out);
        }
    }

    /** Since the start of the process. */
    private static double seconds() {
        Instant now = Instant.now();
        Instant start = ProcessHandle.current().info().startInstant().orElse(now);
        return Duration.between(start, now).toMillis() / 1000.0;
    }

    private ProgressDisplay display() {
        if (options.quiet) {
            return new NoProgress(err);
        }
        ProgressText text = new ProgressText(stopRule(), System::nanoTime);
        return TerminalStreams.seen() ? new ProgressBarDisplay(err, TerminalStreams.width(), text)
                : new ProgressLines(err, text, System::nanoTime);
    }
}
