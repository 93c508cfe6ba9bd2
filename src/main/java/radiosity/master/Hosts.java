package radiosity.master;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import radiosity.master.host.Host;
import radiosity.master.host.HostCalls;
import radiosity.master.host.HostFinder;
import radiosity.master.host.Link;
import radiosity.master.host.NoWorkerException;
import radiosity.master.host.OwnLink;
import radiosity.protocol.BlockTakeover;
import radiosity.protocol.SceneBytes;
import radiosity.rmi.HostLostException;
import radiosity.rmi.HostLostException.Failure;
import radiosity.solution.HostStatistics;

/**
 * The hosts of a {@link RemoteWorld}. Hosts may be lost and come back; every block of a lost host gets another owner,
 * and with no host left this process becomes a host. Belongs to the thread of the world.
 */
final class Hosts {

    /** Number of failed computations, without a step done by all hosts in between, at which the calculation ends. */
    private static final int MOST_FAILURES = 2;

    private final byte[] task;
    private final String fingerprint;
    private final int threads;
    private final Consumer<String> notices;
    private final HostFinder finder;
    private final Work work;
    private final List<Host> present;
    private final List<HostStatistics> gone = new ArrayList<>();
    /** This process as a host; null while there are other hosts. */
    private Host alone;
    /** Number of failed computations since all hosts did a step, and number of steps done at the last failure. */
    private int failures;
    private int doneBefore;

    /** The parts of the master that act on hosts and their blocks. */
    record Work(HostCalls calls, InFlightSteps underWay, BlockAssignment assignment, ShotLog log) { }

    /**
     * @param present     the hosts in use, at first none; modified, by this class alone
     * @param task        scene and settings, as {@link SceneBytes} writes them
     * @param fingerprint fingerprint of the initial mesh of this scene
     * @param threads     number of threads with which this process goes on if all hosts are lost
     * @param notices     receives one line for each event that the user should know of
     */
    Hosts(List<Host> present, byte[] task, String fingerprint, int threads, Consumer<String> notices, Work work) {
        this.present = present;
        this.task = task;
        this.fingerprint = fingerprint;
        this.threads = threads;
        this.notices = notices;
        this.work = work;
        finder = new HostFinder(task, fingerprint, notices);
    }

    /** The hosts in use, as a view that changes when hosts come or are lost. */
    List<Host> present() {
        return present;
    }

    /**
     * Opens sessions with all hosts that can be used, and deals blocks.
     *
     * @throws NoWorkerException where no host can be used
     */
    void open(List<Link> links) throws IOException {
        present.addAll(finder.open(links));
        present.forEach(work.log()::welcome);
        if (present.isEmpty()) {
            finder.close();
            throw new NoWorkerException("hosts: expected at least one that can be used, got none");
        }
        adopt();
    }

    /*---- Lost hosts ----*/

    /** Gives the blocks of lost hosts to other hosts, until every block has an owner that is in use. */
    void recover() throws IOException {
        while (work.calls().isAnyLost()) {
            Map<Host, HostLostException> now = work.calls().takeLost();
            Map<Host, Integer> blocks = new LinkedHashMap<>();
            for (Map.Entry<Host, HostLostException> one : now.entrySet()) {
                blocks.put(one.getKey(), work.assignment().blocks(one.getKey()).size());
                lose(one.getKey(), one.getValue());
            }
            long begin = System.nanoTime();
            int owners = adopt();
            double seconds = (System.nanoTime() - begin) * 1e-9;
            now.forEach((host, why) -> notices.accept("host " + host.name() + " lost (" + why.getMessage() + "); "
                    + movedTo(blocks.get(host), owners, seconds)));
        }
    }

    private String movedTo(int blocks, int owners, double seconds) {
        if (blocks == 0) {
            return "it had no blocks";
        }
        return String.format(Locale.ROOT, "its %s to %s, rebuilt in %.1f s",
                blocks == 1 ? "1 block moves" : blocks + " blocks move",
                alone != null ? "this machine" : owners == 1 ? "1 host" : owners + " hosts", seconds);
    }

    /** @throws IOException where computation, not the connection, has failed on too many hosts or in this process */
    private void lose(Host host, HostLostException why) throws IOException {
        host.abandon();
        work.underWay().lose(host);
        remove(host, "lost");
        if (why.failure() == Failure.COMPUTATION) {
            failures = work.underWay().done() == doneBefore ? failures + 1 : 1;
            doneBefore = work.underWay().done();
            if (host == alone || failures == MOST_FAILURES) {
                throw new IOException("host " + host.name()
                        + ": expected the round to be computed there or elsewhere, got "
                        + why.getMessage(), why);
            }
        } else if (why.failure() == Failure.CONNECTION) {
            finder.lookFor(host.link());
        }
    }

