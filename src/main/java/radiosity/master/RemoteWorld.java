package radiosity.master;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import radiosity.master.InFlightSteps.Step;
import radiosity.master.host.HostCalls;
import radiosity.master.host.Link;
import radiosity.master.host.NoWorkerException;
import radiosity.master.host.RmiLink;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.protocol.SceneBytes;
import radiosity.protocol.Shot;
import radiosity.protocol.Wire;
import radiosity.rmi.HostAddress;
import radiosity.rmi.HostKey;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.solution.WorldStatistics;
import radiosity.solver.Planner;
import radiosity.solver.World;

/**
 * A world whose elements are on other machines (section 4.5.3 of the paper).
 *
 * <p>Each host owns some blocks. What is done in a round goes into a log before any host receives it; from a block's
 * state at the last checkpoint and that log any other host makes the block again, to the same bits. So a host may be
 * lost at any time, blocks may move, and with no host left the calculation goes on in this process.
 */
public final class RemoteWorld extends World {

    /** Shots of which rows are made together. */
    private static final int ROWS_AT_A_TIME = 8;

    private final BlockAssignment assignment;
    private final ShotLog log;
    private final Hosts hosts;
    private final HostCalls calls = new HostCalls();
    private final InFlightSteps underWay;
    private final RemoteSteps steps;
    private final LongSupplier clock;
    private final HaloExchange halo;
    /** The question that follows the last order, until it is asked; null where there is none. */
    private Question next;

    /**
     * Opens a session with every host that can be reached.
     *
     * @param threads to go on with in this process where all hosts are lost
     * @param notices gets one line for each thing that the user should know about hosts
     * @throws NoWorkerException        where no host can be used
     * @throws IllegalArgumentException where the number of threads is below 1
     */
    public RemoteWorld(Scene scene, RadiositySettings settings, List<HostAddress> hosts, HostKey key, int threads,
                       Consumer<String> notices) throws IOException {
        this(scene, settings, threads, notices, RmiLink.to(hosts, key), System::nanoTime);
    }

    /** @param clock for differences, ns */
    public RemoteWorld(Scene scene, RadiositySettings settings, int threads, Consumer<String> notices, List<Link> links,
                LongSupplier clock) throws IOException {
        super(scene, settings, threads);
        this.clock = clock;
        log = new ShotLog(mesh, calls);
        underWay = new InFlightSteps(calls, log, clock);
        halo = new HaloExchange(calls, mesh);
        assignment = new BlockAssignment(mesh);
        Hosts.Work work = new Hosts.Work(calls, underWay, assignment, log);
        hosts = new Hosts(SceneBytes.write(scene, settings), mesh.fingerprint(), threads, notices, work);
        steps = new RemoteSteps(work, hosts, halo);
        hosts.open(links);
        steps.recover();
    }

    @Override
    public List<byte[]> round(Order order) throws IOException {
        finish(NOBODY);
        admit();
        return ask(order.isAnswered() ? order : order.asking(Order.Question.candidates(0)));
    }

    private List<byte[]> ask(Order order) throws IOException {
        List<byte[]> answers = answers(steps.begin(order, prepare(order), NOBODY), NOBODY);
        assignment.settle(hosts.present());
        return answers;
    }

    /** In parts: the next ones are made while one is on its way. */
    @Override
    public void rows(Order order, Planner planner) throws IOException {
        finish(NOBODY);
        admit();
        List<Step> parts = new ArrayList<>();
        for (Order part : order.asking(Order.Question.candidates(0)).parts(ROWS_AT_A_TIME)) {
            parts.add(steps.begin(part, prepare(part), NOBODY));
        }
        for (Step part : parts) {
            planner.take(part.order().shots().size(), answers(part, NOBODY));
        }
    }

    /**
     * Hosts first gather at the vertices that others have, too, so that the ghost values are on their way while they
     * gather elsewhere; how things stand is asked when they have come.
     */
    @Override
    public Begun begin(Order order, StepTimes times) throws IOException {
        askNext(times);
        admit();
        agree(order);
        if (!order.changes()) {
            Step asked = steps.begin(order, prepare(order), times);
            return later -> sum(decode(answers(asked, later)), order.most());
        }
        boolean isExchanged = order.isAnswered() && halo.isShared(order);
        Order silent = order.asking(isExchanged ? Order.Question.GHOST_VALUES : Order.Question.NOTHING);
        Step first = steps.begin(silent, prepare(silent), times);
        if (isExchanged) {
            steps.beginRest(order.shots().size(), times);
        }
        Question question = new Question(Order.plain(Order.Kind.ASK, order.question()),
                isExchanged ? first : null);
        if (order.isAnswered()) {
            next = question;
        }
        if (!isExchanged) {
            askNext(times);
        }
        return question;
    }

    /** How things stand after an order. */
    private final class Question implements Begun {

