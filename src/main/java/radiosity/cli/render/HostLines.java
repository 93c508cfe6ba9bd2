package radiosity.cli.render;

import java.io.IOException;
import java.util.Locale;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import radiosity.cli.terminal.ProgressDisplay;
import radiosity.solution.HostStatistics;
import radiosity.solution.Progress;
import radiosity.solution.RoundListener;
import radiosity.solution.WorldStatistics;

/** Prints a line about each host at most every 5 s while hosts calculate ({@code --statistics}). */
public final class HostLines implements RoundListener {

    private static final long NANOSECONDS_BETWEEN = 5_000_000_000L;

    private final Supplier<WorldStatistics> world;
    private final ProgressDisplay display;
    private final RoundListener next;
    private final LongSupplier clock;
    private long printed;

    /**
     * @param next  listener that is called after this one in every round
     * @param clock nanoseconds, as {@link System#nanoTime}
     */
    public HostLines(Supplier<WorldStatistics> world, ProgressDisplay display, RoundListener next, LongSupplier clock) {
        this.world = world;
        this.display = display;
        this.next = next;
        this.clock = clock;
        printed = clock.getAsLong();
    }

    @Override
    public boolean afterRound(Progress progress) {
        if (clock.getAsLong() - printed >= NANOSECONDS_BETWEEN) {
            printed = clock.getAsLong();
            world.get().hosts().forEach(host -> display.message(line(host)));
        }
        return next.afterRound(progress);
    }

    @Override
    public boolean afterEstimate(Progress progress) throws IOException {
        return next.afterEstimate(progress);
    }

    private static String line(HostStatistics host) {
        return String.format(Locale.ROOT, "host %s %s: %d blocks, %d elements, CPU %.1f s, idle %.0f %%", host.name(),
                host.state(), host.blocks(), host.elements(), host.cpu(), 100 * host.idle());
    }
}
