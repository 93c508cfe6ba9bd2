package radiosity.master.host;

import java.util.concurrent.atomic.AtomicLong;
import radiosity.protocol.Reply;
import radiosity.solution.HostStatistics;

/**
 * What a host has to do and has done. Its time is counted as if nothing took any but the hosts' processors: a step
 * begins when the host has done the one before, and the master has seen done what it had seen when it gave the step.
 */
public final class HostLoad {

    /** Elements it owns, by the last reply. */
    int elements;
    int rounds;
    /** s. */
    double cpu;
    /** When its first step began and its last one ended, s. */
    private double begun = Double.NaN;
    private double reached;
    /** Time that it took since all were waited for, s. */
    public double sinceWait;
    /** Sent and received; several threads add to it. */
    final AtomicLong bytes = new AtomicLong();

    /** @param given what the slowest host had reached when the master gave this step */
    public void add(Reply reply, double given) {
        if (rounds++ == 0) {
            begun = given;
        }
        cpu += reply.cpu();
        sinceWait += reply.seconds();
        reached = Math.max(reached, given) + reply.cpu();
        elements = reply.elements();
    }

    public double reached() {
        return reached;
    }

    /** @param end when it was not needed any more, s */
    public HostStatistics statistics(String name, String state, int blocks, double end) {
        return new HostStatistics(name, state, blocks, elements, rounds, cpu, rounds == 0 ? 0 : 1 - cpu / (end - begun),
                bytes.get());
    }
}
