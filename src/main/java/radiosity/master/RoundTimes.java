package radiosity.master;

import java.util.Collection;
import java.util.List;
import java.util.function.LongSupplier;
import radiosity.master.host.HostLoad;
import radiosity.protocol.Reply;
import radiosity.solution.HostStatistics;
import radiosity.solution.WorldStatistics;

/** Sums over the rounds of a {@link RemoteWorld}. */
final class RoundTimes {

    private final LongSupplier clock;
    private final long begin;
    private int rounds;
    private double criticalPath;
    private double cpu;
    private double slowest;
    private double wall;

    /** @param clock ns */
    RoundTimes(LongSupplier clock) {
        this.clock = clock;
        begin = clock.getAsLong();
    }

    /** A step is done. */
    void add(InFlightSteps.Step step) {
        Collection<Reply> replies = step.replies().values();
        rounds++;
        step.replies().forEach((host, reply) -> {
            host.load.add(reply, step.given());
            criticalPath = Math.max(criticalPath, host.load.reached());
        });
        cpu += replies.stream().mapToDouble(Reply::cpu).sum();
        slowest += replies.stream().mapToDouble(Reply::seconds).max().orElse(0);
        wall += step.seconds();
    }

    /** What the slowest host has reached, s; see {@link HostLoad}. */
    double criticalPath() {
        return criticalPath;
    }

    WorldStatistics statistics(List<HostStatistics> hosts) {
        double all = (clock.getAsLong() - begin) * 1e-9;
        return new WorldStatistics(hosts, rounds, criticalPath, cpu, wall - slowest, all - wall);
    }
}
