package radiosity.master;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import radiosity.master.InFlightSteps.Step;
import radiosity.master.host.Host;
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
 * A world whose elements are on other machines (section 4.5.3 of the paper). Belongs to one thread.
 *
 * <p>Each host owns some blocks. Each order is written to a log before any host receives the order; from a block's
 * state at the last checkpoint and this log, any other host can rebuild the block to the same bits. So a host may be
 * lost at any time, blocks may move, and with no host left the calculation goes on in this process.
 */
public final class RemoteWorld extends World {

    /** Number of shots per step in which hosts make rows. */
    private static final int ROWS_AT_A_TIME = 8;

    private final BlockAssignment assignment;
    private final ShotLog log;
    private final Hosts hosts;
    private final HostCalls calls = new HostCalls();
    private final InFlightSteps steps;
    private final LongSupplier clock;
    private final HaloExchange halo;
    /** The question that follows the last order, until hosts are asked; null where there is none. */
    private Question next;

    /**
     * Opens a session with every host that can be reached.
     *
     * @param key     key that hosts must have; null for connections without a key
     * @param threads number of threads with which this process goes on if all hosts are lost
     * @param notices receives one line for each event that the user should know of
     * @throws NoWorkerException        where no host can be used
     * @throws IllegalArgumentException where the number of threads is below 1
     */
    public RemoteWorld(Scene scene, RadiositySettings settings, List<HostAddress> hosts, HostKey key, int threads,
                       Consumer<String> notices) throws IOException {
        this(scene, settings, threads, notices, RmiLink.to(hosts, key), System::nanoTime);
    }

    /** @param clock clock of which only differences are used, ns */
    public RemoteWorld(Scene scene, RadiositySettings settings, int threads, Consumer<String> notices, List<Link> links,
                LongSupplier clock) throws IOException {
        super(scene, settings, threads);
        this.clock = clock;
        log = new ShotLog(mesh, calls);
        halo = new HaloExchange(calls, mesh);
        assignment = new BlockAssignment(mesh);
        List<Host> present = new ArrayList<>();
        steps = new InFlightSteps(calls, log, assignment, halo, present, clock);
        hosts = new Hosts(present, SceneBytes.write(scene, settings), mesh.fingerprint(), threads, notices,
                new Hosts.Work(calls, steps, assignment, log));
        try {
            hosts.open(links);
            recover();
        } catch (IOException | RuntimeException | Error e) {
            hosts.close(); // nobody else can: the caller gets no world
            throw e;
        }
    }

    @Override
    public List<byte[]> round(Order order) throws IOException {
        finish(IGNORE_TIMES);
        admit();
        return ask(order.isAnswered() ? order : order.asking(Order.Question.candidates(0)));
    }

    /** Carries out an order and waits for the answers of all hosts. */
    private List<byte[]> ask(Order order) throws IOException {
        List<byte[]> answers = answers(steps.begin(order, prepare(order), IGNORE_TIMES), IGNORE_TIMES);
        assignment.settle(hosts.present());
        return answers;
    }

    /** Asks in parts: hosts make the rows of the next parts while the answer to one part is on its way. */
    @Override
    public void rows(Order order, Planner planner) throws IOException {
        ask(order.asking(Order.Question.candidates(0)).parts(ROWS_AT_A_TIME).iterator(),
                (part, rows) -> planner.take(part.shots().size(), rows), () -> true);
    }

    @Override
    public void ask(Iterator<Order> orders, Answers to, BooleanSupplier goOn) throws IOException {
        finish(IGNORE_TIMES);
        admit();
        Deque<Step> asked = new ArrayDeque<>();
        while (orders.hasNext() || !asked.isEmpty()) {
            if (!goOn.getAsBoolean()) {
                throw new CancellationException();
            }
            if (orders.hasNext() && asked.size() < InFlightSteps.AHEAD) {
                Order order = orders.next();
                asked.add(steps.begin(order, prepare(order), IGNORE_TIMES));
            } else {
                Step first = asked.remove();
                to.take(first.order(), answers(first, IGNORE_TIMES));
            }
        }
    }

    /**
     * Begins an order. Hosts that share vertices gather at the shared vertices first, so that the ghost values are on
     * their way while the hosts gather elsewhere; the question of the order is asked when the ghost values have come.
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

    /** The question of an order that changes elements, which hosts are asked in a step of its own. */
    private final class Question implements Begun {

