package radiosity.master;

import java.io.IOException;
import radiosity.master.InFlightSteps.Step;
import radiosity.master.host.HostCalls;
import radiosity.protocol.Order;
import radiosity.solver.World;

/**
 * Gives steps to all hosts and waits for them, whichever hosts are lost meanwhile; passes on what the replies say about
 * elements and times.
 */
final class RemoteSteps {

    /** One that is done, others that are on their way: how far a fast host may be ahead of a slow one. */
    static final int AHEAD = 4;

    private final HostCalls calls;
    private final InFlightSteps underWay;
    private final Hosts hosts;
    private final ShotLog log;
    private final BlockAssignment assignment;
    private final HaloExchange halo;
    /** Wall time of the first part of a step that is done in two, s. */
    private double firstPart;

    RemoteSteps(Hosts.Work work, Hosts hosts, HaloExchange halo) {
        calls = work.calls();
        underWay = work.underWay();
        log = work.log();
        assignment = work.assignment();
        this.hosts = hosts;
        this.halo = halo;
    }

    /** @param bytes what hosts receive of it */
    Step begin(Order order, byte[] bytes, World.StepTimes times) {
        return begin(order, order.shots().size(), bytes, times);
    }

    /** The rest of an order that was begun where hosts need each other's values. */
    Step beginRest(int shots, World.StepTimes times) {
        Order rest = Order.plain(Order.Kind.REST, Order.Question.NOTHING);
        return begin(rest, shots, rest.encode(), times);
    }

    private Step begin(Order order, int shots, byte[] bytes, World.StepTimes times) {
        while (underWay.count() >= AHEAD) {
            await(times);
        }
        Step step = new Step(order, shots);
        underWay.begin(hosts.present(), step, bytes);
        log.count(order);
        halo.begun(order);
        return step;
    }

    /** Carries out an order that changes no element and is not answered, while nothing is under way. */
    Step carryOut(Order order) {
        Step step = begin(order, order.encode(), World.NOBODY);
        awaitAll(World.NOBODY);
        return step;
    }

    void awaitAll(World.StepTimes times) {
        while (underWay.count() > 0) {
            await(times);
        }
    }

    /** All steps are done, by hosts that are there, on all blocks. */
    void recover() throws IOException {
        if (calls.isAnyLost()) {
            awaitAll(World.NOBODY);
            hosts.recover();
            halo.forget();
            underWay.allAnswered();
        }
    }

    /** Waits for the first step that is under way; what a host computes that is lost then, the log has. */
    void await(World.StepTimes times) {
        Step step = underWay.await();
        if (step.order().givesGhosts()) {
            firstPart = step.seconds();
        } else if (!step.order().isAnswered()) {
            times.took(step.shots(), firstPart + step.seconds());
            firstPart = 0;
        }
        if (!calls.isAnyLost()) {
            hosts.haveDone();
            assignment.add(step.replies(), step.shots());
            halo.done(step);
            log.took(step.slowest());
        }
    }
}
