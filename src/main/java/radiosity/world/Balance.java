package radiosity.world;

import java.util.List;
import java.util.Map;

/** How fast hosts are, and whether moving blocks pays. */
final class Balance {

    /** Weight of the last round in the moving average of a host's speed. */
    private static final double NEW = 0.3;
    /** Rounds with fewer seconds say nothing about speed. */
    private static final double LEAST_SECONDS = 0.005;
    /** Blocks move when hosts have waited for each other so many times as long as a move takes. */
    private static final double PATIENCE = 3;
    private static final double FIRST_COST = 0.05;

    private final Cadence waiting = new Cadence(PATIENCE, FIRST_COST);

    /**
     * After a round.
     *
     * @param gathering whether all elements were at work, so that it shows how fast a host is
     */
    void add(Map<Host, Reply> replies, boolean gathering) {
        double cpu = replies.values().stream().mapToDouble(Reply::cpu).max().orElse(0);
        double slowest = replies.values().stream().mapToDouble(Reply::seconds).max().orElse(0);
        double mean = replies.values().stream().mapToDouble(Reply::seconds).average().orElse(0);
        waiting.add(slowest - mean);
        replies.forEach((host, reply) -> {
            host.load.add(reply, cpu);
            if (gathering && slowest > LEAST_SECONDS && host.load.elements > 0 && reply.seconds() > 0) {
                learn(host, host.load.elements / reply.seconds());
            }
        });
    }

    private static void learn(Host host, double speed) {
        host.speed = host.measured ? (1 - NEW) * host.speed + NEW * speed : speed;
        host.measured = true;
    }

    /** What to expect of a newcomer: as much per thread as of the others. */
    double speed(List<Host> others, Host newcomer) {
        return others.stream().mapToDouble(host -> host.speed).average().orElse(newcomer.speed);
    }

    boolean isDue() {
        return waiting.isDue();
    }

    void moved(double seconds) {
        waiting.done(seconds);
    }
}
