package radiosity.solution;

import java.util.List;

/**
 * Work done by a world on several hosts.
 *
 * @param hosts        one per host that takes or took part
 * @param rounds       number of orders to all hosts, questions included
 * @param criticalPath time in which the hosts would be done if only their processors took time, s
 * @param cpu          processor time of all hosts, s
 * @param waiting      wall time of orders beyond the time of the slowest host: network and calls, s
 * @param master       wall time between orders: the master's own work, s
 */
public record WorldStatistics(List<HostStatistics> hosts, int rounds, double criticalPath, double cpu, double waiting,
                              double master) {

    /** Largest processor time of a host relative to the mean over all hosts; 1 where no host has worked. */
    public double balance() {
        double most = hosts.stream().mapToDouble(HostStatistics::cpu).max().orElse(0);
        return cpu == 0 ? 1 : most * hosts.size() / cpu;
    }

    /** Number of bytes sent to hosts and received from hosts. */
    public long bytes() {
        return hosts.stream().mapToLong(HostStatistics::bytes).sum();
    }
}
