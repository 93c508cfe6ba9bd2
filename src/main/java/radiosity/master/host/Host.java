package radiosity.master.host;

import java.io.BufferedOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.rmi.RemoteException;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import radiosity.protocol.BlockTakeover;
import radiosity.protocol.Reply;
import radiosity.protocol.SceneBytes;
import radiosity.protocol.Wire;
import radiosity.rmi.HostFailure;
import radiosity.rmi.HostLostException;
import radiosity.rmi.RemotePartition;
import radiosity.rmi.RetryPolicy;
import radiosity.util.Pieces;
import radiosity.worker.ShotHistory;

/**
 * One host as its master sees it: a session, with calls on threads of a common pool and a thread for the heartbeat.
 *
 * <p>Belongs to the thread of the {@code RemoteWorld}, which starts calls on several hosts and then awaits each call.
 */
public final class Host implements AutoCloseable {

    /** Silence of a host after which the user is notified, s. */
    private static final double NOTICED = 3;
    private static final long HEARTBEAT_MILLISECONDS = 1000;
    /** Time between two looks at a call's result and the host's silence. */
    private static final long LOOK_MILLISECONDS = 100;
    private static final int PART_BYTES = RemotePartition.MOST_PIECE_BYTES;
    /** Daemon threads, so that a call that hangs does not keep the program from ending. */
    static final ExecutorService CALLS = Executors.newCachedThreadPool(work -> {
        Thread thread = new Thread(work, "host");
        thread.setDaemon(true);
        return thread;
    });
    private static final SecureRandom NUMBERS = new SecureRandom();

    private final Link link;
    private final RemotePartition remote;
    private final Consumer<String> notices;
    private final long session = NUMBERS.nextLong();
    private final Thread heartbeat = new Thread(this::beat, "heartbeat");
    /** Time of the host's last sign of life, ns. */
    private volatile long heard = System.nanoTime();
    private volatile boolean closed;
    /** Value of {@link #heard} when the user was last notified of the host's silence; 0 before the first time. */
    private long noticed;
    private long rounds;
    /** Speed relative to other hosts: the host's number of threads, until it is measured. */
    public double speed;
    /** Pairs of receiving point and shooter in the last rounds, and the wall time they took, s; weighted sums. */
    public double pairs;
    public double seconds;
    public final HostLoad load = new HostLoad();
    /** The ghost values for this host, which are appended to its next order; or empty. */
    private byte[] ghostValues = {};

    /** @param threads number of threads with which the host computes */
    public Host(Link link, RemotePartition remote, int threads, Consumer<String> notices) {
        this.link = link;
        this.remote = remote;
        this.notices = notices;
        speed = threads;
    }

    /** Opens a session for the user named {@code master}, and begins the heartbeat. */
    public void open(String master) throws RemoteException {
        remote.open(session, Wire.utf8(master));
        heard = System.nanoTime();
        heartbeat.setDaemon(true);
        heartbeat.start();
    }

    /**
     * Sends the scene to the host, which makes its initial mesh.
     *
     * @param task     scene and settings, as {@link SceneBytes} writes them
     * @param expected fingerprint of the initial mesh of this scene
     * @throws IOException where the host has made another mesh
     */
    public Void load(byte[] task, String expected) throws IOException {
        send(out -> out.write(task));
        String got = Wire.utf8(remote.mesh(session));
        if (!got.equals(expected)) {
            throw new IOException("expected the mesh of " + expected + ", got that of " + got);
        }
        return null;
    }

    /** Pairs of receiving point and shooter per second. */
    public double pairsPerSecond() {
        return pairs / seconds;
    }

    public String name() {
        return link.name();
    }

    public Link link() {
        return link;
    }

    /** Sends a message part by part while it is written, so that no array holds the whole message. */
    private void send(Wire.Writer message) throws IOException {
        try (DataOutputStream out = new DataOutputStream(new BufferedOutputStream(new Parts(), PART_BYTES))) {
            message.write(out);
        }
    }

    /** Sends the bytes that are written to this stream to the host. */
    private final class Parts extends OutputStream {

        @Override
        public void write(int value) throws IOException {
            write(new byte[] {(byte) value}, 0, 1);
        }

        @Override
        public void write(byte[] bytes, int from, int count) throws IOException {
            for (int at = from; at < from + count; at += PART_BYTES) {
                byte[] part = Arrays.copyOfRange(bytes, at, Math.min(from + count, at + PART_BYTES));
                remote.send(session, part);
                load.bytes.addAndGet(part.length);
            }
        }
    }

    private void beat() {
        while (!closed) {
            try {
                remote.ping(session);
                heard = System.nanoTime();
            } catch (RemoteException | RuntimeException | OutOfMemoryError e) {
                // await() notices the silence of this host; the thread that needs the memory reports its lack
            }
            try {
                Thread.sleep(HEARTBEAT_MILLISECONDS);
            } catch (InterruptedException e) {
                return;
            }
        }
    }

    /*---- Calls; each is started on all hosts and then awaited ----*/

    /** The number of the next round: the host does rounds in this order, also if calls overtake each other. */
    public long nextRound() {
        return ++rounds;
    }

