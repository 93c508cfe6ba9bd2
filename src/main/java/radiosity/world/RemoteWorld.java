package radiosity.world;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import radiosity.scene.Scene;

/**
 * A world whose elements are on other machines (section 4.5.3 of the paper).
 *
 * <p>Each host owns some blocks. What is done in a round goes into a log before any host is told; from a block's state
 * at the last checkpoint and that log any other host makes the block again, to the same bits. So a host may be lost at
 * any time, blocks may move, and with no host left the calculation goes on in this process.
 */
public final class RemoteWorld extends World {

    private static final int MOST_FAILURES = 2;
    /** One that is done, others that are on their way: how far a fast host may be ahead of a slow one. */
    private static final int STEPS_AHEAD = 4;
    /** Candidates that every host names at least where so many are wanted. */
    private static final int LEAST_NAMED = 4;
    private static final StepTimes NOBODY = (shots, seconds) -> { };
    /**
     * A checkpoint is taken when the rounds since the last one took so many times as long as it: 1 % of the time at
     * most, and what n hosts lose with one of them is an n-th of those rounds.
     */
    private static final double CHECKPOINT_PATIENCE = 100;
    private static final double CHECKPOINT_SECONDS = 0.02;
    /** What the first one is taken to cost: per patch, s. */
    private static final double CHECKPOINT_SECONDS_PER_PATCH = 1e-6;
    /** Orders that are kept in memory for the next loss. */
    private static final long MOST_LOGGED = 128L << 20;

    private final Consumer<String> notices;
    private final int threads;
    private final byte[] task;
    private final HostFinder finder;
    private final Dealing dealing;
    private final ShotLog log = new ShotLog();
    private final SharedTotals totals;
    private final Cadence checkpoints;
    private final RoundTimes times;
    private final Balance balance;
    private final List<Host> hosts = new ArrayList<>();
    private final List<HostStatistics> gone = new ArrayList<>();
    private final HostCalls calls = new HostCalls();
    private final StepsUnderWay underWay = new StepsUnderWay(calls);
    private final LongSupplier clock;
    private final BlockTransfer transfer;
    /** This process as a host, while there is no other. */
    private Host alone;
    private int failures;

    /**
     * Opens a session with every host that can be reached.
     *
     * @param threads to go on with in this process where all hosts are lost
     * @param notices told what the user should know about hosts, one line each
     * @throws NoWorkerException where no host can be used
     */
    public RemoteWorld(Scene scene, RadiositySettings settings, List<HostAddress> hosts, HostKey key, int threads,
                       Consumer<String> notices) throws IOException {
        this(scene, settings, threads, notices, RmiLink.to(hosts, key), System::nanoTime);
    }

    /** @param clock for differences, ns */
    RemoteWorld(Scene scene, RadiositySettings settings, int threads, Consumer<String> notices, List<Link> links,
                LongSupplier clock) throws IOException {
        super(new InitialMesh(scene, settings));
        this.clock = clock;
        times = new RoundTimes(clock);
        totals = new SharedTotals(mesh, calls);
        this.notices = notices;
        this.threads = threads;
        task = SceneBytes.write(scene, settings);
        finder = new HostFinder(task, mesh.fingerprint(), notices);
        Borders borders = new Borders(mesh);
        Forecast forecast = new Forecast(borders);
        dealing = new Dealing(forecast, borders);
        balance = new Balance(forecast, dealing, patches());
        checkpoints = new Cadence(CHECKPOINT_PATIENCE, CHECKPOINT_SECONDS, patches() * CHECKPOINT_SECONDS_PER_PATCH);
        transfer = new BlockTransfer(dealing, log, calls);
        hosts.addAll(finder.open(links));
        hosts.forEach(totals::welcome);
        if (hosts.isEmpty()) {
            finder.close();
            throw new NoWorkerException("hosts: expected at least one that can be used, got none");
        }
        adopt();
        recover();
    }

    @Override
    List<byte[]> round(Order order) throws IOException {
        finish(NOBODY);
        order = order.isAnswered() ? order : order.naming(0);
        byte[] bytes = prepare(order);
        while (true) {
            underWay.begin(hosts, order, bytes, now(), times.criticalPath());
            totals.count(order);
            await(NOBODY);
            boolean isLost = calls.isAnyLost();
            if (isLost && !order.changes()) {
                underWay.forget();
            }
            recover();
            if (!isLost || order.changes()) {
                balance.settle(hosts);
                return underWay.last();
            }
        }
    }

    @Override
    void begin(Order step, StepTimes told) throws IOException {
        underWay.begin(hosts, step, prepare(step), now(), times.criticalPath());
        totals.count(step);
        while (underWay.count() >= STEPS_AHEAD) {
            await(told);
        }
    }

    @Override
    void finish(StepTimes told) throws IOException {
        awaitAll(told);
        recover();
        balance.settle(hosts);
    }

    private void awaitAll(StepTimes told) {
        while (underWay.count() > 0) {
            await(told);
        }
    }

    @Override
    int unread() {
        return underWay.unread();
    }

    @Override
    Answered next(StepTimes told) throws IOException {
        while (!underWay.isAnyAnswered()) {
            await(told);
            if (calls.isAnyLost()) {
                finish(told);
            }
        }
        return underWay.next();
    }

    /** Twice a fair share: blocks are dealt so that who has much to shoot is spread. */
    @Override
    int named(int most) {
        return (int) Math.min(most, LEAST_NAMED + 2L * most / hosts.size());
    }

    @Override
    int stepsAhead() {
        return STEPS_AHEAD;
    }

    @Override
    long now() {
        return clock.getAsLong();
    }

