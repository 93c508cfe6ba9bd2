package radiosity.cli.render;

import java.io.PrintStream;
import java.util.Locale;
import radiosity.solution.HostStatistics;
import radiosity.solution.WorldStatistics;

/** Table of the work that each host has done ({@code --statistics}). */
public final class StatisticsTable {

    private static final double MEBIBYTE = 1 << 20;

    private final WorldStatistics world;

    public StatisticsTable(WorldStatistics world) {
        this.world = world;
    }

    public void print(PrintStream out) {
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
