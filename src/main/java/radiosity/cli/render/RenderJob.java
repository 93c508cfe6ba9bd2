package radiosity.cli.render;

import java.io.IOException;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import radiosity.cli.options.Failure;
import radiosity.cli.options.RendererOptions;
import radiosity.cli.terminal.ProgressText;
import radiosity.master.RemoteWorld;
import radiosity.rmi.HostKey;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Progress;
import radiosity.solution.RoundListener;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.solver.World;

/** The middle of figure 7 of the paper: sets up a world, distributes the light, and merges the result. */
public final class RenderJob {

    private final RendererOptions options;
    private final Scene scene;
    private final OutputFiles files;
    private final Warnings warnings;
    private final ConsoleSession user;

    public RenderJob(RendererOptions options, Scene scene, OutputFiles files, Warnings warnings, ConsoleSession user) {
        this.options = options;
        this.scene = scene;
        this.files = files;
        this.warnings = warnings;
        this.user = user;
    }

    /** Errors that a calculation is to reach, one after the other. */
    public interface Aims {

        /** Relative error to reach after a result that reached the one before; empty where the calculation is done. */
        OptionalDouble after(RenderResult result) throws IOException;

        /** Is called with the solution of each estimate of the error that does not end the calculation. */
        default void estimated(Estimated solution) throws IOException { }

        /** The result of a calculation that is cut; empty for the solution at the cut. */
        default Optional<RenderResult> kept() {
            return Optional.empty();
        }

        /** A fixed list of relative errors. */
        static Aims of(List<Double> errors) {
            Iterator<Double> rest = errors.iterator();
            return result -> rest.hasNext() ? OptionalDouble.of(rest.next()) : OptionalDouble.empty();
        }
    }

    /** A solution whose error was just estimated; it takes time to collect. */
    public interface Estimated {
        RenderResult result() throws IOException;
    }

    /** Prepares a calculation before its first round, for example by resuming it from a saved state. */
    public interface Beginning {
        void of(ProgressiveRadiosity radiosity) throws IOException;
    }

    /**
     * Calculates until all aims or the largest number of shots are reached, or until {@code goOn} returns false.
     *
     * @param aims    asked for the next error each time that one is reached
     * @param journal written during the calculation
     * @param goOn    asked after every round
     */
    public RenderResult run(RadiositySettings settings, Beginning beginning, Aims aims, Optional<Journal> journal,
            BooleanSupplier goOn) throws IOException {
        user.phase("setting up");
        try (World world = world(settings)) {
            check(world);
            StopRule stop = stopRule(options);
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, stop);
            beginning.of(radiosity);
            user.begin();
            AutosaveListener rounds = new AutosaveListener(radiosity, settings, options, files, journal, user, goOn);
            RoundListener listener = listener(world, new RoundListener() {
                @Override
                public boolean afterRound(Progress progress) {
                    return rounds.afterRound(progress);
                }

                @Override
                public boolean afterEstimate(Progress progress) throws IOException {
                    aims.estimated(() -> result(radiosity, world, settings, false));
                    return true;
                }
            });
            while (true) {
                radiosity.run(listener);
                if (rounds.isCut() && aims.kept().isPresent()) {
                    return aims.kept().get();
                }
                RenderResult result = result(radiosity, world, settings, rounds.isCut());
                boolean isStopped = rounds.isCut() || radiosity.shots() >= stop.shots()
                        || radiosity.estimates() >= stop.estimates();
                OptionalDouble next = isStopped ? OptionalDouble.empty() : aims.after(result);
                if (next.isEmpty()) {
                    return result;
                }
                radiosity.aim(next.getAsDouble());
            }
        }
    }

    private RenderResult result(ProgressiveRadiosity radiosity, World world, RadiositySettings settings, boolean isCut)
            throws IOException {
        user.phase("estimating the error");
        return new RenderResult(radiosity.solution(), settings, radiosity.aim(), radiosity.progress(),
                world.patchArea(),
                isCut ? Optional.empty() : radiosity.certificate(options.calculation.threads),
                world instanceof RemoteWorld remote ? Optional.of(remote.statistics()) : Optional.empty(),
                radiosity.isOnlyRoundingLeft(), isCut);
    }

    private World world(RadiositySettings settings) throws IOException {
        int threads = options.calculation.threads;
        if (options.host.hosts == null) {
            return new LocalWorld(scene, settings, threads);
        }
        HostKey key = options.host.key == null ? null : FileChecks.key(options.host.key);
        return new RemoteWorld(scene, settings, options.host.hosts, key, threads, user::message);
    }

    private RoundListener listener(World world, RoundListener rounds) {
        return options.statistics && world instanceof RemoteWorld remote
                ? new HostLines(remote::statistics, user, rounds, System::nanoTime) : rounds;
    }

    public static StopRule stopRule(RendererOptions options) {
        return options.file.disableRendering ? new StopRule(0, 1) : options.calculation.stopRule();
    }

    private void check(World world) {
        if (world.droppedTriangles() > 0) {
            warnings.accept(scene.name() + ": " + ProgressText.count(world.droppedTriangles(), "triangle")
                    + (world.droppedTriangles() == 1 ? " is too small to be lit; it still casts shadows"
                    : " are too small to be lit; they still cast shadows"));
        }
        new SceneChecks(scene, warnings).insideOut(world.insideOut());
        new SceneChecks(scene, warnings).unseen(world.unseenLamps());
        SceneChecks.sizes(world.patches(), world.channels(), world.settings().layers() ? scene.lamps().size() : 0);
        Schedule schedule = world.settings().schedule();
        if (schedule.isForSmallScenes() && world.patches() > Schedule.MOST_PATCHES) {
            throw Failure.commandLine("--schedule " + schedule.name().toLowerCase(Locale.ROOT), "expected at most "
                    + Schedule.MOST_PATCHES + " patches, got " + world.patches() + "; give a larger -pa");
        }
        if (schedule == Schedule.MATRIX && Double.isFinite(world.settings().meshing())) {
            throw Failure.commandLine("-mt", "expected without --schedule matrix, got it with");
        }
    }
}
