package radiosity.cli.terminal;

import java.io.PrintStream;
import java.text.DecimalFormat;
import java.time.temporal.ChronoUnit;
import java.util.Optional;
import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.DefaultProgressBarRenderer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;
import me.tongfei.progressbar.ProgressState;
import radiosity.solution.Progress;

/** A bar on a terminal. */
public final class ProgressBarDisplay implements ProgressDisplay {

    private static final int FULL = 1000;

    private final PrintStream err;
    private final int width;
    private final ProgressText text;
    private final ProgressBar bar;

    /** @param width of the terminal, characters */
    public ProgressBarDisplay(PrintStream err, int width, ProgressText text) {
        this.err = err;
        this.width = width;
        this.text = text;
        bar = new ProgressBarBuilder().setTaskName("").setInitialMax(FULL).setUpdateIntervalMillis(200)
                .continuousUpdate()
                .setRenderer(new Renderer()).setConsumer(new ConsoleProgressBarConsumer(err, width)).build();
    }

    @Override
    public void show(Progress progress) {
        bar.stepTo(Math.max(bar.getCurrent(), Math.round(FULL * text.done(progress))));
        bar.setExtraMessage(text.of(progress));
    }

    @Override
    public void message(String line) {
        err.println("\r" + " ".repeat(width) + "\r" + line);
    }

    @Override
    public void close() {
        bar.close();
    }

    /** Per cent, bar and time gone; what is counted stands in the message behind them. */
    private static final class Renderer extends DefaultProgressBarRenderer {

        Renderer() {
            super(ProgressBarStyle.ASCII, "", 1, false, new DecimalFormat("#"), ChronoUnit.SECONDS, false,
                    state -> Optional.empty());
        }

        @Override
        protected String ratio(ProgressState progress) {
            return "";
        }
    }
}
