package radiosity.edit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import radiosity.scene.Scene;
import radiosity.settings.Accuracy;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.setup.InitialMesh;
import radiosity.solution.Certificate;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;

/**
 * Renders a scene again and again while a user edits it, on its own thread. For each edit the follower first shows the
 * direct change of the light, then further reflections, and then renders to the accuracy of the settings. A further
 * edit cancels the render under way. Each render begins from the last solution that was completed.
 *
 * <p>Where the settings ask for an error below {@value #CLOSE}, a second solution of that accuracy is kept, which is
 * rendered when the first scene is at rest. The second is updated first, and alone while the user drags.
 */
public final class LightFollower implements AutoCloseable {

    /** Light within this difference of the final light counts as followed, see {@link LightDifference#of}. */
    public static final double CLOSE = 0.1;
    /** Least pause between pictures, relative to the time from the edit to the last picture. */
    private static final double PAUSE = 0.5;
    /** A picture comes without a pause where the unshot flux is less than this part of that of the last picture. */
    private static final double LESS = 0.25;
    /** Unshot flux, relative to the emitted flux, above which a render from the beginning shows no pictures yet. */
    private static final double DARK = 0.3;
    /** Unshot flux, relative to the emitted flux, above which the exact solution lacks more than the quick solution. */
    private static final double FOLLOWED = 0.03;
    /** No render begins from a solution with more elements than this factor times those of a full render. */
    private static final double GROWTH = 1.4;
    private static final int POINTS = 1000;

    private final Stage exact;
    private final Stage quick;
    private final int threads;
    private final Consumer<Solution> shown;
    private final Consumer<Rest> rested;
    private final Consumer<String> failed;
    private final Thread thread = new Thread(this::run, "light");
    /** The first quick solution while it is not yet complete; null where none is to be rendered. */
    private Preparation preparation;
    private final boolean isQuickWanted;
    private boolean isFirst = true;
    private Target target;
    private boolean closed;

    /**
     * @param isMoving whether the user is still dragging
     * @param since    time of the edit, {@link System#nanoTime}
     */
    private record Target(Scene scene, boolean isMoving, long since) { }

    /**
     * @param seconds time from the edit to the picture
     * @param unsent  unshot flux, relative to the emitted flux
     */
    private record Seen(Solution solution, double seconds, double unsent) {

        /** Whether the next picture may be shown. */
        boolean isOld(Target goal, double unsentNow) {
            return unsentNow < LESS * unsent || LightFollower.seconds(goal) > (1 + PAUSE) * seconds;
        }
    }

    /**
     * Result of an edit whose render was completed.
     *
     * @param solution    of the edited scene
     * @param certificate of the solution; empty where all is dark
     * @param seconds     time from the edit to the completed solution
     * @param first       seconds from the edit to the first picture
     * @param difference  difference of the first picture from the solution, see {@link LightDifference#of}
     * @param close       seconds from the edit to the first picture from which on all differ by at most {@value #CLOSE}
     * @param anew        why the scene was rendered from the beginning; empty where it was not
     */
    public record Rest(Solution solution, Optional<Certificate> certificate, double seconds, double first,
                       double difference, double close, String anew) {

        private static Rest of(Optional<Certificate> certificate, List<Seen> pictures, String anew) {
            Seen last = pictures.get(pictures.size() - 1);
            double[] places = LightDifference.places(last.solution.scene(), POINTS);
            double[] light = LightDifference.radiosity(last.solution, places);
            double close = last.seconds;
            double difference = 0;
            boolean isClose = true;
            for (int i = pictures.size() - 2; i >= 0; i--) {
                difference = LightDifference.of(light, LightDifference.radiosity(pictures.get(i).solution, places));
                isClose &= difference <= CLOSE;
                close = isClose ? pictures.get(i).seconds : close;
            }
            return new Rest(last.solution, certificate, last.seconds, pictures.get(0).seconds, difference, close, anew);
        }

        /** Describes the result in a line for the user. */
        public String text() {
            return String.format(Locale.ROOT, "at rest after %.2f s, expected error %.1f %%; first light after %.2f s"
                    + " (%.1f %% off), within %.0f %% after %.2f s%s", seconds,
                    100 * certificate.map(Certificate::expected).orElse(Double.NaN), first, 100 * difference,
                    100 * CLOSE, close, anew.isEmpty() ? "" : "; rendered anew, as " + anew);
        }
    }

    /**
     * Starts the follower's thread, which calls all three consumers.
     *
     * @param base     state of a solution of these settings to begin from; may be empty
     * @param settings settings of the exact solution
     * @param threads  number of threads that render, at least 1
     * @param shown    receives each picture, and returns when the picture is displayed
     * @param rested   receives the result of each edit that no further edit has cancelled
     * @param failed   receives a line for the user where a render fails
     */
    public LightFollower(SavedState base, RadiositySettings settings, int threads, Consumer<Solution> shown,
                         Consumer<Rest> rested, Consumer<String> failed) {
        exact = new Stage(settings, base);
        quick = new Stage(settings.accurate(CLOSE), SavedState.NONE);
        isQuickWanted = settings.schedule() == Schedule.PREDICT && Accuracy.of(settings.tolerance()) < CLOSE;
        this.threads = threads;
        this.shown = shown;
        this.rested = rested;
        this.failed = failed;
        thread.setDaemon(true);
        thread.start();
    }

    /** Makes the light follow a scene at rest; a render of an earlier scene is cancelled. */
    public void follow(Scene scene) {
        follow(scene, false);
    }