        private final Order order;
        /** The step whose replies contain ghost values; null where hosts do not gather for each other. */
        private final Step exchange;
        /** The step in which hosts are asked; null before. */
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

    /** Asks hosts the question that follows the last order, if they were not asked yet. */
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
            recover();
            halo.deliver(question.exchange);
        }
        question.asked = steps.begin(question.order, prepare(question.order), times);
    }

    /*---- Vertices that several hosts have ----*/

    /** Has hosts agree which of them gathers at shared vertices, if the order needs an agreement. */
    private void agree(Order order) throws IOException {
        if (halo.isOpen(order)) {
            exchange();
            do {
                halo.agree(hosts.present());
                recover();
            } while (!halo.isAgreed());
        }
    }

    /** Exchanges the ghost values that are not delivered yet, in steps of their own; no step is in flight then. */
    private void exchange() throws IOException {
        finish(IGNORE_TIMES);
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
            recover();
        } while (steps.isAny());
        assignment.settle(hosts.present());
    }

    /** Waits until all hosts have answered an order. */
    private List<byte[]> answers(Step step, StepTimes times) throws IOException {
        while (!step.isAnswered()) {
            if (calls.isAnyLost()) {
                recover();
            } else {
                steps.await(times);
            }
        }
        return step.answers();
    }

    @Override
    public int stepsAhead() {
        return InFlightSteps.AHEAD;
    }

    @Override
    public long now() {
        return clock.getAsLong();
    }

    /** Does what must precede an order (checkpoint, light ever shot, log); gives the order as hosts receive it. */
    private byte[] prepare(Order order) throws IOException {
        if (order.changes() && log.isCheckpointDue()) {
            blocks();
        }
        if (order.kind().gathersTotals()) {
            log.inform(hosts.present());
        }
        byte[] bytes = order.encodeShort();
        if (order.changes() || order.isAnswered()) {
            log.add(order, order.kind().gathersTotals() ? null : bytes);
        }
        return bytes;
    }

    /** The totals that the master has summed up, on the hosts' elements: only the trees are asked for. */
    @Override
    public List<Shot> totals() throws IOException {
        List<Shot> trees = new ArrayList<>();
        for (byte[] bytes : round(Order.asking(Order.Kind.TREES, 0))) {
            trees.addAll(Wire.trees(Wire.input(bytes)));
        }
        return log.totals(joined(trees), parallel);
    }

    /*---- Losing hosts, and finding them again ----*/

    /** Where hosts are lost, waits for all steps in flight, and has other hosts rebuild the blocks of the lost ones. */
    private void recover() throws IOException {
        if (calls.isAnyLost()) {
            steps.awaitAll(IGNORE_TIMES);
            hosts.recover();
            halo.forget();
            steps.allAnswered();
        }
    }

    /** Between rounds: gives blocks to hosts that have come, and moves blocks from slow hosts to fast ones. */
    private void admit() throws IOException {
        boolean due = assignment.isDue(hosts.present());
        if (calls.isAnyLost() || hosts.isAnyOutside() || due) {
            finish(IGNORE_TIMES);
        }
        boolean come = hosts.admit(host -> assignment.speed(hosts.present(), host));
        if (come && hosts.isAlone()) {
            blocks();
            hosts.leaveAlone();
            halo.forget();
        } else if (come || due) {
            move();
        }
        recover();
    }

    /** Moves blocks from slow hosts to fast ones; a host may be lost in the exchange of ghost values before that. */
    private void move() throws IOException {
        if (assignment.moves(hosts.present()).isEmpty()) {
            assignment.moved(0);
            return;
        }
        long begin = now();
        exchange();
        hosts.move(assignment.moves(hosts.present()));
        halo.forget();
        assignment.moved((now() - begin) * 1e-9);
    }

    /*---- States ----*/

    @Override
    public List<byte[]> blocks() throws IOException {
        long begin = now();
        exchange();
        while (true) {
            recover();
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
        recover();
        if (mesh.predicts()) {
            log.restart(super.totals());
        }
    }

    /** The work of each host so far, and that of the master. */
    public WorldStatistics statistics() {
        return steps.statistics(hosts.statistics());
    }

    @Override
    public void close() {
        hosts.close();
    }
}