        private final Order order;
        /** The step whose replies bring ghost values; null where hosts gather none for each other. */
        private final Step exchange;
        /** Null before hosts are asked. */
        private Step asked;

        Question(Order order, Step exchange) {
            this.order = order;
            this.exchange = exchange;
        }

        @Override
        public Answer answer(StepTimes times) throws IOException {
            if (asked == null) {
                askNext(times);
            }
            return sum(decode(answers(asked, times)), order.most());
        }
    }

    /** Asks how things stand after the last order, where hosts were not asked yet. */
    private void askNext(StepTimes times) throws IOException {
        if (next == null) {
            return;
        }
        Question question = next;
        next = null;
        if (question.exchange != null) {
            while (!question.exchange.isDone()) {
                steps.await(times);
            }
            steps.recover();
            halo.deliver(question.exchange);
        }
        question.asked = steps.begin(question.order, prepare(question.order), times);
    }

    /*---- Vertices that several hosts have ----*/

    /** Has hosts agree which of them gathers where, if they have to before an order. */
    private void agree(Order order) throws IOException {
        if (halo.isOpen(order)) {
            exchange();
            do {
                halo.agree(hosts.present());
                steps.recover();
            } while (!halo.isAgreed());
        }
    }

    /** Gives hosts what they have gathered for each other up to now; nothing is under way then. */
    private void exchange() throws IOException {
        finish(NOBODY);
        if (halo.isUndelivered()) {
            halo.deliver(steps.carryOut(Order.plain(Order.Kind.ASK, Order.Question.GHOST_VALUES)));
            steps.carryOut(Order.plain(Order.Kind.ASK, Order.Question.NOTHING));
        }
    }

    @Override
    public void finish(StepTimes times) throws IOException {
        askNext(times);
        do {
            steps.awaitAll(times);
            steps.recover();
        } while (underWay.count() > 0);
        assignment.settle(hosts.present());
    }

    /** Waits until all hosts have answered an order. */
    private List<byte[]> answers(Step step, StepTimes times) throws IOException {
        while (!step.isAnswered()) {
            if (calls.isAnyLost()) {
                steps.recover();
            } else {
                steps.await(times);
            }
        }
        return step.answers();
    }

    @Override
    public int stepsAhead() {
        return RemoteSteps.AHEAD;
    }

    @Override
    public long now() {
        return clock.getAsLong();
    }

    /** Everything that comes before hosts receive an order. */
    private byte[] prepare(Order order) throws IOException {
        if (order.changes() && log.isCheckpointDue()) {
            blocks();
        }
        if (order.gathersTotals()) {
            log.inform(hosts.present());
        }
        byte[] bytes = order.encodeShort();
        if (order.changes() || order.isAnswered()) {
            log.add(order, order.gathersTotals() ? null : bytes);
        }
        return bytes;
    }

    /** As the master has it; how elements are divided is asked. */
    @Override
    public List<Shot> totals() throws IOException {
        List<Shot> trees = new ArrayList<>();
        for (byte[] bytes : round(Order.asking(Order.Kind.TREES, 0))) {
            trees.addAll(Wire.trees(Wire.input(bytes)));
        }
        return log.totals(joined(trees), parallel);
    }

    /*---- Losing hosts, and finding them again ----*/

    /** Between rounds: who has come gets blocks, and blocks go from slow hosts to fast ones. */
    private void admit() throws IOException {
        boolean due = assignment.isDue(hosts.present());
        if (calls.isAnyLost() || hosts.isAnyOutside() || due) {
            finish(NOBODY);
        }
        boolean come = hosts.admit(host -> assignment.speed(hosts.present(), host));
        if (come && hosts.isAlone()) {
            blocks();
            hosts.leaveAlone();
            halo.forget();
        } else if (come || due) {
            move(assignment.moves(hosts.present()));
        }
        steps.recover();
    }

    private void move(List<BlockAssignment.Move> moves) throws IOException {
        if (moves.isEmpty()) {
            assignment.moved(0);
            return;
        }
        long begin = now();
        exchange();
        hosts.move(moves);
        halo.forget();
        assignment.moved((now() - begin) * 1e-9);
    }

    /*---- States ----*/

    @Override
    public List<byte[]> blocks() throws IOException {
        long begin = now();
        exchange();
        while (true) {
            steps.recover();
            List<byte[]> all = hosts.states();
            if (!calls.isAnyLost()) {
                log.checkpoint(all, (now() - begin) * 1e-9);
                return all;
            }
        }
    }

    @Override
    public void restore(List<byte[]> states) throws IOException {
        log.checkpoint(states);
        hosts.restore();
        halo.forget();
        steps.recover();
        if (mesh.predicts()) {
            log.restart(super.totals(), hosts.present());
        }
    }

    /** What was computed where so far. */
    public WorldStatistics statistics() {
        return underWay.statistics(hosts.statistics());
    }

    @Override
    public void close() {
        hosts.close();
    }
}
