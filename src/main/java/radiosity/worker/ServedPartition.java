package radiosity.worker;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.SecureRandom;
import java.time.LocalTime;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import radiosity.partition.BlockCosts;
import radiosity.protocol.BlockTakeover;
import radiosity.protocol.Greeting;
import radiosity.protocol.Reply;
import radiosity.protocol.SceneBytes;
import radiosity.protocol.Wire;
import radiosity.rmi.Build;
import radiosity.rmi.RemotePartition;
import radiosity.rmi.SessionEndedException;
import radiosity.setup.InitialMesh;
import radiosity.util.Pieces;

/**
 * The partition that a host exports. A host serves one master at a time, in a session with the scene, some blocks, and
 * the last answers.
 *
 * <p>A session whose master is silent for {@value #LEASE_SECONDS} s ends; its number is refused from then on. Any
 * thread may call: {@code this} guards the current session, and each session guards its computation.
 */
public final class ServedPartition implements RemotePartition {

    /** Silence of a master after which its session ends: just longer than the silence after which a host is lost. */
    static final int LEASE_SECONDS = 12;
    /** Silence of a master after which the next master may have the host. */
    private static final int TAKEOVER_SECONDS = 4;
    /** Bytes of block states in one answer, above which no further state is added. */
    private static final int ANSWER_BYTES = 8 << 20;
    /** Time between two checks whether the session of a waiting call has ended. */
    private static final int LOOK_MILLISECONDS = 200;

    private final long server = new SecureRandom().nextLong();
    private final int threads;
    private final Consumer<String> log;
    private final LongSupplier clock;

    /** The session, or null; guarded by {@code this}, which is never locked for long. */
    private Session current;

    /** One session of a master; its lock is held while the host computes. */
    static final class Session {
        final long id;
        final String master;
        final String since = LocalTime.now().format(DateTimeFormatter.ofPattern("HH:mm"));
        /** Time of the master's last call, ns. */
        volatile long heard;
        /** The parts of the message that the master is sending. */
        final List<byte[]> inbox = new ArrayList<>();
        HostedBlocks blocks;
        InitialMesh mesh;
        /** Number of the last round that was begun. */
        long number;
        /** Replies to the last rounds, by number: a call whose reply was lost is made again. */
        final TreeMap<Long, byte[]> answers = new TreeMap<>();

        Session(long id, String master) {
            this.id = id;
            this.master = master;
        }
    }

    /** @param log receives one line for each session that begins or ends */
    public ServedPartition(int threads, Consumer<String> log) {
        this(threads, log, System::nanoTime);
    }

    /** @param clock clock of which only differences are used, ns */
    ServedPartition(int threads, Consumer<String> log, LongSupplier clock) {
        this.threads = threads;
        this.log = log;
        this.clock = clock;
    }

    @Override
    public synchronized byte[] greet() {
        expire(TAKEOVER_SECONDS);
        String busy = current == null ? "" : "busy for " + current.master + " since " + current.since;
        return new Greeting(Build.version(), Build.id(), threads, busy, server).encode();
    }

    @Override
    public synchronized void open(long id, byte[] master) {
        expire(TAKEOVER_SECONDS);
        if (current != null) {
            throw new IllegalStateException("busy for " + current.master + " since " + current.since);
        }
        current = new Session(id, new String(master, StandardCharsets.UTF_8).replaceAll("[^\\w.@-]", "?"));
        current.heard = clock.getAsLong();
        log.accept("working for " + current.master);
    }

    /** Ends the session, and frees its memory, if its master has been silent for too long. */
    void expire() {
        expire(LEASE_SECONDS);
    }

    private synchronized void expire(int seconds) {
        if (current != null && clock.getAsLong() - current.heard > seconds * 1_000_000_000L) {
            String gone = current.master;
            current = null; // first, as the log may fail
            log.accept(gone + " is gone");
        }
    }

    private synchronized Session session(long id) throws SessionEndedException {
        if (current == null || current.id != id) {
            throw new SessionEndedException();
        }
        current.heard = clock.getAsLong();
        return current;
    }

    private synchronized void check(Session session) throws SessionEndedException {
        if (current != session) {
            throw new SessionEndedException();
        }
    }

    @Override
    public void ping(long id) throws SessionEndedException {
        session(id);
    }

    @Override
    public void send(long id, byte[] part) throws SessionEndedException {
        Session session = session(id);
        synchronized (session) {
            session.inbox.add(part);
        }
    }

