package radiosity.master;

import java.io.IOException;
import java.util.List;
import java.util.function.LongSupplier;
import radiosity.master.balance.Balance;
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
    private final HaloExchange points;
    private final LongSupplier clock;

    /** Who keeps count. */
    record Counts(ShotLog log, SharedTotals totals, RoundTimes times, Balance balance) { }

    /** @param clock for differences, ns */
    RemoteSteps(HostCalls calls, InFlightSteps underWay, Hosts hosts, Counts counts, HaloExchange points,
                LongSupplier clock) {
        this.calls = calls;
        this.underWay = underWay;
        this.hosts = hosts;
        this.counts = counts;
        this.points = points;
        this.clock = clock;
    }

    /** @param bytes what hosts are told of it */
    InFlightSteps.Given begin(Order step, byte[] bytes) {
        InFlightSteps.Given given = new InFlightSteps.Given(step);
        begin(given, bytes);
        return given;
    }

    private void begin(InFlightSteps.Given given, byte[] bytes) {
        underWay.begin(hosts.present(), given, bytes, clock.getAsLong(), counts.times.criticalPath());
        counts.totals.count(given.order());
        points.begun(given.order());
    }

    /** Does something that changes no element, and is not answered; nothing is under way. */
    void tell(Order order) {
        begin(order, order.encode());
        awaitAll(World.NOBODY);
        underWay.forget();
    }

    void awaitAll(World.StepTimes told) {
        while (underWay.count() > 0) {
            await(told);
        }
    }

    /** Waits until another one may be under way. */
    void keepUp(World.StepTimes told) {
        while (underWay.count() >= AHEAD) {
            await(told);
        }
    }

    /** All steps are done, by hosts that are there, on all blocks; questions are asked again. */
    void recover() throws IOException {
        if (calls.isAnyLost()) {
            awaitAll(World.NOBODY);
            List<InFlightSteps.Given> questions = underWay.takeQuestions();
            hosts.recover();
            points.forget();
            underWay.mended();
            for (InFlightSteps.Given question : questions) {
                begin(question, question.order().encode());
                keepUp(World.NOBODY);
            }
        }
    }

    /** Waits for the first step that is under way; who is lost then has lost nothing that the log does not have. */
    void await(World.StepTimes told) {
        InFlightSteps.Done step = underWay.await(clock);
        told.took(step.order().shots().size(), step.seconds());
        if (!calls.isAnyLost()) {
            hosts.haveDone();
            counts.times.add(step);
            counts.balance.add(step.replies(), step.order());
            points.done(step.order(), step.replies());
            if (step.order().changes()) {
                counts.log.took(step.replies().values().stream().mapToDouble(Reply::seconds).max().orElse(0));
            }
        }
    }
}
