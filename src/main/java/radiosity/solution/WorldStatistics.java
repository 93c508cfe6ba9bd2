package radiosity.solution;

import java.util.List;

/**
 * What a world on several hosts has done.
 *
 * @param hosts        one per host that is or was there
 * @param rounds       orders to all hosts, questions among them
 * @param criticalPath processor time of the slowest host, where one waits for another, s
 * @param cpu          processor time of all hosts, s
 * @param waiting      wall time that rounds took beyond the slowest host's own: network and calls, s
 * @param master       wall time between rounds: the master's own work, s
 */
public record WorldStatistics(List<HostStatistics> hosts, int rounds, double criticalPath, double cpu, double waiting,
                              double master) {

    /** Largest processor time of a host, relative to the mean. */
    public double balance() {
        double most = hosts.stream().mapToDouble(HostStatistics::cpu).max().orElse(0);
        return cpu == 0 ? 1 : most * hosts.size() / cpu;
    }

    /** Sent and received. */
    public long bytes() {
        return hosts.stream().mapToLong(HostStatistics::bytes).sum();
    }
}
