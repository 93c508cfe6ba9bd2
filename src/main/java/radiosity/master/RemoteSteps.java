package radiosity.master;

import java.io.IOException;
import radiosity.master.InFlightSteps.Step;
import radiosity.master.host.HostCalls;
import radiosity.protocol.Order;
import radiosity.solver.World;

/**
 * Gives steps to all hosts and waits until they are done, also if hosts are lost meanwhile; passes on the numbers of
 * elements and the times in the replies.
 */
final class RemoteSteps {

    /** Largest number of steps in flight, so of steps that a fast host may be ahead of a slow one. */
    static final int AHEAD = 4;

    private final HostCalls calls;
    private final InFlightSteps underWay;
    private final Hosts hosts;
    private final ShotLog log;
    private final BlockAssignment assignment;
    private final HaloExchange halo;
    /** Wall time of the first of the two steps of an order for ghost values, s. */
    private double firstPart;

    RemoteSteps(Hosts.Work work, Hosts hosts, HaloExchange halo) {
        calls = work.calls();
        underWay = work.underWay();
        log = work.log();
        assignment = work.assignment();
        this.hosts = hosts;
        this.halo = halo;
    }

    /** Gives an order, encoded as {@code bytes}, to all hosts; {@code times} receives the times of steps found done. */
    Step begin(Order order, byte[] bytes, World.StepTimes times) {
        return begin(order, order.shots().size(), bytes, times);
    }

    /** Has hosts gather at the vertices at which the last order, one for ghost values, did not gather. */
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

    /** Carries out an order that changes no element and asks for no answer, while no step is in flight. */
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

    /** Where hosts are lost, waits for all steps in flight, and has other hosts rebuild the blocks of the lost ones. */
    void recover() throws IOException {
        if (calls.isAnyLost()) {
            awaitAll(World.NOBODY);
            hosts.recover();
            halo.forget();
            underWay.allAnswered();
        }
    }

    /** Waits for the first step in flight; if a host is lost meanwhile, the log has the step for {@link #recover}. */
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