    /** Everything that comes before the hosts are told. */
    private byte[] prepare(Order order) throws IOException {
        admit(order);
        if (checkpoints.isDue() || log.bytes() > MOST_LOGGED) {
            blocks();
        }
        if (order.kind() == Order.Kind.GATHER) {
            totals.tell(hosts);
        }
        byte[] bytes = order.encodeShort();
        if (order.changes()) {
            log.add(order, order.kind() == Order.Kind.GATHER ? null : bytes);
        }
        return bytes;
    }

    /** As the master has it; how elements are divided is asked. */
    @Override
    List<Shot> totals() throws IOException {
        return totals.of(round(Order.plain(Order.Kind.TREES, 0)));
    }

    /** Waits for the first step that is under way; who is lost then has lost nothing that the log does not have. */
    private Map<Host, Reply> await(StepTimes told) {
        StepsUnderWay.Done step = underWay.await(clock);
        told.took(step.order().shots().size(), step.seconds());
        if (!calls.isAnyLost()) {
            failures = 0;
            times.add(step);
            balance.add(step.replies(), step.order());
            if (step.order().changes()) {
                checkpoints.add(step.replies().values().stream().mapToDouble(Reply::seconds).max().orElse(0));
            }
        }
        return step.replies();
    }

    /*---- Losing hosts, and finding them again ----*/

    /** Gives the blocks of lost hosts to others, until all of them have an owner that is alive. */
    private void recover() throws IOException {
        if (!calls.isAnyLost()) {
            return;
        }
        awaitAll(NOBODY);
        while (calls.isAnyLost()) {
            Map<Host, HostLostException> now = calls.takeLost();
            Map<Host, Integer> blocks = new LinkedHashMap<>();
            for (Map.Entry<Host, HostLostException> one : now.entrySet()) {
                blocks.put(one.getKey(), dealing.blocks(one.getKey()).size());
                lose(one.getKey(), one.getValue());
            }
            long begin = now();
            int heirs = adopt();
            double seconds = (now() - begin) * 1e-9;
            now.forEach((host, why) -> notices.accept(String.format(Locale.ROOT,
                    "host %s lost (%s); its %d blocks move to %s, rebuilt in %.1f s", host.name(), why.getMessage(),
                    blocks.get(host), alone != null ? "this machine" : heirs == 1 ? "1 host" : heirs + " hosts",
                    seconds)));
        }
        underWay.mended();
    }

    private void lose(Host host, HostLostException why) throws IOException {
        host.abandon();
        underWay.lose(host);
        gone.add(host.load.statistics(host.name(), "lost", 0, times.criticalPath()));
        hosts.remove(host);
        dealing.lose(host);
        if (why.inComputation()) {
            if (host == alone || ++failures == MOST_FAILURES) {
                throw new IOException("host " + host.name() + ": expected the round to be computed there or elsewhere, got "
                        + why.getMessage(), why);
            }
        } else {
            finder.lookFor(host.link());
        }
    }

    private int adopt() throws IOException {
        if (hosts.isEmpty()) {
            goOnAlone();
        }
        Map<Host, List<byte[]>> answers = transfer.adopt(hosts, underWay.torn());
        underWay.add(answers);
        return answers.size();
    }

    private void goOnAlone() throws IOException {
        OwnLink link = new OwnLink(threads);
        alone = new Host(link, link.connect(), threads, notices);
        alone.open("this process");
        alone.load(task, mesh.fingerprint());
        totals.welcome(alone);
        hosts.add(alone);
    }

    /** Between rounds: who has come gets blocks, and blocks go from slow hosts to fast ones. */
    private void admit(Order order) throws IOException {
        boolean due = balance.isDue(order, hosts);
        if (calls.isAnyLost() || finder.hasCome() || due) {
            finish(NOBODY);
        }
        boolean come = false;
        for (Host host = finder.next(); host != null; host = finder.next()) {
            host.speed = balance.speed(hosts, host);
            totals.welcome(host);
            hosts.add(host);
            notices.accept("host " + host.name() + " joined");
            come = true;
        }
        if (come && alone != null) {
            leave(alone);
        } else if (come || due) {
            move(dealing.moves(hosts, order.kind() == Order.Kind.GATHER));
        }
        recover();
    }

    /** The process that went on alone gives its blocks to hosts that have come. */
    private void leave(Host host) throws IOException {
        blocks();
        hosts.remove(host);
        gone.add(host.load.statistics(host.name(), "left", 0, times.criticalPath()));
        dealing.lose(host);
        host.close();
        alone = null;
        adopt();
    }

    private void move(List<Dealing.Move> moves) {
        if (moves.isEmpty()) {
            balance.notMoved();
            return;
        }
        long begin = now();
        transfer.move(moves);
        balance.moved((now() - begin) * 1e-9);
    }

    /*---- States ----*/

    @Override
    List<byte[]> blocks() throws IOException {
        finish(NOBODY);
        long begin = now();
        while (true) {
            recover();
            List<byte[]> all = transfer.states(hosts);
            if (!calls.isAnyLost()) {
                log.checkpoint(all);
                checkpoints.done((now() - begin) * 1e-9);
                return all;
            }
        }
    }

    @Override
    void restore(List<byte[]> states) throws IOException {
        log.checkpoint(states);
        transfer.restore(hosts);
        recover();
        if (mesh.predicts()) {
            totals.set(super.totals(), hosts);
        }
    }

    /** What was computed where so far. */
    public WorldStatistics statistics() {
        List<HostStatistics> all = new ArrayList<>(gone);
        hosts.forEach(host -> all.add(host.load.statistics(host.name(), "working", dealing.blocks(host).size(),
                times.criticalPath())));
        return times.statistics(all);
    }

    @Override
    public void close() {
        finder.close();
        HostCalls.close(hosts);
    }
}
