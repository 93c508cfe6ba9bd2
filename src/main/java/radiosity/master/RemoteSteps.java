package radiosity.master;

import java.io.IOException;
import java.util.function.LongSupplier;
import radiosity.master.InFlightSteps.Step;
import radiosity.master.host.HostCalls;
import radiosity.protocol.Order;
import radiosity.protocol.Reply;
import radiosity.solver.World;

/**
 * Gives steps to all hosts and waits for them, whoever is lost meanwhile; whoever keeps count of what hosts do is told
 * of every one that is done.
 */
final class RemoteSteps {

    /** One that is done, others that are on their way: how far a fast host may be ahead of a slow one. */
    static final int AHEAD = 4;

    private final HostCalls calls;
    private final InFlightSteps underWay;
    private final Hosts hosts;
    private final Counts counts;
    private final HaloExchange halo;
    private final LongSupplier clock;
    /** Wall time of the first part of a step that is done in two, s. */
    private double firstPart;

    /** Who keeps count. */
    record Counts(ShotLog log, SharedTotals totals, RoundTimes times, BlockAssignment assignment) { }

    /** @param clock for differences, ns */
    RemoteSteps(HostCalls calls, InFlightSteps underWay, Hosts hosts, Counts counts, HaloExchange halo,
                LongSupplier clock) {
        this.calls = calls;
        this.underWay = underWay;
        this.hosts = hosts;
        this.counts = counts;
        this.halo = halo;
        this.clock = clock;
    }

    /** @param bytes what hosts are told of it */
    Step begin(Order order, byte[] bytes, World.StepTimes told) {
        return begin(order, order.shots().size(), bytes, told);
    }

    /** The rest of an order that was begun where hosts need each other's values. */
    Step beginRest(int shots, World.StepTimes told) {
        Order rest = Order.plain(Order.Kind.REST, Order.Question.NOTHING);
        return begin(rest, shots, rest.encode(), told);
    }

    private Step begin(Order order, int shots, byte[] bytes, World.StepTimes told) {
        while (underWay.count() >= AHEAD) {
            await(told);
        }
        Step step = new Step(order, shots);
        underWay.begin(hosts.present(), step, bytes, clock.getAsLong(), counts.times.criticalPath());
        counts.totals.count(order);
        halo.begun(order);
        return step;
    }

    /** Does something that changes no element, and is not answered; nothing is under way. */
    Step tell(Order order) {
        Step step = begin(order, order.encode(), World.NOBODY);
        awaitAll(World.NOBODY);
        return step;
    }

    void awaitAll(World.StepTimes told) {
        while (underWay.count() > 0) {
            await(told);
        }
    }

    /** All steps are done, by hosts that are there, on all blocks. */
    void recover() throws IOException {
        if (calls.isAnyLost()) {
            awaitAll(World.NOBODY);
            hosts.recover();
            halo.forget();
            underWay.mended();
        }
    }

    /** Waits for the first step that is under way; who is lost then has lost nothing that the log does not have. */
    void await(World.StepTimes told) {
        Step step = underWay.await(clock);
        if (step.order().givesGhosts()) {
            firstPart = step.seconds();
        } else if (!step.order().isAnswered()) {
            told.took(step.shots(), firstPart + step.seconds());
            firstPart = 0;
        }
        if (!calls.isAnyLost()) {
            hosts.haveDone();
            counts.times.add(step);
            counts.assignment.add(step.replies(), step.shots());
            halo.done(step);
            counts.log.took(step.replies().values().stream().mapToDouble(Reply::seconds).max().orElse(0));
        }
    }
}
