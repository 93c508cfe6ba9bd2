package radiosity.torture;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** A process, what it prints, and signals to it. */
final class Running implements AutoCloseable {

    /** For so long, s, a process may do next to nothing: a share of a processor. */
    private static final double LONGEST_IDLE = 120;
    private static final double IDLE = .004;
    /** From such a wait for a processor on, s, and so many times the time that it computed, a process is starved. */
    private static final double LONGEST_WAIT = 5;
    private static final double BUSY = 10;

    private final List<String> command;
    private final Process process;
    private final long begin = System.nanoTime();
    private final StringBuffer printed = new StringBuffer();
    private final Thread reader = new Thread(this::read, "reads a process");
    private volatile long end;
    private volatile double waited;
    /** Seconds that those threads waited that had not ended when that was asked last. */
    private double alive;
    private volatile double computed;
    /** Seconds computed and waited when it was last seen to go on, and since when, s after the start. */
    private double before;
    private double since;

    /**
     * How a process ended.
     *
     * @param command  what was started
     * @param exitCode 128 + the signal's number where a signal ended it
     * @param printed  standard output and errors together
     * @param seconds  wall time
     */
    record Ended(List<String> command, int exitCode, String printed, double seconds) {
    }

    Running(Subject subject, List<String> command, Path directory) throws IOException {
        this.command = command;
        process = subject.start(command, directory);
        reader.setDaemon(true);
        reader.start();
    }

    private void read() {
        byte[] buffer = new byte[8192];
        try (InputStream in = process.getInputStream()) {
            for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
                printed.append(new String(buffer, 0, n, StandardCharsets.UTF_8));
            }
        } catch (IOException e) {
            printed.append("\n[its output was cut off: ").append(e.getMessage()).append("]\n");
        }
        end = System.nanoTime();
    }

    /** Waits until the output holds a text, as long as {@link #await} waits. */
    boolean awaitText(String text, double most) throws InterruptedException {
        since = seconds();
        while (printed.indexOf(text) < 0 && process.isAlive() && !isStuck(most)) {
            Thread.sleep(20);
        }
        return printed.indexOf(text) >= 0;
    }

    /** Whether it took more CPU seconds, or had nothing to do for long. */
    private boolean isStuck(double most) {
        computed = processorTime();
        waitingTime();
        if (computed + waited > before + IDLE * LONGEST_IDLE) {
            before = computed + waited;
            since = seconds();
        }
        return computed > most || seconds() - since > LONGEST_IDLE;
    }

    /** Seconds since it was started. */
    double seconds() {
        return (System.nanoTime() - begin) * 1e-9;
    }

    boolean isAlive() {
        return process.isAlive();
    }

    /** kill -9. */
    void kill() {
        process.destroyForcibly();
    }

    /** @param name TERM, STOP, CONT, ... */
    void signal(String name) throws IOException, InterruptedException {
        new ProcessBuilder("kill", "-" + name, Long.toString(process.pid())).redirectErrorStream(true).start()
                .waitFor();
    }

    /** CPU seconds so far, with the processes that it started; 0 where the system does not say. */
    double processorTime() {
        return Stream.concat(Stream.of(process.toHandle()), process.descendants())
                .flatMap(each -> each.info().totalCpuDuration().stream()).mapToDouble(time -> time.toMillis() * 1e-3)
                .sum();
    }

    /**
     * Seconds that threads were ready so far and got no processor, summed over threads and over the processes that it
     * started, as far as that was looked at; 0 where the system does not say.
     */
    synchronized double waitingTime() {
        if (process.isAlive()) {
            double now = Stream.concat(Stream.of(process.toHandle()), process.descendants())
                    .map(each -> new File("/proc/" + each.pid() + "/task").listFiles()).filter(Objects::nonNull)
                    .flatMap(Stream::of).mapToDouble(Running::waitingTime).sum();
            waited += Math.max(0, now - alive);
            alive = now;
        }
        return waited;
    }

    private static double waitingTime(File thread) {
        try {
            return 1e-9 * Long.parseLong(Files.readString(thread.toPath().resolve("schedstat")).split(" ")[1]);
        } catch (IOException e) {
            return 0; // it has ended
        }
    }

    /** Whether the machine was so busy with others that this process, up to now or to its end, hardly computed. */
    boolean starved() {
        computed = process.isAlive() ? processorTime() : computed;
        return waitingTime() > LONGEST_WAIT && waited > BUSY * computed;
    }

    /**
     * Waits for the end, however slow the machine is, as long as the process computes.
     *
     * @param most CPU seconds
     * @return null if it took more, or had nothing to do for long; it is killed then, after it has printed its threads
     */
    Ended await(double most) throws IOException, InterruptedException {
        since = seconds();
        while (!process.waitFor(200, TimeUnit.MILLISECONDS)) {
            if (isStuck(most)) {
                signal("QUIT");
                Thread.sleep(1000);
                close();
                return null;
            }
        }
        reader.join(5000);
        return new Ended(command, process.exitValue(), printed.toString(), (end - begin) * 1e-9);
    }

    String printed() {
        return printed.toString();
    }

    @Override
    public void close() {
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly().onExit().join();
    }
}
