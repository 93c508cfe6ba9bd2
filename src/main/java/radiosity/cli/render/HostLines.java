package radiosity.cli.render;

import java.io.IOException;
import java.io.PrintStream;
import java.util.Locale;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import radiosity.cli.terminal.ProgressDisplay;
import radiosity.solution.HostStatistics;
import radiosity.solution.Progress;
import radiosity.solution.RoundListener;
import radiosity.solution.WorldStatistics;

/** Prints what each host does ({@code --statistics}): a line at most every 5 s while hosts calculate, then a table. */
public final class HostLines implements RoundListener {

    private static final long NANOSECONDS_BETWEEN = 5_000_000_000L;
    private static final double MEBIBYTE = 1 << 20;

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

    /** Prints a table of the work that each host has done ({@code --statistics}). */
    public static void print(WorldStatistics world, PrintStream out) {
        out.printf(Locale.ROOT, "%-24s %-8s %7s %10s %7s %9s %7s %9s%n", "host", "", "blocks", "elements", "calls",
                "CPU s", "idle %", "MiB");
        for (HostStatistics host : world.hosts()) {
            out.printf(Locale.ROOT, "%-24s %-8s %7d %,10d %7d %9.2f %7.1f %9.1f%n", host.name(), host.state(),
                    host.blocks(), host.elements(), host.rounds(), host.cpu(), 100 * host.idle(),
                    host.bytes() / MEBIBYTE);
        }
        out.printf(Locale.ROOT, "%,d calls to all; CPU %.2f s, of the slowest in each %.2f s, most/mean %.3f%n",
                world.rounds(), world.cpu(), world.criticalPath(), world.balance());
        out.printf(Locale.ROOT, "beyond the slowest host: network and calls %.2f s, master %.2f s; %.1f MiB%n",
                world.waiting(), world.master(), world.bytes() / MEBIBYTE);
    }
}
