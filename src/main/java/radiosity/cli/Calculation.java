package radiosity.cli;

import java.io.IOException;
import java.util.HashSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import radiosity.scene.Scene;
import radiosity.world.HostKey;
import radiosity.world.LocalWorld;
import radiosity.world.ProgressiveRadiosity;
import radiosity.world.RadiositySettings;
import radiosity.world.RemoteWorld;
import radiosity.world.RoundListener;
import radiosity.world.Schedule;
import radiosity.world.StopRule;
import radiosity.world.World;

/** The middle of figure 7 of the paper: a world is set up, light is distributed, and the result merged. */
final class Calculation {

    private final RendererOptions options;
    private final Scene scene;
    private final OutputFiles files;
    private final Warnings warnings;
    private final Conversation user;
    private final HostNotices hostNotices;
    private boolean warned;

    Calculation(RendererOptions options, Scene scene, OutputFiles files, Warnings warnings, Conversation user) {
        this.options = options;
        this.scene = scene;
        this.files = files;
        this.warnings = warnings;
        this.user = user;
        hostNotices = new HostNotices(user::message);
    }

    /** What to go on from, before the first round. */
    interface Beginning {
        void of(ProgressiveRadiosity radiosity) throws IOException;
    }

    /**
     * Calculates until it is done, or is not to go on.
     *
     * @param journal kept meanwhile, where there is one
     */
    Calculated run(RadiositySettings settings, Beginning beginning, Optional<Journal> journal, BooleanSupplier goOn)
            throws IOException {
        try (World world = world(settings)) {
            check(world);
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, stopRule(options));
            beginning.of(radiosity);
            user.begin();
            Rounds rounds = new Rounds(radiosity, settings, options, files, journal, user, goOn);
            radiosity.run(told(world, rounds));
            return new Calculated(radiosity.solution(), settings, radiosity.progress(), world.patchArea(),
                    rounds.isCut() ? Optional.empty() : radiosity.certificate(options.calculation.threads),
                    world instanceof RemoteWorld remote ? Optional.of(remote.statistics()) : Optional.empty(),
                    radiosity.isOnlyRoundingLeft(),
                    rounds.isCut());
        }
    }

    private World world(RadiositySettings settings) throws IOException {
        int threads = options.calculation.threads;
        if (options.host.hosts == null) {
            return new LocalWorld(scene, settings, threads);
        }
        HostKey key = options.host.key == null ? null : FileChecks.key(options.host.key);
        return hostNotices.whileOpening(() -> new RemoteWorld(scene, settings, options.host.hosts, key, threads, hostNotices));
    }

    /** Passes notices about hosts on; that a host cannot be used is a notice once, not in every calculation anew. */
    static final class HostNotices implements Consumer<String> {

        private final Consumer<String> user;
        private final Set<String> ofOpening = new HashSet<>();
        private boolean opening;

        HostNotices(Consumer<String> user) {
            this.user = user;
        }

        <T> T whileOpening(Opening<T> world) throws IOException {
            setOpening(true);
            try {
                return world.open();
            } finally {
                setOpening(false);
            }
        }

        private synchronized void setOpening(boolean now) {
            opening = now;
        }

        @Override
        public synchronized void accept(String line) {
            if (!opening) {
                ofOpening.clear();
            } else if (!ofOpening.add(line)) {
                return;
            }
            user.accept(line);
        }
    }

    /** Opens sessions with hosts. */
    interface Opening<T> {
        T open() throws IOException;
    }

    private RoundListener told(World world, Rounds rounds) {
        return options.statistics && world instanceof RemoteWorld remote
                ? new HostLines(remote::statistics, user, rounds, System::nanoTime) : rounds;
    }

    static StopRule stopRule(RendererOptions options) {
        return options.file.disableRendering ? new StopRule(0, 1) : options.calculation.stopRule();
    }

    private void check(World world) {
        if (world.droppedTriangles() > 0 && !warned) {
            warned = true;
            warnings.accept(scene.name() + ": expected triangles large enough to radiate, got " + world.droppedTriangles()
                    + " that are not; they only block light");
        }
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