    private void remove(Host host, String state) {
        gone.add(host.load.statistics(host.name(), state, 0, work.underWay().criticalPath()));
        present.remove(host);
        work.log().forget(host);
        work.assignment().lose(host);
    }

    /** Deals the blocks without an owner; gives the number of hosts that have taken some and rebuilt them. */
    private int adopt() throws IOException {
        if (present.isEmpty()) {
            goOnAlone();
        }
        List<Integer> dealt = work.assignment().deal(present);
        Map<Host, List<Integer>> gained = new LinkedHashMap<>();
        for (Host host : present) {
            List<Integer> blocks = new ArrayList<>(work.assignment().blocks(host));
            blocks.retainAll(dealt);
            if (!blocks.isEmpty()) {
                gained.put(host, blocks);
            }
        }
        Map<Host, List<byte[]>> answers = work.calls().onAll(gained.keySet(),
                host -> host.take(work.log().adoption(gained.get(host))));
        work.underWay().add(answers);
        return answers.size();
    }

    private void goOnAlone() throws IOException {
        OwnLink link = new OwnLink(threads);
        alone = new Host(link, link.connect(), threads, notices);
        alone.open("this process");
        alone.load(task, fingerprint);
        join(alone);
    }

    /*---- Hosts that come ----*/

    /** Whether a host waits to be admitted. */
    boolean isAnyOutside() {
        return finder.hasCome();
    }

    /**
     * Admits the hosts that wait; they own no blocks yet.
     *
     * @param speed gives the speed that is assumed of a new host
     * @return whether a host was admitted
     */
    boolean admit(ToDoubleFunction<Host> speed) {
        boolean come = false;
        for (Host host = finder.next(); host != null; host = finder.next()) {
            host.speed = speed.applyAsDouble(host);
            join(host);
            notices.accept("host " + host.name() + " joined");
            come = true;
        }
        return come;
    }

    private void join(Host host) {
        work.log().welcome(host);
        present.add(host);
    }

    /** Whether this process is one of the hosts. */
    boolean isAlone() {
        return alone != null;
    }

    /** Gives the blocks of this process, of which a checkpoint was taken, to the hosts that have come. */
    void leaveAlone() throws IOException {
        remove(alone, "left");
        alone.close();
        alone = null;
        adopt();
    }

    /*---- Blocks ----*/

    /** Moves blocks with their current states; blocks of a host that is lost meanwhile stay until {@link #recover}. */
    void move(List<BlockAssignment.Move> moves) {
        Map<Host, List<Integer>> from = new LinkedHashMap<>();
        Map<Host, Map<Integer, byte[]>> to = new LinkedHashMap<>();
        moves.forEach(move -> from.computeIfAbsent(move.from(), h -> new ArrayList<>()).add(move.block()));
        Map<Host, List<byte[]>> states = work.calls().onAll(from.keySet(), host -> host.blocks(from.get(host)));
        states.keySet().forEach(host -> to.put(host, new TreeMap<>()));
        for (BlockAssignment.Move move : moves) {
            if (states.containsKey(move.from())) {
                byte[] state = states.get(move.from()).get(from.get(move.from()).indexOf(move.block()));
                to.computeIfAbsent(move.to(), h -> new TreeMap<>()).put(move.block(), state);
                work.assignment().give(move.block(), move.to());
            }
        }
        work.calls().onAll(to.keySet(), host ->
                host.take(new BlockTakeover(to.get(host), List.of(), from.getOrDefault(host, List.of()))));
    }

    /** The states of all blocks, by id; states are missing where a host is lost. */
    List<byte[]> states() {
        Map<Integer, byte[]> all = new TreeMap<>();
        work.calls().onAll(present, host -> host.blocks(work.assignment().blocks(host))).forEach((host, some) -> {
            List<Integer> ids = work.assignment().blocks(host);
            for (int i = 0; i < ids.size(); i++) {
                all.put(ids.get(i), some.get(i));
            }
        });
        return List.copyOf(all.values());
    }

    /** Puts all blocks back to their states in the log. */
    void restore() {
        work.calls().onAll(present, host -> host.take(work.log().adoption(work.assignment().blocks(host))));
    }

    List<HostStatistics> statistics() {
        List<HostStatistics> all = new ArrayList<>(gone);
        present.forEach(host -> all.add(host.load.statistics(host.name(), "working",
                work.assignment().blocks(host).size(), work.underWay().criticalPath())));
        return all;
    }

    void close() {
        finder.close();
        HostCalls.close(present);
    }
}
