package radiosity.master;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import radiosity.master.balance.Balance;
import radiosity.master.balance.BlockCostModel;
import radiosity.master.balance.Borders;
import radiosity.master.balance.Dealing;
import radiosity.master.host.HostCalls;
import radiosity.master.host.Link;
import radiosity.master.host.NoWorkerException;
import radiosity.master.host.RmiLink;
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
 * <p>Each host owns some blocks. What is done in a round goes into a log before any host is told; from a block's state
 * at the last checkpoint and that log any other host makes the block again, to the same bits. So a host may be lost at
 * any time, blocks may move, and with no host left the calculation goes on in this process.
 */
public final class RemoteWorld extends World {

    /** Shots of which rows are made together. */
    private static final int ROWS_AT_A_TIME = 8;

    private final Dealing dealing;
    private final ShotLog log;
    private final SharedTotals totals;
    private final RoundTimes times;
    private final Balance balance;
    private final Hosts hosts;
    private final HostCalls calls = new HostCalls();
    private final InFlightSteps underWay;
    private final RemoteSteps steps;
    private final LongSupplier clock;
    private final BlockTransfer transfer;
    private final HaloExchange points;

    /**
     * Opens a session with every host that can be reached.
     *
     * @param threads to go on with in this process where all hosts are lost
     * @param notices told what the user should know about hosts, one line each
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
        times = new RoundTimes(clock);
        totals = new SharedTotals(mesh, calls);
        Seams seams = new Seams(threads);
        underWay = new InFlightSteps(calls, seams);
        points = new HaloExchange(calls, mesh, seams);
        log = new ShotLog(patches());
        Borders borders = new Borders(mesh);
        BlockCostModel forecast = new BlockCostModel(borders, mesh.hasSeams());
        dealing = new Dealing(forecast, borders);
        balance = new Balance(forecast, dealing, patches(), mesh.clusters.clusters.size());
        transfer = new BlockTransfer(dealing, log, calls);
        hosts = new Hosts(SceneBytes.write(scene, settings), mesh.fingerprint(), threads, notices,
                new Hosts.Work(calls, underWay, dealing, transfer, totals, times));
        steps = new RemoteSteps(calls, underWay, hosts, new RemoteSteps.Counts(log, totals, times, balance), points,
                clock);
        hosts.open(links);
        steps.recover();
        if (mesh.gathersOnce()) {
            agree();
        }
    }

    @Override
    public List<byte[]> round(Order order) throws IOException {
        finish(NOBODY);
        admit(order);
        return ask(order.isAnswered() ? order : order.naming(0));
    }

    private List<byte[]> ask(Order order) throws IOException {
        InFlightSteps.Given given = steps.begin(order, prepare(order));
        while (underWay.count() > 0) {
            steps.await(NOBODY);
            steps.recover();
        }
        balance.settle(hosts.present());
        return given.answers();
    }

    /** In parts: the next ones are made while one is on its way. */
    @Override
    public void rows(Order order, Planner planner) throws IOException {
        finish(NOBODY);
        admit(order);
        List<InFlightSteps.Given> parts = new ArrayList<>();
        for (Order part : order.naming(0).parts(ROWS_AT_A_TIME)) {
            parts.add(steps.begin(part, prepare(part)));
            steps.keepUp(NOBODY);
        }
        for (InFlightSteps.Given part : parts) {
            planner.take(part.order().shots().size(), answers(part, NOBODY));
        }
    }

    @Override
    public Begun begin(Order step, StepTimes told) throws IOException {
        admit(step);
        share(step);
        boolean exchanged = step.isAnswered() && points.isShared(step) && !mesh.hasSeams();
        Order now = exchanged ? step.naming(Order.GIVE) : step;
        InFlightSteps.Given given = steps.begin(now, prepare(now));
        if (exchanged) {
            finish(told);
            List<byte[]> answers = ask(Order.plain(Order.Kind.ASK, step.most()).from(step.least()));
            return later -> sum(decode(answers), step.most());
        }
        steps.keepUp(told);
        return later -> sum(decode(answers(given, later)), step.most());
    }

    /*---- Points that several hosts have ----*/

