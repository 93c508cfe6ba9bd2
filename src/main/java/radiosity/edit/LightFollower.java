package radiosity.edit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
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
 */
public final class LightFollower implements AutoCloseable {

    /** Light within this of that at rest counts as followed, see {@link LightDifference#of}. */
    public static final double CLOSE = 0.1;
    /** Pictures after the first come at most this often, of the time since the edit. */
    private static final double PAUSE = 0.5;
    /** Unshot flux relative to the emitted above which a render anew shows nothing yet. */
    private static final double DARK = 0.3;
    private static final int POINTS = 1000;

    private final RadiositySettings settings;
    private final int threads;
    private final Consumer<Solution> shown;
    private final Consumer<Rest> rested;
    private final Consumer<String> failed;
    private final Thread thread = new Thread(this::run, "light");
    private SavedState base;
    private InitialMesh baseMesh;
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
        this.base = base;
        this.settings = settings;
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
                } catch (IOException | RuntimeException | OutOfMemoryError e) {
                    failed.accept("light: " + e.getMessage());
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void calculate(Target goal) throws IOException {
        List<Seen> pictures = new ArrayList<>();
        try (LocalWorld world = new LocalWorld(goal.scene, settings, threads)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world,
                    new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT));
            String anew = base.isEmpty() ? "nothing was rendered yet" : radiosity.change(base, baseMesh).orElse("");
            double most = anew.isEmpty() ? Double.POSITIVE_INFINITY : DARK;
            if (anew.isEmpty() && isFirstWanted(goal)) {
                show(goal, radiosity, pictures);
            }
            radiosity.run(progress -> {
                double last = pictures.isEmpty() ? 0 : pictures.get(pictures.size() - 1).seconds;
                if (isWanted(goal) && progress.unsent() <= most && !progress.gathers()
                        && seconds(goal) > (1 + PAUSE) * last) {
                    show(goal, radiosity, pictures);
                }
                return isWanted(goal);
            });
            if (isWanted(goal)) {
                rest(goal, radiosity, world, pictures, anew);
            }
        }
    }

    private static double seconds(Target goal) {
        return (System.nanoTime() - goal.since) * 1e-9;
    }

    private void show(Target goal, ProgressiveRadiosity radiosity, List<Seen> pictures) {
        try {
            Solution solution = radiosity.solution();
            shown.accept(solution);
            pictures.add(new Seen(solution, seconds(goal)));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void rest(Target goal, ProgressiveRadiosity radiosity, LocalWorld world, List<Seen> pictures,
                      String anew) throws IOException {
        show(goal, radiosity, pictures);
        Seen last = pictures.get(pictures.size() - 1);
        base = last.solution.state();
        baseMesh = world.mesh;
        Optional<Certificate> certificate = radiosity.certificate(threads);
        double[] places = LightDifference.places(goal.scene, POINTS);
        double[] light = LightDifference.radiosity(last.solution, places);
        double close = last.seconds;
        double difference = 0;
        boolean isClose = true;
        for (int i = pictures.size() - 2; i >= 0; i--) {
            difference = LightDifference.of(light, LightDifference.radiosity(pictures.get(i).solution, places));
            isClose &= difference <= CLOSE;
            close = isClose ? pictures.get(i).seconds : close;
        }
        rested.accept(new Rest(last.solution, certificate, last.seconds, pictures.get(0).seconds, difference, close,
                anew));
    }

    @Override
    public synchronized void close() {
        closed = true;
        notifyAll();
    }
}
