package radiosity.torture;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** A PartitionServer on this machine. */
final class Worker implements AutoCloseable {

    /** CPU seconds that no start takes. */
    private static final double PATIENCE = 60;

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

    static int freePort() throws IOException {
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            return socket.getLocalPort();
        }
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
