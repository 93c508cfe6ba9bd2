package radiosity.world;

/** What a host has to do and has done. */
final class Workload {

    /** Elements it owns, by the last reply. */
    int elements;
    int rounds;
    /** s. */
    double cpu;
    /** Processor time of the slowest host in the same rounds, s. */
    double slowest;
    volatile long bytes;

    void add(Reply reply, double slowestOfRound) {
        rounds++;
        cpu += reply.cpu();
        slowest += slowestOfRound;
        elements = reply.elements();
    }

    HostStatistics statistics(String name, String state, int blocks) {
        return new HostStatistics(name, state, blocks, elements, rounds, cpu, slowest == 0 ? 0 : 1 - cpu / slowest,
                bytes);
    }
}