    /** Takes the message that the master has sent out of the inbox. */
    private static DataInputStream message(Session session) {
        List<byte[]> parts = List.copyOf(session.inbox);
        session.inbox.clear();
        return new DataInputStream(Pieces.open(parts));
    }

    /** A computation for a session. */
    interface Work<T> {
        T on(Session session) throws IOException;
    }

    <T> T inSession(long id, Work<T> work) throws SessionEndedException {
        Session session = session(id);
        synchronized (session) {
            try {
                return work.on(session);
            } catch (SessionEndedException e) {
                throw e;
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            } catch (OutOfMemoryError e) {
                logOutOfMemory();
                throw e;
            }
        }
    }

    private void logOutOfMemory() {
        try {
            log.accept("out of memory: give it JAVA_OPTS=-Xmx with more");
        } catch (RuntimeException | OutOfMemoryError e) {
            // the master is told in any case
        }
    }

    @Override
    public byte[] mesh(long id) throws SessionEndedException {
        return inSession(id, session -> {
            SceneBytes.Task task = SceneBytes.read(message(session));
            session.mesh = new InitialMesh(task.scene(), task.settings());
            session.blocks = new HostedBlocks(session.mesh, threads);
            return session.mesh.fingerprint().getBytes(StandardCharsets.UTF_8);
        });
    }

    @Override
    public byte[] take(long id) throws SessionEndedException {
        return inSession(id, session -> {
            List<byte[]> answers = session.blocks.take(BlockTakeover.read(message(session)));
            return Wire.bytes(out -> Wire.write(out, answers));
        });
    }

    @Override
    public void know(long id) throws SessionEndedException {
        inSession(id, session -> {
            session.blocks.know(Wire.shots(message(session)));
            return null;
        });
    }

    @Override
    public byte[] border(long id) throws SessionEndedException {
        return inSession(id, session -> session.blocks.border());
    }

    @Override
    public void share(long id) throws SessionEndedException {
        inSession(id, session -> {
            session.blocks.share(message(session));
            return null;
        });
    }

    @Override
    public byte[] round(long id, long number, byte[][] order) throws SessionEndedException {
        return inSession(id, session -> {
            awaitTurn(session, number);
            if (number > session.number) {
                session.number = number;
                session.answers.headMap(number - MOST_IN_FLIGHT).clear();
                session.answers.put(number, round(session.blocks, order));
                session.notifyAll();
            }
            if (!session.answers.containsKey(number)) {
                throw new IllegalStateException("round " + number + ": expected to be asked for once, as it failed");
            }
            return session.answers.get(number);
        });
    }

    /** Waits until all earlier rounds are begun: calls may overtake each other, but rounds are done in their order. */
    private void awaitTurn(Session session, long number) throws SessionEndedException {
        try {
            while (number > session.number + 1) {
                check(session);
                session.wait(LOOK_MILLISECONDS);
            }
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    /**
     * Processor time so far, s: of this thread where no other thread computes, else of the process; 0 where it cannot
     * be measured. Unlike wall time, processor time means something on a busy machine.
     */
    private double processorSeconds() {
        if (threads == 1) {
            return BlockCosts.now() * 1e-9;
        }
        return ManagementFactory.getOperatingSystemMXBean() instanceof com.sun.management.OperatingSystemMXBean system
                ? system.getProcessCpuTime() * 1e-9 : 0;
    }

    private byte[] round(HostedBlocks blocks, byte[][] order) throws IOException {
        long begin = System.nanoTime();
        double cpu = processorSeconds();
        byte[] answer = blocks.round(new DataInputStream(Pieces.open(List.of(order))));
        double spent = processorSeconds() - cpu;
        return new Reply(answer, spent, (System.nanoTime() - begin) * 1e-9, blocks.work(spent), blocks.given())
                .encode();
    }

    @Override
    public byte[] blocks(long id, byte[] blocks) throws SessionEndedException {
        return inSession(id, session -> Wire.bytes(out -> {
            for (ByteBuffer in = ByteBuffer.wrap(blocks); in.remaining() >= Integer.BYTES
                    && out.size() < ANSWER_BYTES;) {
                Wire.write(out, session.blocks.block(in.getInt()));
            }
        }));
    }

    @Override
    public synchronized void close(long id) {
        if (current != null && current.id == id) {
            String finished = current.master;
            current = null; // first, as the log may fail
            log.accept(finished + " has finished");
        }
    }
}
