package radiosity.master.host;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import radiosity.protocol.Greeting;
import radiosity.protocol.SceneBytes;
import radiosity.rmi.Build;
import radiosity.rmi.HostFailure;
import radiosity.rmi.HostLostException;
import radiosity.rmi.HostLostException.Failure;
import radiosity.rmi.RemotePartition;

/** Opens sessions with all hosts at the start; from then on a thread looks for the hosts that are missing. */
public final class HostFinder implements AutoCloseable {

    /** Time in which a host must open a session, not counting the time for which it may be busy. */
    private static final int CONNECT_SECONDS = 5;
    private static final int RETRY_SECONDS = 2;
    /** Time for which a host may be busy at the start: hosts are, for a while after their master was killed. */
    private static final int BUSY_SECONDS = 6;
    private static final int BUSY_LOOK_MILLISECONDS = 300;

    private final byte[] task;
    private final String fingerprint;
    private final Consumer<String> notices;
    private final String master = System.getProperty("user.name", "somebody");
    private final Queue<Link> missing = new ConcurrentLinkedQueue<>();
    private final Queue<Host> arrived = new ConcurrentLinkedQueue<>();
    /** The link by which each server was found first, by {@link Greeting#server}. */
    private final Map<Long, Link> servers = new ConcurrentHashMap<>();
    private volatile boolean closed;

    /** @param task scene and settings, as {@link SceneBytes} writes them */
    public HostFinder(byte[] task, String fingerprint, Consumer<String> notices) {
        this.task = task;
        this.fingerprint = fingerprint;
        this.notices = notices;
    }

    /** A host cannot be used at all, as it runs another version of the program or is used by another name. */
    private static final class RefusedException extends IOException {
        private static final long serialVersionUID = 1;

        RefusedException(String message) {
            super(message);
        }
    }

    /**
     * The hosts that can be used, in the order of the links; from now on a thread looks for the others.
     *
     * @throws IllegalStateException where the calling thread is interrupted; no session stays open then
     */
    public List<Host> open(List<Link> links) {
        List<CompletableFuture<Host>> opening = new ArrayList<>();
        try {
            links.forEach(link -> opening.add(CompletableFuture.supplyAsync(() -> open(link, true), Host.CALLS)));
            List<Host> hosts = opening.stream().map(HostFinder::result).filter(host -> host != null).toList();
            Thread retry = new Thread(this::look, "missing hosts");
            retry.setDaemon(true);
            retry.start();
            return hosts;
        } catch (RuntimeException | Error e) {
            opening.forEach(HostFinder::closeOnceOpen);
            throw e;
        }
    }

