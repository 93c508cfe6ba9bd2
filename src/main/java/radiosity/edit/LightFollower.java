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
 * Renders a scene again and again as it is edited, on a thread of its own: of each edit first what it changes of the
 * light there is, then what that is reflected to, then to the accuracy of the settings. A further edit ends what is
 * under way. Each begins from the last solution that was brought to its end.
 *
 * <p>Where the settings ask for less error than {@value #CLOSE}, a second solution of that accuracy is kept: it follows
 * first, and alone while the hand moves. It is rendered when the first scene is at rest.
 */
public final class LightFollower implements AutoCloseable {

    /** Light within this of that at rest counts as followed, see {@link LightDifference#of}. */
    public static final double CLOSE = 0.1;
    /** Pictures after the first come at most this often, of the time since the edit. */
    private static final double PAUSE = 0.5;
    /** Unshot flux relative to the emitted above which a render anew shows nothing yet. */
    private static final double DARK = 0.3;
    /** The same above which the exact solution lacks more than the quick one. */
    private static final double FOLLOWED = 0.03;
    /** A solution with more elements, of those that a render anew has, is left again after it was shown. */
    private static final double GROWTH = 1.4;
    private static final int POINTS = 1000;

    private final Stage exact;
    private final Stage quick;
    private final int threads;
    private final Consumer<Solution> shown;
    private final Consumer<Rest> rested;
    private final Consumer<String> failed;
    private final Thread thread = new Thread(this::run, "light");
    /** What the quick solution begins with, until it is rendered; null where there is none to be rendered. */
    private Preparation preparation;
    private final boolean isQuickWanted;
    private boolean isFirst = true;
    private Target target;
    private boolean closed;

    /** @param isMoving whether the hand that edits is still on the way */
    private record Target(Scene scene, boolean isMoving, long since) { }

    /** @param seconds from the edit until it was shown */
    private record Seen(Solution solution, double seconds) { }

    /**
     * What became of an edit.
     *
     * @param solution    of the scene with the edit
     * @param certificate of it; empty where all is dark
     * @param seconds     from the edit to this
     * @param first       seconds from the edit to the first picture
     * @param difference  of the first picture from this
     * @param close       seconds from the edit to the first picture from which on all were within {@value #CLOSE} of
     *                    this
     * @param anew        why all was rendered anew; empty where it was not
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

        /** For the user. */
        public String text() {
            return String.format(Locale.ROOT, "at rest after %.2f s, expected error %.1f %%; first light after %.2f s"
                    + " (%.1f %% off), within %.0f %% after %.2f s%s", seconds,
                    100 * certificate.map(Certificate::expected).orElse(Double.NaN), first, 100 * difference,
                    100 * CLOSE, close, anew.isEmpty() ? "" : "; rendered anew, as " + anew);
        }
    }

    /**
     * @param base     state of a solution to begin from, with these settings; may be empty
     * @param settings how exactly to render, and how
     * @param threads  at least 1
     * @param shown    gets each picture, on the follower's thread, and returns when the user sees it
     * @param rested   gets what became of each edit that no further one ended, likewise
     * @param failed   gets a line where something fails, likewise
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

    /** Has the light follow a scene; what is under way for an earlier one ends. */
    public void follow(Scene scene) {
        follow(scene, false);
    }

    /**
     * Has the light follow a scene.
     *
     * @param isMoving whether further edits are likely to come at once: a first picture is shown in spite of them, so
     *                 that there are some while a hand moves on and on
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
                    continue; // a further edit
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
        if (isFirst && isQuickWanted) {
            preparation = new Preparation(goal.scene);
            prepare(goal);
        }
        isFirst = false;
        if (isWanted(goal)) {
            rest.ifPresent(rested);
            prepare(goal);
        }
    }

    /** Renders the first quick solution, or goes on with that, as long as nobody edits. */
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

    /** The first quick solution, while it is being rendered. */
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

    private void show(Target goal, Solution solution, List<Seen> pictures) {
        shown.accept(solution);
        pictures.add(new Seen(solution, seconds(goal)));
    }

    /** Solutions of one accuracy, each begun from an earlier one. */
    private final class Stage {

        private final RadiositySettings settings;
        private SavedState base;
        private InitialMesh baseMesh;
        /** Elements of what was rendered anew; 0 where that is not known yet. */
        private int elements;

        Stage(RadiositySettings settings, SavedState base) {
            this.settings = settings;
            this.base = base;
        }

        /** Shows pictures; nothing where a further edit has ended it. */
        Optional<Rest> render(Target goal, List<Seen> pictures) throws IOException {
            try (LocalWorld world = new LocalWorld(goal.scene, settings, threads)) {
                ProgressiveRadiosity radiosity = radiosity(world);
                String anew = base.isEmpty() ? "nothing was rendered yet"
                        : radiosity.change(base, baseMesh, () -> isFirstWanted(goal)).orElse("");
                double most = !pictures.isEmpty() ? FOLLOWED : anew.isEmpty() ? Double.POSITIVE_INFINITY : DARK;
                if (anew.isEmpty() && pictures.isEmpty() && isFirstWanted(goal)) {
                    show(goal, radiosity.solution(), pictures);
                }
                radiosity.run(progress -> {
                    double last = pictures.isEmpty() ? 0 : pictures.get(pictures.size() - 1).seconds;
                    if (isWanted(goal) && progress.unsent() <= most && !progress.gathers()
                            && seconds(goal) > (1 + PAUSE) * last) {
                        show(goal, solution(radiosity), pictures);
                    }
                    return isWanted(goal);
                });
                if (!isWanted(goal)) {
                    return Optional.empty();
                }
                show(goal, radiosity.solution(), pictures);
                keep(pictures.get(pictures.size() - 1).solution, world.mesh, !anew.isEmpty());
                return this == quick ? Optional.empty()
                        : Optional.of(Rest.of(radiosity.certificate(threads), pictures, anew));
            }
        }

        private static Solution solution(ProgressiveRadiosity radiosity) {
            try {
                return radiosity.solution();
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        /** What comes next begins from here, unless one change after another has made too many elements. */
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
