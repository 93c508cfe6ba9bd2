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
import radiosity.solution.HostStatistics;
import radiosity.solution.WorldStatistics;

/**
 * Steps that hosts were given and have not all done, and what those took that are done. No host waits for the others
 * between steps, and what a host needs next is on its way while it computes. The answers to a step belong to the caller
 * who gave it, see {@link Step}.
 *
 * <p>Where a host is lost, its answers to steps that not all hosts have answered do not count any more: the host that
 * takes over its blocks answers again.
 */
final class InFlightSteps {

    private final HostCalls calls;
    private final ShotLog log;
    private final Deque<Step> steps = new ArrayDeque<>();
    /** Questions that some hosts have answered, and others were lost: the last ones, in their order. */
    private final List<Step> partlyAnswered = new ArrayList<>();
    private final LongSupplier clock;
    /** When the calculation began, and when the last step was seen to be done, ns. */
    private final long opened;
    private long seen;
    /** Sums over the steps that are done; times in s. */
    private int rounds;
    private double criticalPath;
    private double cpu;
    private double slowest;
    private double wall;

    /** @param clock for differences, ns */
    InFlightSteps(HostCalls calls, ShotLog log, LongSupplier clock) {
        this.calls = calls;
        this.log = log;
        this.clock = clock;
        opened = clock.getAsLong();
    }

    /** An order that hosts were given, and what they have replied. */
    static final class Step {

        private final Order order;
        private final int shots;
        private long begin;
        /** What the slowest host had reached when this step was begun, s; see {@link HostLoad}. */
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

        /** Whether all hosts that are not lost have done it. */
        boolean isDone() {
            return replies != null;
        }

        /** What the slowest host took, s. */
        double slowest() {
            return replies.values().stream().mapToDouble(Reply::seconds).max().orElse(0);
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

    /** @param bytes what each host receives, its ghost values besides */
    void begin(Collection<Host> hosts, Step step, byte[] bytes) {
        step.running = new LinkedHashMap<>();
        step.begin = clock.getAsLong();
        step.given = criticalPath;
        for (Host host : hosts) {
            long number = host.nextRound();
            byte[] all = host.withGhostValues(bytes);
            step.running.put(host, host.begin(() -> host.round(number, all)));
        }
        steps.add(step);
    }

    /** Waits for the first one. */
    Step await() {
        Step first = steps.remove();
        first.replies = calls.await(first.running);
        first.running = null;
        long now = clock.getAsLong();
        first.seconds = (now - Math.max(seen, first.begin)) * 1e-9;
        seen = now;
        if (first.order.isAnswered()) {
            first.replies.forEach((host, reply) -> first.answers.put(host, new ArrayList<>(List.of(reply.answer()))));
            partlyAnswered.add(first);
        }
        if (!calls.isAnyLost()) {
            allAnswered();
            count(first);
        }
        return first;
    }

    private void count(Step done) {
        rounds++;
        done.replies.forEach((host, reply) -> {
            host.load.add(reply, done.given);
            criticalPath = Math.max(criticalPath, host.load.reached());
        });
        cpu += done.replies.values().stream().mapToDouble(Reply::cpu).sum();
        slowest += done.slowest();
        wall += done.seconds;
    }

    /** What the slowest host has reached, s; see {@link HostLoad}. */
    double criticalPath() {
        return criticalPath;
    }

    WorldStatistics statistics(List<HostStatistics> hosts) {
        double all = (clock.getAsLong() - opened) * 1e-9;
        return new WorldStatistics(hosts, rounds, criticalPath, cpu, wall - slowest, all - wall);
    }

    /*---- Losing hosts ----*/

    void lose(Host host) {
        partlyAnswered.forEach(step -> step.answers.remove(host));
    }

    /** @param answers of each host to the partly answered questions, in their order, on blocks it has taken over */
    void add(Map<Host, List<byte[]>> answers) {
        answers.forEach((host, again) -> {
            Iterator<byte[]> next = again.iterator();
            partlyAnswered.forEach(step -> step.answers.computeIfAbsent(host, h -> new ArrayList<>()).add(next.next()));
        });
    }

    /** No host is missing whose answers are. */
    void allAnswered() {
        for (Step step : partlyAnswered) {
            step.isAnswered = true;
            log.remove(step.order);
        }
        partlyAnswered.clear();
    }
}
