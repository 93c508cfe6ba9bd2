package radiosity.master;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.FutureTask;
import java.util.function.LongSupplier;
import radiosity.master.host.Host;
import radiosity.master.host.HostCalls;
import radiosity.master.host.HostLoad;
import radiosity.protocol.Order;
import radiosity.protocol.Reply;

/**
 * Steps that hosts were given and have not all done. Nobody waits for the others between steps, and what a host needs
 * next is on its way while it computes. The answers to a step belong to the caller who gave it, see {@link Step}.
 *
 * <p>Where a host is lost, its answers to steps that not all have answered do not count any more: whoever makes its
 * blocks again, answers again.
 */
final class InFlightSteps {

    private final HostCalls calls;
    private final ShotLog log;
    private final Deque<Step> steps = new ArrayDeque<>();
    /** Questions that were answered, but not by all hosts: the last ones, in their order. */
    private final List<Step> torn = new ArrayList<>();
    /** When the last step was seen to be done, ns. */
    private long seen;

    InFlightSteps(HostCalls calls, ShotLog log) {
        this.calls = calls;
        this.log = log;
    }

    /** An order that hosts were given, and what they have replied. */
    static final class Step {

        private final Order order;
        private final int shots;
        private long begin;
        private double given;
        private Map<Host, FutureTask<Reply>> running;
        private double seconds;
        private Map<Host, Reply> replies;
        private final Map<Host, List<byte[]>> answers = new LinkedHashMap<>();
        private boolean isAnswered;

        /** @param shots that are gathered in this step */
        Step(Order order, int shots) {
            this.order = order;
            this.shots = shots;
        }

        Order order() {
            return order;
        }

        int shots() {
            return shots;
        }

        /** Wall time since it was begun, or the one before was done. */
        double seconds() {
            return seconds;
        }

        /** What the slowest host had reached when this step was begun, s; see {@link HostLoad}. */
        double given() {
            return given;
        }

        /** Whether all hosts that are not lost have done it. */
        boolean isDone() {
            return replies != null;
        }

        /** Of hosts that were not lost, in their order. */
        Map<Host, Reply> replies() {
            return replies;
        }

        /** Whether an answer for every block is there. */
        boolean isAnswered() {
            return isAnswered;
        }

        /** One or more per host, in the order of hosts. */
        List<byte[]> answers() {
            return answers.values().stream().flatMap(List::stream).toList();
        }
    }

    /** How many not all hosts have done. */
    int count() {
        return steps.size();
    }

    /**
     * @param now   ns
     * @param given see {@link HostLoad}
     */
    void begin(Collection<Host> hosts, Step step, byte[] bytes, long now, double given) {
        step.running = new LinkedHashMap<>();
        step.begin = now;
        step.given = given;
        for (Host host : hosts) {
            long number = host.nextRound();
            byte[] all = host.withTold(bytes);
            step.running.put(host, host.begin(() -> host.round(number, all)));
        }
        steps.add(step);
    }

    /** Waits for the first one. */
    Step await(LongSupplier clock) {
        Step first = steps.remove();
        first.replies = calls.await(first.running);
        first.running = null;
        long now = clock.getAsLong();
        first.seconds = (now - Math.max(seen, first.begin)) * 1e-9;
        seen = now;
        if (first.order.isAnswered()) {
            first.replies.forEach((host, reply) -> first.answers.put(host, new ArrayList<>(List.of(reply.answer()))));
            torn.add(first);
        }
        if (!calls.isAnyLost()) {
            mended();
        }
        return first;
    }

    /*---- Losing hosts ----*/

    void lose(Host host) {
        torn.forEach(step -> step.answers.remove(host));
    }

    /** @param answers of each host that has answered the torn questions again on lost blocks, in their order */
    void add(Map<Host, List<byte[]>> answers) {
        answers.forEach((host, again) -> {
            Iterator<byte[]> next = again.iterator();
            torn.forEach(step -> step.answers.computeIfAbsent(host, h -> new ArrayList<>()).add(next.next()));
        });
    }

    /** All hosts are there that have something to say. */
    void mended() {
        for (Step step : torn) {
            step.isAnswered = true;
            log.remove(step.order);
        }
        torn.clear();
    }
}