    /**
     * Makes the light follow a scene; a render of an earlier scene is cancelled.
     *
     * @param isMoving whether further edits are likely at once: the first picture of this scene is then shown in spite
     *                 of further edits of a moving object, so that there are pictures during a long drag
     */
    public synchronized void follow(Scene scene, boolean isMoving) {
        target = new Target(scene, isMoving, System.nanoTime());
        notifyAll();
    }

    private synchronized boolean isWanted(Target one) {
        return !closed && target == one;
    }

    private synchronized boolean isFirstWanted(Target one) {
        return !closed && (target == one || one.isMoving && target.isMoving);
    }

    private synchronized Target next(Target done) throws InterruptedException {
        while (!closed && (target == null || target == done)) {
            wait();
        }
        return closed ? null : target;
    }

    private void run() {
        try {
            for (Target next = next(null); next != null; next = next(next)) {
                try {
                    calculate(next);
                } catch (CancellationException e) {
                    continue; // a further edit has replaced the target
                } catch (IOException | RuntimeException | OutOfMemoryError e) {
                    failed.accept("light: " + (e.getMessage() == null ? e : e.getMessage()));
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void calculate(Target goal) throws IOException {
        List<Seen> pictures = new ArrayList<>();
        boolean isQuick = !quick.base.isEmpty();
        if (isQuick) {
            quick.render(goal, pictures);
        }
        if (isQuick && goal.isMoving || !isWanted(goal)) {
            return;
        }
        Optional<Rest> rest = exact.render(goal, pictures);
        if (isWanted(goal)) {
            rest.ifPresent(rested);
        }
        if (isFirst && isQuickWanted) {
            preparation = new Preparation(goal.scene);
        }
        isFirst = false;
        prepare(goal);
    }

    /** Renders the first quick solution, or continues its render, until a further edit comes. */
    private void prepare(Target goal) throws IOException {
        if (preparation != null && isWanted(goal)) {
            preparation.radiosity.run(progress -> isWanted(goal));
            if (isWanted(goal)) {
                quick.keep(preparation.radiosity.solution(), preparation.world.mesh, true);
                preparation.world.close();
                preparation = null;
            }
        }
    }

    /** The first quick solution while it is being rendered. */
    private final class Preparation {

        private final LocalWorld world;
        private final ProgressiveRadiosity radiosity;

        Preparation(Scene scene) {
            world = new LocalWorld(scene, quick.settings, threads);
            radiosity = radiosity(world);
        }
    }

    private static ProgressiveRadiosity radiosity(LocalWorld world) {
        return new ProgressiveRadiosity(world, new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT));
    }

    private static double seconds(Target goal) {
        return (System.nanoTime() - goal.since) * 1e-9;
    }

    private void show(Target goal, ProgressiveRadiosity radiosity, List<Seen> pictures) throws IOException {
        Solution solution = radiosity.solution();
        shown.accept(solution);
        pictures.add(new Seen(solution, seconds(goal), radiosity.progress().unsent()));
    }

    /** The solutions of one accuracy, each calculated from an earlier solution. */
    private final class Stage {

        private final RadiositySettings settings;
        private SavedState base;
        private InitialMesh baseMesh;
        /** Number of elements of the last full render; 0 while unknown. */
        private int elements;

        Stage(RadiositySettings settings, SavedState base) {
            this.settings = settings;
            this.base = base;
        }

        /** Renders a scene and shows pictures; returns nothing for the quick stage or after a further edit. */
        Optional<Rest> render(Target goal, List<Seen> pictures) throws IOException {
            try (LocalWorld world = new LocalWorld(goal.scene, settings, threads)) {
                ProgressiveRadiosity radiosity = radiosity(world);
                String anew = base.isEmpty() ? "nothing was rendered yet"
                        : radiosity.change(base, baseMesh, () -> isFirstWanted(goal)).orElse("");
                double most = !pictures.isEmpty() ? FOLLOWED : anew.isEmpty() ? Double.POSITIVE_INFINITY : DARK;
                if (anew.isEmpty() && pictures.isEmpty() && isFirstWanted(goal)) {
                    show(goal, radiosity, pictures);
                }
                radiosity.run(progress -> {
                    if (isWanted(goal) && progress.unsent() <= most && !progress.gathers() && (pictures.isEmpty()
                            || pictures.get(pictures.size() - 1).isOld(goal, progress.unsent()))) {
                        showUnchecked(goal, radiosity, pictures);
                    }
                    return isWanted(goal);
                });
                if (!isWanted(goal)) {
                    return Optional.empty();
                }
                show(goal, radiosity, pictures);
                keep(pictures.get(pictures.size() - 1).solution, world.mesh, !anew.isEmpty());
                return this == quick ? Optional.empty()
                        : Optional.of(Rest.of(radiosity.certificate(threads), pictures, anew));
            }
        }

        private void showUnchecked(Target goal, ProgressiveRadiosity radiosity, List<Seen> pictures) {
            try {
                show(goal, radiosity, pictures);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        /** Begins the next render from this solution, unless repeated changes have given it too many elements. */
        private void keep(Solution solution, InitialMesh mesh, boolean isAnew) {
            elements = elements == 0 || isAnew ? solution.elements() : elements;
            if (solution.elements() <= GROWTH * elements) {
                base = solution.state();
                baseMesh = mesh;
            }
        }
    }

    @Override
    public synchronized void close() {
        closed = true;
        notifyAll();
    }
}
