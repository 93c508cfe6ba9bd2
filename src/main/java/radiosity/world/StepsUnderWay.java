package radiosity.world;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.FutureTask;
import java.util.function.LongSupplier;

/**
 * Steps that hosts were given and have not all done. Steps of a round do not read each other's results, so no host
 * waits for the others between them, and what one needs is on its way while it does another.
 */
final class StepsUnderWay {

    private final HostCalls calls;
    private final Deque<Step> steps = new ArrayDeque<>();
    /** When the last one was seen to be done, ns. */
    private long seen;

    StepsUnderWay(HostCalls calls) {
        this.calls = calls;
    }

    private record Step(Order order, long begin, Map<Host, FutureTask<Reply>> running) { }

    /** @param replies of hosts that were not lost, in their order */
    record Done(Order order, double seconds, Map<Host, Reply> replies) { }

    int count() {
        return steps.size();
    }

    /** @param now ns */
    void begin(Collection<Host> hosts, Order order, byte[] bytes, long now) {
        Map<Host, FutureTask<Reply>> running = new LinkedHashMap<>();
        for (Host host : hosts) {
            long number = host.nextRound();
            running.put(host, host.begin(() -> host.round(number, bytes)));
        }
        steps.add(new Step(order, now, running));
    }

    /** Waits for the first one. */
    Done await(LongSupplier clock) {
        Step first = steps.remove();
        Map<Host, Reply> replies = calls.await(first.running());
        long now = clock.getAsLong();
        double seconds = (now - Math.max(seen, first.begin())) * 1e-9;
        seen = now;
        return new Done(first.order(), seconds, replies);
    }
}
