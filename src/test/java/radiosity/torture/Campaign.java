package radiosity.torture;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntPredicate;
import java.util.stream.Stream;

/**
 * Runs, one after another, until a time is over or there were enough.
 *
 * <p>Kinds of scenes, faults and options come in turns, each in an order that the seed decides, so that none is left
 * out. A run's number and the seed decide everything about it.
 */
final class Campaign {

    private final Subject subject;
    private final Path directory;
    private final PrintStream out;
    private final boolean keep;
    private final Tally tally = new Tally();
    private final Toolbox tools;
    private final Menu menu;
    private final List<String> options;
    private final AtomicInteger next = new AtomicInteger();
    private final AtomicInteger failed = new AtomicInteger();
    private final List<String> failures = Collections.synchronizedList(new ArrayList<>());

    /**
     * @param directory for all files; those of failed runs stay
     * @param keep      whether the files of sound runs stay too
     */
    Campaign(Subject subject, Menu menu, Path directory, PrintStream out, boolean keep)
            throws IOException, InterruptedException {
        this.menu = menu;
        this.keep = keep;
        this.subject = subject.copied(directory.resolve("program"));
        this.directory = directory;
        this.out = out;
        Set<String> known = this.subject.options();
        tools = new Toolbox(directory, known);
        options = RandomCommand.OPTIONS.stream().filter(known::contains).toList();
        if (options.isEmpty()) {
            throw new IOException("--help: expected options, got none");
        }
        tally.expect("scene", menu.kinds().stream().map(Enum::name).distinct().toList());
        tally.expect("option", options);
        tally.expect("fault", menu.faults().stream().map(Enum::name).toList());
        known.stream().filter(option -> !RandomCommand.OPTIONS.contains(option)).sorted()
                .forEach(option -> tally.note("not tortured: option " + option));
    }

    /**
     * Runs until it is not to go on, several at once.
     *
     * @param seed     of the campaign
     * @param only     the number of the one run that is repeated, or -1 for 0, 1, 2, ...
     * @param parallel how many runs at once
     * @param goOn     whether to begin one more, by the number of those that have begun
     */
    void run(long seed, int only, int parallel, IntPredicate goOn) throws IOException, InterruptedException {
        List<Callable<Void>> lanes = Collections.nCopies(parallel, () -> {
            for (int n = next.getAndIncrement(); goOn.test(n); n = next.getAndIncrement()) {
                run(seed, only >= 0 ? only : n, n);
            }
            return null;
        });
        ExecutorService executor = Executors.newFixedThreadPool(parallel);
        try {
            for (Future<Void> lane : executor.invokeAll(lanes)) {
                lane.get();
            }
        } catch (ExecutionException e) {
            throw new IOException("the campaign itself failed: " + e.getCause(), e);
        } finally {
            executor.shutdownNow();
        }
    }

    private void run(long seed, int index, int number) throws IOException, InterruptedException {
        SceneKind kind = Menu.turn(menu.kinds(), seed, index, 1);
        Fault fault = Menu.turn(menu.faults(), seed, index, 2);
        String option = Menu.turn(options, seed, index, 3);
        Path files = Files.createDirectories(directory.resolve("run-" + seed + "." + index + "-" + number));
        TortureRun run = new TortureRun(subject, tally, tools, files, Dice.mixed(seed) + index, kind, fault, option);
        long begin = System.nanoTime();
        List<String> wrong = run.run();
        failures.addAll(wrong);
        tally.count("scene", kind.name());
        report(String.format(Locale.ROOT, "%d.%d %s %s %s: %s, %.0f s", seed, index, kind, fault, option,
                wrong.isEmpty() ? run.outcome() : "FAILED", (System.nanoTime() - begin) * 1e-9), wrong, files);
        if (!wrong.isEmpty()) {
            failed.incrementAndGet();
        }
        if (wrong.isEmpty() && !keep) {
            delete(files);
        } else {
            Files.writeString(files.resolve("log"), run.log());
        }
    }

    private synchronized void report(String line, List<String> wrong, Path files) {
        out.println(line);
        wrong.forEach(failure -> out.println("    " + failure));
        if (!wrong.isEmpty()) {
            String seed = line.substring(0, line.indexOf(' '));
            out.println("    again: --seed " + seed + "; files and commands (log): " + files);
        }
    }

    int failed() {
        return failed.get();
    }

    /** What was wrong, of all runs. */
    List<String> failures() {
        return failures;
    }

    Tally tally() {
        return tally;
    }

    private static void delete(Path directory) throws IOException {
        try (Stream<Path> files = Files.walk(directory)) {
            for (Path path : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(path);
            }
        }
    }
}
