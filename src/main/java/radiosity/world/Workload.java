package radiosity.world;

/** What a host has to do and has done. */
final class Workload {

    /** Elements it owns, by the last reply. */
    int elements;
    int rounds;
    /** s. */
    double cpu;
    /** Processor time of the slowest host between two times when all waited for it, s. */
    private double slowest;
    /** Since then: processor time, and time; s. */
    double sinceWait;
    double secondsSinceWait;
    volatile long bytes;

    void add(Reply reply) {
        rounds++;
        cpu += reply.cpu();
        sinceWait += reply.cpu();
        secondsSinceWait += reply.seconds();
        elements = reply.elements();
    }

    /** @param ofSlowest processor time of the slowest host since it was waited for before, s */
    void waited(double ofSlowest) {
        slowest += ofSlowest;
        sinceWait = 0;
        secondsSinceWait = 0;
    }

    HostStatistics statistics(String name, String state, int blocks) {
        return new HostStatistics(name, state, blocks, elements, rounds, cpu, slowest == 0 ? 0 : 1 - cpu / slowest,
                bytes);
    }
}
