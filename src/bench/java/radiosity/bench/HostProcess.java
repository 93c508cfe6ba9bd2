package radiosity.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import radiosity.rmi.HostAddress;

/** A host that is a process of its own on this machine. */
final class HostProcess implements AutoCloseable {

    private final int port = freePort();
    private final Process process;

    /** @param program main class, which takes -port and -t, and says when it listens */
    HostProcess(String program, String... flags) throws IOException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(List.of(flags));
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), program, "-port", "" + port, "-t", "1"));
        process = new ProcessBuilder(command).redirectErrorStream(true).start();
    }

    static int freePort() throws IOException {
        try (ServerSocket socket = new ServerSocket(0)) {
            return socket.getLocalPort();
        }
    }

    static List<HostProcess> start(int hosts, String program, String... flags) throws IOException {
        List<HostProcess> started = new ArrayList<>();
        for (int h = 0; h < hosts; h++) {
            started.add(new HostProcess(program, flags));
        }
        for (HostProcess host : started) {
            host.awaitListening();
        }
        return started;
    }

    static void end(List<HostProcess> hosts) {
        hosts.forEach(HostProcess::close);
    }

    private void awaitListening() throws IOException {
        BufferedReader out = process.inputReader();
        String line = out.readLine();
        if (line == null || !line.contains("listening on port " + port)) {
            throw new IOException("expected a host that listens, got " + line);
        }
    }

    HostAddress address() {
        return new HostAddress("localhost", port);
    }

    /** Processor time so far, s. */
    double cpu() {
        return process.info().totalCpuDuration().orElse(Duration.ZERO).toNanos() * 1e-9;
    }

    long id() {
        return process.pid();
    }

    @Override
    public void close() {
        process.destroyForcibly();
    }
}
