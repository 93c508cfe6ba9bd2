package radiosity.master;

import java.util.ArrayDeque;
import java.util.ArrayList;
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
import radiosity.rmi.RemotePartition;
import radiosity.solution.HostStatistics;
import radiosity.solution.WorldStatistics;
import radiosity.solver.World;

/**
 * The steps that hosts were given and that not all hosts have done yet; passes on the numbers of elements and the times
 * in the replies, and sums up the times of the steps that are done. No host waits for the others between steps, and the
 * next step is on its way to a host while the host computes. The answers to a step are read by the caller who began the
 * step, see {@link Step}.
 *
 * <p>If a host is lost, its answers to steps that not all hosts have answered are dropped: the hosts that take over its
 * blocks answer again.
 */
final class InFlightSteps {

    /** Largest number of steps in flight, so of steps that a fast host may be ahead of a slow one. */
    static final int AHEAD = RemotePartition.MOST_IN_FLIGHT;

    private final HostCalls calls;
    private final ShotLog log;
    private final BlockAssignment assignment;
    private final HaloExchange halo;
    private final List<Host> present;
    private final Deque<Step> steps = new ArrayDeque<>();
    /** The last steps with a question, in their order, to which answers are missing as hosts were lost. */
    private final List<Step> partlyAnswered = new ArrayList<>();
    private final LongSupplier clock;
    /** Times at which the calculation began and at which the last step was found done, ns. */
    private final long opened;
    private long seen;
    /** Number of the steps that are done, and their times, see {@link WorldStatistics}; s. */
    private int rounds;
    private double criticalPath;
    private double cpu;
    private double slowest;
    private double wall;
    /** Wall time of the first of the two steps of an order for ghost values, s. */
    private double firstPart;

    /**
     * @param present the hosts in use, which may change between steps; not modified
     * @param clock   clock of which only differences are used, ns
     */
    InFlightSteps(HostCalls calls, ShotLog log, BlockAssignment assignment, HaloExchange halo, List<Host> present,
                  LongSupplier clock) {
        this.calls = calls;
        this.log = log;
        this.assignment = assignment;
        this.halo = halo;
        this.present = present;
        this.clock = clock;
        opened = clock.getAsLong();
    }

    /** An order that hosts were given, and their replies. */
    static final class Step {

        private final Order order;
        private final int shots;
        private long begin;
        /** The critical path when the step was given to hosts, s; see {@link HostLoad}. */
        private double given;
        private Map<Host, FutureTask<Reply>> running;
        /** Wall time since this step was begun, or since the step before was done if that was later, s. */
        private double seconds;
        private Map<Host, Reply> replies;
        private final Map<Host, List<byte[]>> answers = new LinkedHashMap<>();
        private boolean isAnswered;

        /** @param shots number of shots gathered in the step */
        Step(Order order, int shots) {
            this.order = order;
            this.shots = shots;
        }

        Order order() {
            return order;
        }

        /** Whether all hosts that are not lost have done the step. */
        boolean isDone() {
            return replies != null;
        }

        /** Wall time of the slowest host, s. */
        private double slowest() {
            return replies.values().stream().mapToDouble(Reply::seconds).max().orElse(0);
        }

        /** The replies of the hosts that are not lost, in the order of hosts; null before the step is done. */
        Map<Host, Reply> replies() {
            return replies;
        }

        /** Whether the answers for all blocks have come. */
        boolean isAnswered() {
            return isAnswered;
        }

        /** The answers of all hosts, in their order; several of a host that has taken over blocks. */
        List<byte[]> answers() {
            return answers.values().stream().flatMap(List::stream).toList();
        }
    }

    /** Whether some hosts have not done all steps. */
    boolean isAny() {
        return !steps.isEmpty();
    }

    /** Number of the steps that are done. */
    int done() {
        return rounds;
    }

    /**
     * Gives an order, encoded as {@code bytes}, to all hosts, each of which receives its ghost values, too;
     * {@code times} receives the times of steps found done.
     */
    Step begin(Order order, byte[] bytes, World.StepTimes times) {
        return begin(order, order.shots().size(), bytes, times);
    }

    /** Has hosts gather at the vertices at which the last order, one for ghost values, did not gather. */
    Step beginRest(int shots, World.StepTimes times) {
        Order rest = Order.plain(Order.Kind.REST, Order.Question.NOTHING);
        return begin(rest, shots, rest.encode(), times);
    }

    private Step begin(Order order, int shots, byte[] bytes, World.StepTimes times) {
        while (steps.size() >= AHEAD) {
            await(times);
        }
        Step step = new Step(order, shots);
        step.running = new LinkedHashMap<>();
        step.begin = clock.getAsLong();
        step.given = criticalPath;
        for (Host host : present) {
            long number = host.nextRound();
            byte[] all = host.withGhostValues(bytes);
            step.running.put(host, host.begin(() -> host.round(number, all)));
        }
        steps.add(step);
        log.count(order);
        halo.begun(order);
        return step;
    }

    /** Carries out an order that changes no element and asks for no answer, while no step is in flight. */
    Step carryOut(Order order) {
        Step step = begin(order, order.encode(), World.IGNORE_TIMES);
        awaitAll(World.IGNORE_TIMES);
        return step;
    }

    void awaitAll(World.StepTimes times) {
        while (isAny()) {
            await(times);
        }
    }

    /** Waits until all hosts have done, or are lost in, the first step; the log has the step for hosts to come. */
    void await(World.StepTimes times) {
        Step first = steps.remove();
        first.replies = calls.await(first.running);
        first.running = null;
        long now = clock.getAsLong();
        first.seconds = (now - Math.max(seen, first.begin)) * 1e-9;
        seen = now;
        if (first.order.isAnswered()) {
            first.replies.forEach((host, reply) -> first.answers.put(host, new ArrayList<>(List.of(reply.answer()))));
            partlyAnswered.add(first);
        } else if (first.order.givesGhosts()) {
            firstPart = first.seconds;
        } else {
            times.took(first.shots, firstPart + first.seconds);
            firstPart = 0;
        }
        if (!calls.isAnyLost()) {
            allAnswered();
            count(first);
            assignment.add(first.replies, first.shots);
            halo.done(first);
            log.took(first.slowest());
        }
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

    /** The latest time that a host has reached, s; see {@link HostLoad}. */
    double criticalPath() {
        return criticalPath;
    }

    WorldStatistics statistics(List<HostStatistics> hosts) {
        double all = (clock.getAsLong() - opened) * 1e-9;
        return new WorldStatistics(hosts, rounds, criticalPath, cpu, wall - slowest, all - wall);
    }

    /*---- Losing hosts ----*/

    /** Drops the answers of a lost host to steps that not all hosts have answered. */
    void lose(Host host) {
        partlyAnswered.forEach(step -> step.answers.remove(host));
    }

    /** @param answers each host's answers, for the blocks it took over, to the questions that lack answers, in order */
    void add(Map<Host, List<byte[]>> answers) {
        answers.forEach((host, again) -> {
            Iterator<byte[]> next = again.iterator();
            partlyAnswered.forEach(step -> step.answers.computeIfAbsent(host, h -> new ArrayList<>()).add(next.next()));
        });
    }

    /** Notes that the answers to all steps that are done have come. */
    void allAnswered() {
        for (Step step : partlyAnswered) {
            step.isAnswered = true;
            log.remove(step.order);
        }
        partlyAnswered.clear();
    }
}
