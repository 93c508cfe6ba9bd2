package radiosity.cli;

import java.io.IOException;
import radiosity.world.Progress;
import radiosity.world.ProgressiveRadiosity;
import radiosity.world.RadiositySettings;
import radiosity.world.RoundListener;

/** What happens after every round: progress, files of {@code -si} and {@code -sn}, and whether to go on. */
final class Rounds implements RoundListener {

    private final ProgressiveRadiosity radiosity;
    private final RadiositySettings settings;
    private final FileOptions when;
    private final Integer snapshots;
    private final OutputFiles files;
    private final ProgressDisplay display;
    private final StopRequest stop;
    private int before;

    Rounds(ProgressiveRadiosity radiosity, RadiositySettings settings, RendererOptions options, OutputFiles files,
           ProgressDisplay display, StopRequest stop) {
        this.radiosity = radiosity;
        this.settings = settings;
        this.files = files;
        this.display = display;
        this.stop = stop;
        when = options.file;
        snapshots = options.picture.snapshotInterval;
        before = radiosity.shots();
    }

    @Override
    public boolean afterRound(Progress progress) {
        display.show(progress);
        try {
            if (passed(when.saveInterval, progress.shots())) {
                files.saveScene(radiosity.solution(), settings);
            }
            if (passed(snapshots, progress.shots())) {
                files.saveSnapshot(radiosity.solution());
            }
        } catch (IOException e) {
            display.message(Outcome.line(e));
        }
        before = progress.shots();
        return !stop.made();
    }

    /** Whether a multiple of the interval lies in the shots of the round: a round may hold several. */
    private boolean passed(Integer interval, int now) {
        return interval != null && now / interval > before / interval;
    }
}