    /** Who gathers where, if that is not known. */
    private void share(Order order) throws IOException {
        if (points.isOpen(order)) {
            finish(NOBODY);
            agree();
        }
    }

    private void agree() throws IOException {
        do {
            points.agree(hosts.present(), dealing);
            steps.recover();
        } while (!points.isAgreed());
    }

    /** Tells hosts what they have gathered for each other up to now; nothing is under way. */
    private void exchange() {
        if (points.isOwed()) {
            if (mesh.hasSeams()) {
                points.deliver();
            } else {
                steps.tell(Order.plain(Order.Kind.ASK, Order.GIVE));
            }
            steps.tell(Order.plain(Order.Kind.ASK, -1));
        }
    }

    @Override
    public void finish(StepTimes told) throws IOException {
        do {
            steps.awaitAll(told);
            steps.recover();
        } while (underWay.count() > 0);
        balance.settle(hosts.present());
    }

    /** Waits until all hosts have answered an order. */
    private List<byte[]> answers(InFlightSteps.Given given, StepTimes told) throws IOException {
        while (!given.isAnswered()) {
            if (calls.isAnyLost()) {
                finish(told);
            } else {
                steps.await(told);
            }
        }
        return given.answers();
    }

    @Override
    public int stepsAhead() {
        return RemoteSteps.AHEAD;
    }

    @Override
    public long now() {
        return clock.getAsLong();
    }

    /** Everything that comes before the hosts are told. */
    private byte[] prepare(Order order) throws IOException {
        if (order.changes() && log.isCheckpointDue()) {
            blocks();
        }
        if (order.kind() == Order.Kind.GATHER) {
            totals.tell(hosts.present());
        }
        byte[] bytes = order.encodeShort();
        if (order.changes()) {
            log.add(order, order.kind() == Order.Kind.GATHER ? null : bytes);
        }
        return bytes;
    }

    /** As the master has it; how elements are divided is asked. */
    @Override
    public List<Shot> totals() throws IOException {
        List<Shot> trees = new ArrayList<>();
        for (byte[] bytes : round(Order.plain(Order.Kind.TREES, 0))) {
            trees.addAll(Wire.trees(Wire.input(bytes)));
        }
        return totals.of(joined(trees), crew);
    }

    /*---- Losing hosts, and finding them again ----*/

    /** Between rounds: who has come gets blocks, and blocks go from slow hosts to fast ones. */
    private void admit(Order order) throws IOException {
        boolean due = balance.isDue(order, hosts.present());
        if (calls.isAnyLost() || hosts.isAnyOutside() || due) {
            finish(NOBODY);
        }
        boolean come = hosts.admit(host -> balance.speed(hosts.present(), host));
        if (come && hosts.isAlone()) {
            blocks();
            hosts.leaveAlone();
            points.forget();
        } else if (come || due) {
            move(dealing.moves(hosts.present(), order.kind() == Order.Kind.GATHER));
        }
        steps.recover();
    }

    private void move(List<Dealing.Move> moves) throws IOException {
        if (moves.isEmpty()) {
            balance.notMoved();
            return;
        }
        long begin = now();
        exchange();
        transfer.move(moves);
        points.forget();
        if (mesh.hasSeams()) {
            agree();
        }
        balance.moved((now() - begin) * 1e-9);
    }

    /*---- States ----*/

    @Override
    public List<byte[]> blocks() throws IOException {
        finish(NOBODY);
        long begin = now();
        exchange();
        while (true) {
            steps.recover();
            List<byte[]> all = transfer.states(hosts.present());
            if (!calls.isAnyLost()) {
                log.checkpoint(all, (now() - begin) * 1e-9);
                return all;
            }
        }
    }

    @Override
    public void restore(List<byte[]> states) throws IOException {
        log.checkpoint(states);
        transfer.restore(hosts.present());
        points.forget();
        steps.recover();
        if (mesh.predicts()) {
            totals.set(super.totals(), hosts.present());
        }
    }

    /** What was computed where so far. */
    public WorldStatistics statistics() {
        return times.statistics(hosts.statistics());
    }

    @Override
    public void close() {
        hosts.close();
    }
}
