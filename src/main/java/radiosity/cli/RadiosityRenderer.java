package radiosity.cli;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import radiosity.cli.options.CommandRun;
import radiosity.cli.options.Failure;
import radiosity.cli.options.RendererOptions;
import radiosity.cli.options.TimeLimit;
import radiosity.cli.render.ConsoleSession;
import radiosity.cli.render.Failures;
import radiosity.cli.render.FileChecks;
import radiosity.cli.render.HostLines;
import radiosity.cli.render.Journal;
import radiosity.cli.render.JournalClaim;
import radiosity.cli.render.OutputFiles;
import radiosity.cli.render.RenderJob;
import radiosity.cli.render.RenderResult;
import radiosity.cli.render.SaveBeforeExit;
import radiosity.cli.render.SavedCalculation;
import radiosity.cli.render.SceneChecks;
import radiosity.cli.render.Summary;
import radiosity.cli.render.TimedCalculation;
import radiosity.cli.render.Warnings;
import radiosity.cli.terminal.ProgressBarDisplay;
import radiosity.cli.terminal.ProgressDisplay;
import radiosity.cli.terminal.ProgressEstimate;
import radiosity.cli.terminal.ProgressLines;
import radiosity.cli.terminal.ProgressText;
import radiosity.cli.terminal.StopRequest;
import radiosity.cli.terminal.StopRuleCourse;
import radiosity.cli.terminal.TerminalStreams;
import radiosity.cli.terminal.TimeCourse;
import radiosity.input.SceneReader;
import radiosity.output.gltf.SceneInfo;
import radiosity.output.image.SurfaceMaps;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.settings.RadiositySettings;
import radiosity.solution.SavedState;
import radiosity.solver.ProgressiveRadiosity;

/** The program that renders a scene and writes a scene file (appendix C.1 of the paper). */
public final class RadiosityRenderer {

    private final RendererOptions options;
    private final OutputFiles files;
    private final ProgressEstimate course;
    /** Text of all displays of this render. */
    private final ProgressText text;
    private final ConsoleSession user;
    private final Warnings warnings;
    private final StopRequest stop;
    private final PrintStream err = System.err;

    RadiosityRenderer(RendererOptions options, List<String> arguments, StopRequest stop) {
        this.options = options;
        this.stop = stop;
        files = new OutputFiles(options, arguments);
        course = options.calculation.time == null
                ? new StopRuleCourse(RenderJob.stopRule(options), options.calculation.lastAccuracy(), System::nanoTime)
                : new TimeCourse(options.calculation.time.seconds(), TimeCourse::ofProcess);
        text = new ProgressText(course);
        user = new ConsoleSession(err, display(), stop);
        warnings = new Warnings(user::message, options.scene.strict);
    }

    public static void main(String[] arguments) {
        System.exit(run(arguments));
    }

    /**
     * Runs the program without ending the process.
     *
     * @return the exit code
     */
    public static int run(String... arguments) {
        return run(SaveBeforeExit.PATIENCE, arguments);
    }

    /** @param patience longest time that Ctrl-C or SIGTERM waits until everything is saved */
    static int run(Duration patience, String... arguments) {
        RendererOptions options = new RendererOptions();
        StopRequest stop = new StopRequest();
        try (SaveBeforeExit ending = new SaveBeforeExit(stop, patience)) {
            return CommandRun.of(options, options.common, () -> {
                if (options.file.info != null) {
                    printInfo(options.described());
                } else {
                    options.check();
                    Animation.Renderer renderer =
                            frame -> new RadiosityRenderer(frame, List.of(arguments), stop).render(ending);
                    if (options.file.frames != null) {
                        new Animation(List.of(arguments), stop, renderer).render(options);
                    } else {
                        renderer.render(options);
                    }
                }
            }, arguments);
        }
    }

    private static void printInfo(Path scene) throws IOException {
        new FileChecks().input(scene);
        SceneInfo.lines(scene).forEach(System.out::println);
    }

