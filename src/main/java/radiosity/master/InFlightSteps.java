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
 * next is on its way while it computes. The answers to a step belong to the caller who gave it, see {@link Given}.
 *
 * <p>Where a host is lost, what it said to steps that not all have answered does not count any more: whoever makes its
 * blocks again, says it again.
 */
final class InFlightSteps {

    private final HostCalls calls;
    private final Seams seams;
    private final Deque<Step> steps = new ArrayDeque<>();
    /** Done, but not by all: the last ones, in their order. */
    private final List<Torn> torn = new ArrayList<>();
    /** When the last one was seen to be done, ns. */
    private long seen;

    InFlightSteps(HostCalls calls, Seams seams) {
        this.calls = calls;
        this.seams = seams;
    }

    /** An order that hosts were given, and what all of them have answered, once they have. */
    static final class Given {

        private final Order order;
        private List<byte[]> answers;

        Given(Order order) {
            this.order = order;
        }

        Order order() {
            return order;
        }

        /** Whether all hosts have answered. */
        boolean isAnswered() {
            return answers != null;
        }

        /** One or more per host, in the order of hosts; null before all have answered. */
        List<byte[]> answers() {
            return answers;
        }
    }

    private record Step(Given what, long begin, double given, Map<Host, FutureTask<Reply>> running) { }

    /**
     * @param seconds wall time since it was begun, or the one before was done
     * @param given   see {@link HostLoad}
     * @param replies of hosts that were not lost, in their order
     */
    record Done(Order order, double seconds, double given, Map<Host, Reply> replies) { }

    /** What hosts have said that are still there; one that has made blocks again has said several things. */
    private record Torn(Given what, Map<Host, List<byte[]>> answers) { }

    /** How many not all hosts have done. */
    int count() {
        return steps.size();
    }

    /**
     * @param now   ns
     * @param given see {@link HostLoad}
     */
    void begin(Collection<Host> hosts, Given what, byte[] bytes, long now, double given) {
        Map<Host, FutureTask<Reply>> running = new LinkedHashMap<>();
        for (Host host : hosts) {
            long number = host.nextRound();
            byte[] all = host.withTold(bytes);
            running.put(host, host.begin(() -> host.round(number, all)));
        }
        steps.add(new Step(what, now, given, running));
    }

    /** Waits for the first one. */
    Done await(LongSupplier clock) {
        Step first = steps.remove();
        Map<Host, Reply> replies = calls.await(first.running());
        long now = clock.getAsLong();
        double seconds = (now - Math.max(seen, first.begin())) * 1e-9;
        seen = now;
        Map<Host, List<byte[]>> answers = new LinkedHashMap<>();
        replies.forEach((host, reply) -> answers.put(host, new ArrayList<>(List.of(reply.answer()))));
        seams.answers(first.what().order(), replies).forEach((host, answer) -> answers.get(host).add(answer));
        torn.add(new Torn(first.what(), answers));
        if (!calls.isAnyLost()) {
            mended();
        }
        return new Done(first.what().order(), seconds, first.given(), replies);
    }

    /*---- Losing hosts ----*/

    /** Nobody waits for the answers to what is torn. */
    void forget() {
        torn.clear();
    }

    /** Takes out what is torn and has changed nothing, to be asked again; it came last. */
    List<Given> takeQuestions() {
        List<Given> questions = torn.stream().map(Torn::what).filter(what -> !what.order().changes()).toList();
        torn.removeIf(step -> !step.what().order().changes());
        return questions;
    }

    /** Of how many steps answers are missing. */
    int torn() {
        return torn.size();
    }

    void lose(Host host) {
        torn.forEach(step -> step.answers().remove(host));
    }

    /** @param answers of each host that has done the torn steps again on blocks that were lost, in their order */
    void add(Map<Host, List<byte[]>> answers) {
        answers.forEach((host, again) -> {
            Iterator<byte[]> next = again.iterator();
            torn.forEach(step -> step.answers().computeIfAbsent(host, h -> new ArrayList<>()).add(next.next()));
        });
    }

    /** All hosts are there that have something to say. */
    void mended() {
        for (Torn step : torn) {
            step.what().answers = step.answers().values().stream().flatMap(List::stream).toList();
        }
        torn.clear();
    }
}
