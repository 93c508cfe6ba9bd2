package radiosity.distributed;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** PartitionServer as a process of its own, which can be killed and stopped. */
final class Server implements AutoCloseable {

    private final int port;
    private final Process process;
    private final BufferedReader out;

    Server() throws IOException {
        this(List.of(), Small.freePort());
    }

    /** @param before what stands before the command */
    Server(List<String> before, int port) throws IOException {
        this.port = port;
        process = start(before, "radiosity.cli.PartitionServer", "-port", "" + port, "-t", "1");
        out = process.inputReader();
        String line = out.readLine();
        if (line == null || !line.contains("listening on port " + port)) {
            throw new IOException("expected a server that listens, got " + line);
        }
    }

    static Process start(String program, String... arguments) throws IOException {
        return start(List.of(), program, arguments);
    }

    private static Process start(List<String> before, String program, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(before);
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.add("-Xmx512m");
        command.add("-cp");
        command.add(System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")));
        command.add(program);
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command).redirectErrorStream(true).start();
    }

    int port() {
        return port;
    }

    String address() {
        return "localhost:" + port;
    }

    /** kill -9. */
    void kill() {
        process.destroyForcibly();
    }

    void signal(String name) throws IOException, InterruptedException {
        new ProcessBuilder("kill", "-" + name, "" + process.pid()).start().waitFor();
    }

    /** What the server has printed since it listens, until its end. */
    String rest() {
        return String.join("\n", out.lines().toList());
    }

    int exitCode() throws InterruptedException {
        return process.waitFor();
    }

    @Override
    public void close() {
        process.destroyForcibly().onExit().join();
    }
}