    /** Renders one scene: figure 7 of the paper from top to bottom. {@link RenderJob} is the middle of the figure. */
    void render(SaveBeforeExit ending) throws IOException {
        files.check();
        if (course instanceof TimeCourse timed) {
            calculate(timed, options.calculation.time, ending);
            return;
        }
        try (JournalClaim claim = JournalClaim.of(Journal.of(options.output()))) {
            calculate(claim, ending);
        }
    }

    private Scene scene() throws IOException {
        user.phase("reading " + options.input().getFileName());
        Scene scene = options.daylight.around(SceneReader.read(options.input(), options.readOptions(),
                warnings::print));
        options.scene.check(scene);
        files.check(scene);
        if (options.file.lightmap != null) {
            SceneReader.original(options.input(), options.readOptions(), scene); // fails now, not after the render
        }
        return SurfaceMaps.read(scene, options.scene.srgb, warnings::accept);
    }

    /** Calculates with a journal, and writes all outputs; the journal is deleted only after every output is written. */
    private void calculate(JournalClaim claim, SaveBeforeExit ending) throws IOException {
        Journal journal;
        RenderResult result;
        boolean saved;
        Failures failures = new Failures();
        try (user) {
            SavedCalculation before = saved();
            Optional<SavedCalculation> changed = changed();
            Scene scene = scene();
            RadiositySettings settings = checked(scene, before, changed.map(SavedCalculation::settings)
                    .orElseGet(options.calculation::defaults));
            journal = new Journal(claim, settings + (options.file.change == null ? "" : " --change "
                    + options.file.change), user::message, System::nanoTime);
            result = new RenderJob(options, scene, files, warnings, user).run(settings, radiosity -> {
                if (!journal.resume(radiosity)) {
                    begin(radiosity, before, changed);
                }
                int wanted = options.calculation.stopRule().shots();
                if (radiosity.shots() > wanted) {
                    user.message(String.format(Locale.ROOT, "-it: expected a saved calculation of at most %,d shots to"
                            + " go on from, got %,d; the result has these", wanted, radiosity.shots()));
                }
                ending.begin(Optional.of(claim.journal()));
            }, RenderJob.Aims.of(options.calculation.aims(settings)), Optional.of(journal), () -> !stop.made());
            user.phase("writing " + options.output().getFileName());
            saved = failures.tried(() -> save(result, settings, journal));
        }
        Summary summary = write(result, Optional.empty(), saved, failures);
        journal.delete();
        if (result.isCut() && options.file.change == null && options.file.frames == null) {
            System.out.println("stopped: the same command with -tf " + quoted(options.output())
                    + " goes on");
        }
        finish(result, summary);
    }

    /** Writes the scene file; where that fails, the journal, and the failure says whether the work is kept. */
    private void save(RenderResult result, RadiositySettings settings, Journal journal) throws IOException {
        try {
            files.saveScene(result.solution(), settings, result.certificate());
        } catch (Failure e) {
            throw e.and(journal.keepResult(result.solution().state()));
        }
    }

    /** A file as a shell takes it in one word. */
    private static String quoted(Path file) {
        return file.toString().indexOf(' ') < 0 ? file.toString() : '"' + file.toString() + '"';
    }

    private void begin(ProgressiveRadiosity radiosity, SavedCalculation before, Optional<SavedCalculation> changed)
            throws IOException {
        if (before != null) {
            resume(radiosity, before);
        } else if (options.file.change != null) {
            user.phase("changing the light");
            Optional<String> anew = radiosity.change(changed.isEmpty() ? SavedState.NONE : changed.get().state());
            anew.ifPresent(why -> user.message(options.file.change + ": the scene is rendered anew, as " + why));
        }
    }

    private void resume(ProgressiveRadiosity radiosity, SavedCalculation before) throws IOException {
        try {
            radiosity.resume(before.state());
        } catch (SceneFormatException e) {
            throw Failure.file(before.file() + " does not go on with " + options.input().getFileName(),
                    e.getMessage(), e);
        }
    }

    /** The calculation in the scene file that {@code --change} names; empty without the option or a calculation. */
    private Optional<SavedCalculation> changed() throws IOException {
        return options.file.change == null ? Optional.empty() : SavedCalculation.find(options.file.change);
    }

