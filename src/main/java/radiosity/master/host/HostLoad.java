package radiosity.master.host;

import java.util.concurrent.atomic.AtomicLong;
import radiosity.protocol.Reply;
import radiosity.solution.HostStatistics;

/**
 * The load of one host and the work that it has done. Time is modelled as if only hosts' processors took time: a step
 * begins when the host has done its previous step, and no earlier than the critical path at which the master gave it.
 */
public final class HostLoad {

    /** Number of elements that the host owns, by its last reply. */
    int elements;
    /** Number of steps done. */
    int rounds;
    /** Processor time of all steps, s. */
    double cpu;
    /** Modelled times at which the first step began and the last one ended, s. */
    private double begun = Double.NaN;
    private double reached;
    /** Wall time of the steps since the master last waited for all hosts, s. */
    public double sinceWait;
    /** Number of bytes sent to and received from the host; several threads add to the number. */
    final AtomicLong bytes = new AtomicLong();

    /** @param given latest modelled time that any host had reached when the master gave this step, s */
    public void add(Reply reply, double given) {
        if (rounds++ == 0) {
            begun = given;
        }
        cpu += reply.cpu();
        sinceWait += reply.seconds();
        reached = Math.max(reached, given) + reply.cpu();
        elements = reply.elements();
    }

    /** Modelled time at which the last step ended, s. */
    public double reached() {
        return reached;
    }

    /** @param end modelled time from which the host is not needed any more, s */
    public HostStatistics statistics(String name, String state, int blocks, double end) {
        return new HostStatistics(name, state, blocks, elements, rounds, cpu, end > begun ? 1 - cpu / (end - begun) : 0,
                bytes.get());
    }
}
