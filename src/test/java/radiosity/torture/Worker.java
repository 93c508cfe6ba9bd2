package radiosity.torture;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;

/** A PartitionServer on this machine. */
final class Worker implements AutoCloseable {

    /** CPU seconds that no start takes. */
    private static final double PATIENCE = 60;

    private static final int FIRST_PORT = 20_000;
    private static final int PORTS = 10_000;
    /** Campaigns at the same time begin at different ports. */
    private static final AtomicInteger NEXT = new AtomicInteger((int) (ProcessHandle.current().pid() * 97 % PORTS));

    final int port;
    private final Subject subject;
    private final List<String> java;
    private final Path key;
    private final int threads;
    private final Path directory;
    private Running running;

    /** @param key null for none */
    Worker(Subject subject, List<String> java, Path key, int threads, Path directory) throws IOException {
        this.subject = subject;
        this.java = java;
        this.key = key;
        this.threads = threads;
        this.directory = directory;
        port = freePort();
    }

    /**
     * A port that nobody listens on, below those that systems give to outgoing connections: until the worker listens,
     * and while it is restarted, no connection takes the port.
     */
    static int freePort() throws IOException {
        for (int tries = 0; tries < PORTS; tries++) {
            int port = FIRST_PORT + Math.floorMod(NEXT.getAndIncrement(), PORTS);
            try (ServerSocket socket = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
                return socket.getLocalPort();
            } catch (BindException e) {
                // somebody listens there: the next one
            }
        }
        throw new IOException("expected a free port from " + FIRST_PORT + " on, got none of " + PORTS);
    }

    void start() throws IOException {
        List<String> arguments = new ArrayList<>(List.of("-port", "" + port, "-t", "" + threads, "-bind", "127.0.0.1"));
        if (key != null) {
            arguments.addAll(List.of("-key", key.toString()));
        }
        running = new Running(subject, subject.command(subject.server(), java, arguments), directory);
    }

    void awaitListening() throws IOException, InterruptedException {
        if (!running.awaitText("listening on port", PATIENCE)) {
            throw new IOException("expected a PartitionServer that listens, got " + running.printed());
        }
    }

    Running running() {
        return running;
    }

    String address() {
        return "localhost:" + port;
    }

    @Override
    public void close() {
        if (running != null) {
            running.close();
        }
    }
}