    /** Calculates as exactly as the time limit allows ({@code --time}), and writes all outputs. */
    private void calculate(TimeCourse course, TimeLimit limit, SaveBeforeExit ending) throws IOException {
        RenderResult result;
        String inTime;
        Failures failures = new Failures();
        boolean saved;
        try (user) {
            Scene scene = scene();
            RadiositySettings settings = checked(scene, null, options.calculation.defaults());
            ending.begin(Optional.empty());
            TimedCalculation timed = new TimedCalculation(new RenderJob(options, scene, files, warnings, user),
                    settings, limit, course, user, stop, files);
            result = timed.run();
            saved = failures.tried(timed::save);
            inTime = timed.summary();
        }
        finish(result, write(result, Optional.of(inTime), saved, failures));
    }

    /** The calculation in the scene file that {@code -tf} names; null without {@code -tf}. */
    private SavedCalculation saved() throws IOException {
        if (options.file.resume == null) {
            return null;
        }
        SavedCalculation saved = SavedCalculation.read(options.file.resume.file());
        options.file.resume.shots().ifPresent(saved::checkShots);
        return saved;
    }

    /**
     * The settings of the calculation; fails or warns where the scene cannot or should not be rendered with these
     * settings.
     *
     * @param saved     calculation that supplies what no option sets; null for none
     * @param otherwise settings that do so where there is no saved calculation
     */
    private RadiositySettings checked(Scene scene, SavedCalculation saved, RadiositySettings otherwise) {
        RadiositySettings settings = settings(scene, saved, otherwise);
        check(scene, settings);
        return settings;
    }

    private RadiositySettings settings(Scene scene, SavedCalculation saved, RadiositySettings otherwise) {
        RadiositySettings settings = options.calculation.settings(scene, saved == null ? otherwise : saved.settings());
        return saved == null ? settings : saved.goingOn(settings);
    }

    private void check(Scene scene, RadiositySettings settings) {
        SceneChecks checks = new SceneChecks(scene, warnings);
        checks.light();
        checks.luminaires();
        checks.objects();
        checks.emission();
        checks.layers(settings.layers());
        if (options.textures != null) {
            checks.textures("-ut", options.textures);
        }
        if (options.file.lightmapTexels != null) {
            checks.textures("--lightmap-texels", options.file.lightmapTexels);
        }
        int layers = settings.layers() ? scene.lamps().size() : 0;
        SceneChecks.sizes(checks.patches(settings.patchArea()), Math.max(1, layers), layers);
        checks.elements(settings.patchArea(), Runtime.getRuntime().maxMemory());
        if (options.picture.isWanted() && options.picture.size == null) {
            checks.pictures(options.picture.width());
        }
    }

    /**
     * Prints the summary and writes every output but the scene file.
     *
     * @param inTime   line of the summary about the time limit, where there was a time limit
     * @param saved    whether the scene file was saved
     * @param failures of the outputs so far; failures of further outputs are added
     * @throws Failure where any output could not be written
     */
    private Summary write(RenderResult result, Optional<String> inTime, boolean saved, Failures failures) {
        Summary summary = new Summary(result, inTime, TimeCourse.ofProcess());
        if (saved) {
            summary.print(System.out);
        }
        files.saveRest(result.solution(), summary, failures, new ConsoleSession(err, display(), stop), stop);
        failures.check();
        return summary;
    }

    /**
     * Prints statistics and any shortfall of accuracy, after all outputs are written.
     *
     * @throws Failure where the shortfall is from the accuracy that {@code --accuracy} asks for
     */
    private void finish(RenderResult result, Summary summary) {
        if (options.statistics) {
            result.statistics().ifPresent(hosts -> HostLines.print(hosts, System.out));
        }
        Optional<String> shortfall = summary.shortfall();
        if (options.calculation.isAccuracyAsked() && shortfall.isPresent()) {
            throw Failure.notAccurate(shortfall.get());
        }
        shortfall.ifPresent(System.out::println);
    }

    private ProgressDisplay display() {
        if (options.quiet) {
            return err::println;
        }
        return TerminalStreams.seen() ? new ProgressBarDisplay(err, TerminalStreams::width, text, System::nanoTime)
                : new ProgressLines(err, text, System::nanoTime);
    }
}