    /** @param values ghost values for this host, which are appended to its next order, see {@code GhostVertices} */
    public void addGhostValues(byte[] values) {
        ghostValues = values;
    }

    /** An encoded order, followed by the ghost values for this host, which are forgotten then. */
    public byte[] withGhostValues(byte[] order) {
        if (ghostValues.length == 0) {
            return order;
        }
        byte[] all = Arrays.copyOf(order, order.length + ghostValues.length);
        System.arraycopy(ghostValues, 0, all, order.length, ghostValues.length);
        ghostValues = new byte[0];
        return all;
    }

    /** Has the host carry out an order; repeats the call where the connection breaks. */
    public Reply round(long number, byte[] order) throws IOException {
        byte[][] pieces = Pieces.cut(order, PART_BYTES);
        byte[] bytes = RetryPolicy.repeat(() -> remote.round(session, number, pieces));
        load.bytes.addAndGet((long) order.length + bytes.length);
        return Reply.decode(bytes);
    }

    /** Gives blocks to the host; returns its answers to those of the repeated orders that ask for answers. */
    public List<byte[]> take(BlockTakeover adoption) throws IOException {
        send(adoption::write);
        byte[] answers = remote.take(session);
        load.bytes.addAndGet(answers.length);
        return Wire.list(answers);
    }

    /** @param totals all light ever shot, see {@link ShotHistory}: shots as {@link Wire} writes them */
    public Void know(byte[] totals) throws IOException {
        send(out -> out.write(totals));
        remote.know(session);
        return null;
    }

    /** The keys of the vertices that other hosts may also have, 8 bytes each, see {@code GhostVertices.name}. */
    public byte[] border() throws IOException {
        byte[] keys = remote.border(session);
        load.bytes.addAndGet(keys.length);
        return keys;
    }

    /** @param roles role of each vertex that the host has named, see {@code GhostVertices.agree} */
    public Void share(int agreement, byte[] roles) throws IOException {
        send(out -> {
            out.writeInt(agreement);
            out.write(roles);
        });
        remote.share(session);
        return null;
    }

    /** The states of some of the host's blocks, in the order of the ids. */
    public List<byte[]> blocks(List<Integer> blocks) throws IOException {
        List<byte[]> states = new ArrayList<>();
        while (states.size() < blocks.size()) {
            byte[] wanted = ids(blocks.subList(states.size(), blocks.size()));
            byte[] some = RetryPolicy.repeat(() -> remote.blocks(session, wanted));
            load.bytes.addAndGet(some.length);
            int before = states.size();
            states.addAll(Wire.list(some));
            if (states.size() == before) {
                throw new IOException("expected states of blocks, got none");
            }
        }
        return states;
    }

    private static byte[] ids(List<Integer> blocks) {
        ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES * blocks.size());
        blocks.forEach(bytes::putInt);
        return bytes.array();
    }

    /** Begins calls to this host without waiting for their result. */
    public <T> FutureTask<T> begin(Callable<T> calls) {
        return link.begin(calls);
    }

    static <T> FutureTask<T> start(Callable<T> call) {
        FutureTask<T> task = new FutureTask<>(call);
        CALLS.execute(task);
        return task;
    }

    /** Waits for the result of a call; throws an exception where the call fails or the host falls silent. */
    <T> T await(FutureTask<T> call) throws HostLostException {
        return await(call, notices);
    }

    /**
     * Waits as {@link #await(FutureTask)} does. An interrupt is kept for the caller: the host is as well as before.
     *
     * @param lines receives one line per silence of the host
     */
    <T> T await(FutureTask<T> call, Consumer<String> lines) throws HostLostException {
        boolean interrupted = false;
        try {
            while (true) {
                try {
                    return call.get(LOOK_MILLISECONDS, TimeUnit.MILLISECONDS);
                } catch (TimeoutException e) {
                    checkSilence(lines);
                } catch (ExecutionException e) {
                    throw HostFailure.because(e.getCause());
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private void checkSilence(Consumer<String> lines) throws HostLostException {
        long since = heard;
        double silent = (System.nanoTime() - since) * 1e-9;
        if (silent > RetryPolicy.LOST_SECONDS) {
            throw new HostLostException("silent for " + Math.round(silent) + " s",
                    HostLostException.Failure.CONNECTION, null);
        }
        if (silent > NOTICED && noticed != since) {
            noticed = since;
            lines.accept("host " + name() + " silent for " + Math.round(silent) + " s");
        }
    }

    /** Gives the host up without a further call: ends the heartbeat and closes all connections. */
    public void abandon() {
        closed = true;
        heartbeat.interrupt();
        link.cut();
    }

    /** Ends the session; closes all connections where the host does not answer in a few seconds. */
    @Override
    public void close() {
        closed = true;
        heartbeat.interrupt();
        FutureTask<Void> end = start(() -> {
            remote.close(session);
            return null;
        });
        try {
            end.get((long) NOTICED, TimeUnit.SECONDS);
        } catch (ExecutionException | TimeoutException e) {
            link.cut();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
