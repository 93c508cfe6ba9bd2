package radiosity.world;

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
import java.util.stream.Stream;

/**
 * Steps that hosts were given and have not all done, and answers that nobody has read yet. Nobody waits for the others
 * between steps, and what a host needs next is on its way while it computes.
 *
 * <p>Where a host is lost, what it said to steps that not all have answered does not count any more: whoever makes its
 * blocks again, says it again.
 */
final class StepsUnderWay {

    private final HostCalls calls;
    private final Seams seams;
    private final Deque<Step> steps = new ArrayDeque<>();
    /** Done, but not by all: the last ones, in their order. */
    private final List<Torn> torn = new ArrayList<>();
    private final Deque<Answered> unread = new ArrayDeque<>();
    /** When the last one was seen to be done, ns. */
    private long seen;

    StepsUnderWay(HostCalls calls, Seams seams) {
        this.calls = calls;
        this.seams = seams;
    }

    private record Step(Order order, long begin, double given, Map<Host, FutureTask<Reply>> running) { }

    /**
     * @param seconds wall time since it was begun, or the one before was done
     * @param given   see {@link Workload}
     * @param replies of hosts that were not lost, in their order
     */
    record Done(Order order, double seconds, double given, Map<Host, Reply> replies) { }

    /** What hosts have said to a step that all have done. */
    record Answered(Order order, List<byte[]> answers) { }

    /** What hosts have said that are still there; one that has made blocks again has said several things. */
    private record Torn(Order order, Map<Host, List<byte[]>> answers) { }

    /** How many not all hosts have done. */
    int count() {
        return steps.size();
    }

    /** How many answers to steps there are or will be. */
    int unread() {
        return unread.size() + (int) Stream.concat(torn.stream().map(Torn::order), steps.stream().map(Step::order))
                .filter(Order::isAnswered).count();
    }

    /**
     * @param now   ns
     * @param given see {@link Workload}
     */
    void begin(Collection<Host> hosts, Order order, byte[] bytes, long now, double given) {
        Map<Host, FutureTask<Reply>> running = new LinkedHashMap<>();
        for (Host host : hosts) {
            long number = host.nextRound();
            byte[] all = host.withTold(bytes);
            running.put(host, host.begin(() -> host.round(number, all)));
        }
        steps.add(new Step(order, now, given, running));
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
        seams.answers(first.order(), replies).forEach((host, answer) -> answers.get(host).add(answer));
        torn.add(new Torn(first.order(), answers));
        if (!calls.isAnyLost()) {
            mended();
        }
        return new Done(first.order(), seconds, first.given(), replies);
    }

    /** The first answer that was not read; all that was begun has to be done. */
    Answered next() {
        return unread.remove();
    }

    /** The answers to the step that was done last, which is then not to be read. */
    List<byte[]> last() {
        return unread.removeLast().answers();
    }

    /** Keeps what was asked about a step afterwards, to be read. */
    void add(Order step, List<byte[]> answers) {
        unread.add(new Answered(step, answers));
    }

    boolean isAnyAnswered() {
        return !unread.isEmpty();
    }

    /*---- Losing hosts ----*/

    /** What is torn is not to be read. */
    void forget() {
        torn.clear();
    }

    /** Takes out what is torn and has changed nothing, to be asked again; it came last. */
    List<Order> takeQuestions() {
        List<Order> questions = torn.stream().map(Torn::order).filter(order -> !order.changes()).toList();
        torn.removeIf(step -> !step.order().changes());
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
            if (step.order().isAnswered()) {
                unread.add(new Answered(step.order(),
                        step.answers().values().stream().flatMap(List::stream).toList()));
            }
        }
        torn.clear();
    }
}
