package radiosity.cli.render;

import java.io.IOException;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import radiosity.cli.options.ErrorReport;
import radiosity.cli.options.Failure;
import radiosity.cli.options.FileOptions;
import radiosity.cli.options.RendererOptions;
import radiosity.cli.terminal.ProgressDisplay;
import radiosity.settings.RadiositySettings;
import radiosity.solution.Progress;
import radiosity.solution.RoundListener;
import radiosity.solution.Solution;
import radiosity.solver.ProgressiveRadiosity;

/**
 * Shows progress, writes the journal and the files of {@code -si} and {@code -sn}, and decides whether to go on, after
 * every round.
 *
 * <p>A file that cannot be written for lack of disk space or memory gives a message and does not end the calculation.
 */
final class AutosaveListener implements RoundListener {

    private final ProgressiveRadiosity radiosity;
    private final RadiositySettings settings;
    private final FileOptions when;
    private final Integer snapshots;
    private final OutputFiles files;
    private final Optional<Journal> journal;
    private final ProgressDisplay display;
    private final BooleanSupplier goOn;
    private int before;
    private boolean cut;

    AutosaveListener(ProgressiveRadiosity radiosity, RadiositySettings settings, RendererOptions options,
            OutputFiles files,
           Optional<Journal> journal, ProgressDisplay display, BooleanSupplier goOn) {
        this.radiosity = radiosity;
        this.settings = settings;
        this.files = files;
        this.journal = journal;
        this.display = display;
        this.goOn = goOn;
        when = options.file;
        snapshots = options.picture.snapshotInterval;
        before = radiosity.shots();
        Stream.of(when.saveInterval, snapshots).flatMap(Stream::ofNullable).forEach(radiosity::pauseEvery);
    }

    @Override
    public boolean afterRound(Progress progress) {
        display.show(progress);
        cut = !goOn.getAsBoolean();
        try {
            if (journal.isPresent()) {
                keep(journal.get());
            }
            save(passed(when.saveInterval, progress.shots()), passed(snapshots, progress.shots()));
        } catch (Failure | IOException | OutOfMemoryError e) {
            display.message(ErrorReport.line(e));
        }
        before = progress.shots();
        return !cut;
    }

    /** Writes the journal if due, and before the end: the time left may be too short to save the scene file. */
    private void keep(Journal kept) throws IOException {
        if (cut) {
            kept.keepNow(radiosity::state);
        } else {
            kept.keep(radiosity::state);
        }
    }

    /** Whether the calculation was stopped because {@code goOn} returned false. */
    boolean isCut() {
        return cut;
    }

    private void save(boolean scene, boolean snapshot) throws IOException {
        if (!scene && !snapshot) {
            return;
        }
        Solution solution = radiosity.solution();
        if (scene) {
            files.saveScene(solution, settings, Optional.empty());
        }
        if (snapshot) {
            files.saveSnapshot(solution, goOn, display::message);
        }
    }

    /** Whether the number of shots has passed a multiple of the interval in this round; false without an interval. */
    private boolean passed(Integer interval, int now) {
        return interval != null && now / interval > before / interval;
    }
}