    private static Host result(CompletableFuture<Host> opening) {
        try {
            return opening.get();
        } catch (ExecutionException e) {
            throw new IllegalStateException(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException(e);
        }
    }

    /** Closes a host as soon as its session is open, as the heartbeat would keep that host busy. Waits for nothing. */
    private static void closeOnceOpen(CompletableFuture<Host> opening) {
        opening.thenAcceptAsync(host -> {
            if (host != null) {
                host.close();
            }
        }, Host.CALLS);
    }

    /** A host with a session, or null where no session can be opened now; with {@code notify} the user learns why. */
    private Host open(Link link, boolean notify) {
        CompletableFuture<Host> opening = new CompletableFuture<>();
        Host.start(() -> session(link, notify, opening));
        try {
            Host host = opening.orTimeout(CONNECT_SECONDS + (notify ? BUSY_SECONDS : 0), TimeUnit.SECONDS).get();
            load(host, notify);
            return host;
        } catch (ExecutionException e) {
            if (e.getCause() instanceof TimeoutException) {
                link.cut();
                return later(link, notify, "no answer");
            }
            return e.getCause() instanceof RefusedException refused ? never(link, " " + refused.getMessage())
                    : later(link, notify, HostFailure.words(e.getCause()));
        } catch (HostLostException e) {
            return e.failure() == Failure.MESSAGE ? never(link, ": " + e.getMessage() + "; starting without it")
                    : later(link, notify, e.getMessage());
        } catch (OutOfMemoryError e) {
            return later(link, notify, "out of memory here");
        } catch (InterruptedException e) {
            opening.completeExceptionally(e);
            closeOnceOpen(opening);
            Thread.currentThread().interrupt();
            return later(link, notify, "interrupted");
        }
    }

    /** Sends the scene; a host that cannot take it is closed, as the heartbeat would keep that host busy. */
    private void load(Host host, boolean notify) throws HostLostException {
        try {
            host.await(Host.start(() -> host.load(task, fingerprint)), notify ? notices : line -> { });
        } catch (HostLostException | RuntimeException | Error e) {
            host.close();
            throw e;
        }
    }

    private Host later(Link link, boolean notify, String why) {
        if (notify) {
            notices.accept("host " + link.name() + ": " + why + "; starting without it");
        }
        missing.add(link);
        return null;
    }

    private Host never(Link link, String why) {
        notices.accept("host " + link.name() + why);
        return null;
    }

    /**
     * The host's greeting; with {@code patient} waits for some seconds until the host is free.
     *
     * @param first greeting of the host just now
     */
    private static Greeting whenFree(RemotePartition remote, Greeting first, boolean patient) throws IOException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(patient ? BUSY_SECONDS : 0);
        Greeting greeting = first;
        while (!greeting.busy().isEmpty() && System.nanoTime() < end) {
            try {
                TimeUnit.MILLISECONDS.sleep(BUSY_LOOK_MILLISECONDS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                return greeting;
            }
            greeting = Greeting.decode(remote.greet());
        }
        return greeting;
    }

    /**
     * Opens a session and completes {@code opening} with the host, or with the reason why there is no session. A host
     * that comes after the time is closed, as the heartbeat would keep that host busy.
     */
    private Void session(Link link, boolean patient, CompletableFuture<Host> opening) {
        try {
            Host host = session(link, patient);
            if (!opening.complete(host)) {
                host.close();
            }
        } catch (IOException | RuntimeException | Error e) {
            opening.completeExceptionally(e);
        }
        return null;
    }

    private Host session(Link link, boolean patient) throws IOException {
        RemotePartition remote = link.connect();
        Greeting greeting = Greeting.decode(remote.greet());
        if (!greeting.build().equals(Build.id())) {
            throw new RefusedException(greeting.version().equals(Build.version())
                    ? "runs another build of " + Build.version() + ": copy the jar there"
                    : "runs " + greeting.version() + ", this is " + Build.version() + ": copy the jar there");
        }
        Link first = servers.putIfAbsent(greeting.server(), link);
        if (first != null && first != link) {
            throw new RefusedException("is " + first.name() + ", which is used already");
        }
        checkFree(whenFree(remote, greeting, patient));
        Host host = new Host(link, remote, greeting.processors(), notices);
        try {
            host.open(master);
        } catch (IllegalStateException e) {
            checkFree(Greeting.decode(remote.greet()));
            throw e;
        }
        return host;
    }

    private static void checkFree(Greeting greeting) throws IOException {
        if (!greeting.busy().isEmpty()) {
            throw new IOException(greeting.busy());
        }
    }

    /** Looks for a lost host from now on: it may come back. */
    public void lookFor(Link link) {
        missing.add(link);
    }

    public boolean hasCome() {
        return !arrived.isEmpty();
    }

    /** Removes and returns a host that has come and is ready to be given blocks; null where there is none. */
    public Host next() {
        return arrived.poll();
    }

    private void look() {
        while (!closed) {
            for (int n = missing.size(); n > 0 && !closed; n--) {
                Link link = missing.poll();
                Host host = link == null ? null : open(link, false);
                if (host != null) {
                    arrived.add(host);
                }
            }
            try {
                TimeUnit.SECONDS.sleep(RETRY_SECONDS);
            } catch (InterruptedException e) {
                return;
            }
        }
        close();
    }

    @Override
    public void close() {
        closed = true;
        for (Host host = next(); host != null; host = next()) {
            host.close();
        }
    }
}
