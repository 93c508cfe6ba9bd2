package radiosity.torture;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * One run of a campaign: a scene is rendered undisturbed, then otherwise and with a fault, and what came out is
 * compared.
 *
 * <p>All of it follows from its seed but the moments at which faults strike: they are parts of the time that the
 * undisturbed render took.
 */
final class TortureRun {

    private static final Set<Integer> DONE = Set.of(0, 5);
    private static final int NO_WORKER = 4;
    private static final Set<String> STOP = Set.of("-it", "-se");
    /** What the undisturbed render does without: it must not matter. */
    private static final Set<String> NO_MATTER = Set.of("-q", "--debug", "-si", "-sn", "-dr");
    private static final Pattern REPRODUCED = Pattern.compile("the same as with ((?:--?[a-z][\\w-]* [^\\s;]+ ?)+)");
    private static final Pattern CUT_OFF =
            Pattern.compile("in the first calculation, the one of (--accuracy [^\\s,;]+)");
    /** Seconds from a signal to the end, beside those in which others have the processors; the program promises 10. */
    private static final double LONGEST_END = 15;

    private final Subject subject;
    private final Tally tally;
    private final Toolbox tools;
    private final Path directory;
    private final Dice dice;
    private final Checks checks = new Checks();
    private final SceneKind kind;
    private final String option;
    private final List<Worker> workers = new ArrayList<>();
    private final List<String> commands = new ArrayList<>();
    private final StringBuilder log = new StringBuilder();
    private String outcome = "sound";
    private Fault fault;
    private MadeScene scene;
    private RandomCommand command;
    private Path out;
    private Path output;
    /** What the undisturbed render gave, and how long it took, s. */
    private LightFile reference;
    private Running.Ended undisturbed;
    private List<String> compiler;
    private List<String> resumed = List.of();

    /** @param directory empty, for all files of the run */
    TortureRun(Subject subject, Tally tally, Toolbox tools, Path directory, long seed, SceneKind kind, Fault fault,
               String option) {
        this.subject = subject;
        this.tally = tally;
        this.tools = tools;
        this.directory = directory;
        this.kind = kind;
        this.fault = fault;
        this.option = option;
        dice = new Dice(seed);
    }

    /** @return what was wrong */
    List<String> run() throws IOException, InterruptedException {
        log.append("$ export CLASSPATH=").append(subject.classPath()).append('\n');
        prepare();
        try {
            if (fault == Fault.WRONG_COMMAND) {
                wrongCommand();
            } else if (undisturbed()) {
                startWorkers();
                firstPart();
                disturbed();
                information();
            }
        } finally {
            workers.forEach(Worker::close);
        }
        return checks.failures();
    }

    /** In a word. */
    String outcome() {
        return outcome;
    }

    /** What was started, and what it printed. */
    String log() {
        return log.toString();
    }

    private void prepare() throws IOException {
        boolean apart = !kind.isShipped() && (option.equals("--map") || option.equals("--content") || dice.chance(.2));
        scene = kind.make(dice, directory, subject.shipped(), apart);
        command = new RandomCommand(dice, scene, option, tools.options(), directory);
        if (fault.needsWorkers() || fault == Fault.NO_WORKER) {
            command.runOptions.add("-h");
        }
        if (command.runOptions.contains("-key") || command.runOptions.contains("--statistics")) {
            command.runOptions.add("-h");
        }
        if (fault.needsTerminal() && !tools.hasTerminal()) {
            skipFault("needs python3 for a terminal");
        }
        compiler = dice.of(List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC"),
                List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC"), List.of("-XX:+UseParallelGC"),
                List.of("-XX:-TieredCompilation", "-XX:+UseSerialGC"));
        out = Files.createDirectories(directory.resolve("out"));
        output = out.resolve("out.scene");
        if (dice.chance(.5)) {
            Files.writeString(output, Checks.OLD);
        }
    }

    private void skipFault(String why) {
        tally.note("skipped: " + fault + " (" + why + ")");
        fault = Fault.NONE;
    }

    private String memory() {
        return kind == SceneKind.STUDY ? "-Xmx2g" : "-Xmx768m";
    }

    private List<String> java() {
        List<String> java = new ArrayList<>(compiler);
        java.add(memory());
        return java;
    }

    /** CPU seconds that no process takes. */
    private double patience() {
        return kind == SceneKind.STUDY ? 900 : 150;
    }

    private Running start(List<String> words, List<String> java) throws IOException {
        return start(subject.command(subject.renderer(), java, words));
    }

    private Running start(List<String> words) throws IOException {
        log.append("$ ").append(String.join(" ", words)).append('\n');
        return new Running(subject, words, directory);
    }

    /** Waits for the end, and looks at how it ended; null where that never came. */
    private Running.Ended end(String what, Running running, Set<Integer> allowed)
            throws IOException, InterruptedException {
        Running.Ended ended = running.await(patience());
        if (ended == null) {
            checks.fail(what + ": no end after " + (int) running.seconds() + " s and " + running.processorTime()
                    + " s of CPU time");
            log.append(running.printed()).append("[no end]\n");
            return null;
        }
        log.append(ended.printed()).append("[exit code ").append(ended.exitCode()).append("]\n");
        if (ended.exitCode() == NO_WORKER && !allowed.contains(NO_WORKER) && isStarved(running)) {
            tally.count("not judged", "hosts that the busy machine kept from answering");
            return null;
        }
        checks.ended(what, ended, command.has("--debug"), allowed);
        return ended;
    }

    /** Whether who calls or who is called could not compute in time. */
    private boolean isStarved(Running master) {
        return Stream.concat(Stream.of(master), workers.stream().map(Worker::running)).filter(Objects::nonNull)
                .anyMatch(Running::starved);
    }

    private List<String> words(Object... parts) {
        List<String> words = new ArrayList<>();
        for (Object part : parts) {
            if (part instanceof List<?> list) {
                list.forEach(word -> words.add(word.toString()));
            } else {
                words.add(part.toString());
            }
        }
        return words;
    }

    /** Renders without hosts on one thread; false where the program refuses the scene or the options. */
    private boolean undisturbed() throws IOException, InterruptedException {
        if (command.timed) {
            undisturbed = new Running.Ended(List.of(), 0, "", 1.5);
            return true;
        }
        return reference(command.lightWithout(Set.of()));
    }

    private boolean reference(List<String> light) throws IOException, InterruptedException {
        Path there = Files.createDirectories(directory.resolve("reference"));
        Path file = there.resolve("out.scene");
        List<String> words = words(light, "-t", 1, command.restIn(there, NO_MATTER), scene.file(), file);
        List<String> java = List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", memory());
        Running.Ended ended = end("undisturbed", start(words, java), Set.of(0, 1, 2, 3, 5));
        undisturbed = ended;
        if (ended == null || !DONE.contains(ended.exitCode())) {
            refused(ended);
            return false;
        }
        reference = checks.whole("undisturbed", file);
        if (reference == null) {
            return false;
        }
        checks.reflected("undisturbed", reference);
        energy();
        return true;
    }

    /**
     * No energy is gained, and what is finished is nowhere negative. Where surfaces overlap it is, today, and where
     * rays are few or form factors are the paper's; that is counted apart and no failure.
     */
    private void energy() {
        Energy energy = new Energy(reference, scene.lightFlux(), 1);
        double found = energy.found();
        tally.energy(kind + (command.isExact() ? "" : ", coarse by hand") + (kind.overlaps() ? ", overlapping" : ""),
                found);
        if (found > Energy.MOST && command.isExact() && !kind.overlaps()) {
            checks.fail("energy gained: " + found + " of what was emitted was absorbed or escaped");
        }
        if (command.isFinished() && energy.lowest() < Energy.LOWEST) {
            checks.fail("negative: a radiosity of " + energy.lowest() + " of the mean");
        }
    }

    /** What is refused is refused in one line, beside warnings. */
    private void refused(Running.Ended ended) {
        tally.count("refused", kind.name());
        outcome = ended == null ? "refused" : "refused (" + ended.printed().strip() + ")";
        boolean failed = ended != null && ended.exitCode() == 1 && !ended.printed().contains("memory: expected more than ");
        if (failed || ended != null && ended.exitCode() == 2 || ended != null && !ended.printed().contains("expected ")) {
            checks.fail("undisturbed: refused: " + ended.printed().strip());
        }
    }

    private void startWorkers() throws IOException, InterruptedException {
        if (!command.runOptions.contains("-h") || fault == Fault.NO_WORKER) {
            return;
        }
        Path key = command.runOptions.contains("-key") ? tools.key() : null;
        int count = fault == Fault.WORKERS_KILLED || fault == Fault.WORKER_HEAP || dice.chance(.7) ? 2 : 3;
        for (int i = 0; i < count; i++) {
            List<String> java = new ArrayList<>(List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC",
                    fault == Fault.WORKER_HEAP && i == 0 ? "-Xmx" + dice.integer(10, 40) + "m" : memory()));
            Worker worker = new Worker(subject, java, key, dice.integer(1, 2), directory);
            workers.add(worker);
            if (fault != Fault.WORKER_LATE || i > 0) {
                worker.start();
            }
        }
        for (Worker worker : workers) {
            if (worker.running() != null) {
                worker.awaitListening();
            }
        }
    }

    /** With -tf or -dr: what the run goes on from. */
    private void firstPart() throws IOException, InterruptedException {
        boolean unrendered = command.has("-dr");
        if (command.timed || !unrendered && !command.runOptions.contains("-tf") && fault != Fault.DAMAGED_FILE) {
            return;
        }
        Path part = directory.resolve("part.scene");
        int shots = unrendered ? 0
                : Math.min(reference.shots(), dice.integer(0, Math.max(1, reference.shots())));
        List<String> stop = unrendered ? List.of("-dr") : List.of("-it", "" + shots);
        List<String> schedule = command.has("--schedule") ? List.of() : List.of("--schedule", command.schedule);
        List<String> words = words(command.lightWithout(unrendered ? STOP : Set.of("-it")), schedule, stop, "-t",
                dice.integer(1, 3), scene.file(), part);
        Running.Ended ended = end("first part", start(words, java()), DONE);
        LightFile light = ended == null ? null : checks.whole("first part", part);
        if (light != null) {
            resumed = List.of("-tf", part.toString(), "" + light.shots());
            tally.count("option", "-tf");
        }
    }

    /** All words of the disturbed render. */
    private List<String> everything(List<String> from) {
        List<String> words = words(command.lightWithout(Set.of()), from, "-t", dice.integer(1, 4), distributed(),
                command.restIn(out, Set.of("-dr")), scene.file(), output);
        return words;
    }

    private List<String> distributed() {
        List<String> words = new ArrayList<>();
        if (fault == Fault.NO_WORKER) {
            words.addAll(List.of("-h", "1", "localhost:1"));
        } else if (!workers.isEmpty()) {
            words.addAll(List.of("-h", "" + workers.size()));
            workers.forEach(worker -> words.add(worker.address()));
        }
        if (!words.isEmpty() && command.runOptions.contains("-key")) {
            words.addAll(List.of("-key", tools.key().toString()));
        }
        if (!words.isEmpty() && command.runOptions.contains("--statistics")) {
            words.add("--statistics");
        }
        return words;
    }

    /** A moment, s after the start: mostly within the time that the render takes. */
    private double moment() {
        double longer = workers.isEmpty() ? 1 : 1.5;
        return undisturbed.seconds() * longer * dice.between(.15, 1.05);
    }

    private void disturbed() throws IOException, InterruptedException {
        List<String> words = everything(resumed);
        countOptions(words);
        switch (fault) {
            case TERM, CONTROL_C, KEY, TERM_AGAIN_AND_AGAIN -> stopped(words);
            case MASTER_KILLED, MASTER_KILLED_AGAIN -> killed(words);
            case FULL_DISK -> fullDisk(words);
            case FILE_LIMIT -> fileLimit(words);
            case HEAP -> heap(words);
            case TWO_AT_ONCE -> twice(words);
            case NO_WORKER -> {
                end("no worker", start(words, java()), Set.of(4));
                struck();
                checks.oldOrWhole("no worker", output);
            }
            case DAMAGED_FILE -> damaged(words);
            case MASTER_PAUSED -> {
                Running master = start(words, java());
                Thread.sleep((long) (1000 * moment()));
                pause(master, dice.between(.2, 2));
                done(end("paused", master, DONE));
            }
            case NONE -> {
                struck();
                done(end("otherwise", start(words, java()), DONE));
            }
            default -> withWorkers(words);
        }
    }

    private void struck() {
        tally.count("fault", fault.name());
    }

    private void countOptions(List<String> words) {
        words.stream().filter(RandomCommand.OPTIONS::contains).distinct().filter(word -> !word.equals("-tf"))
                .forEach(word -> tally.count("option", word));
        if (command.has("-dr")) {
            tally.count("option", "-dr");
        }
        tally.count("schedule", command.schedule);
        tally.count("workers", "" + workers.size());
        tally.count("compiler", String.join(" ", compiler));
    }

    /** The render came to its end: what it wrote is what it should be. */
    private void done(Running.Ended ended) throws IOException, InterruptedException {
        if (ended == null || !DONE.contains(ended.exitCode())) {
            return;
        }
        LightFile got = checks.whole("done", output);
        if (got == null) {
            return;
        }
        checks.tidy("done", out);
        if (command.timed && !reproduced(ended, got)) {
            return;
        }
        if (undisturbed.exitCode() != ended.exitCode()) {
            checks.fail("exit code " + ended.exitCode() + ", undisturbed " + undisturbed.exitCode());
        }
        checks.same("done", reference, got);
        for (String file : List.of("points.csv", "picture.png", "picture.jpg", "picture.hdr")) {
            Path expected = directory.resolve("reference").resolve(file);
            if (Files.exists(expected)) {
                checks.sameBytes("done", expected, out.resolve(file));
            }
        }
        if (command.runOptions.contains("--change") && !command.timed && !command.has("-dr")) {
            unchanged();
        }
        if (command.runOptions.contains("--frames") && !command.frame().isEmpty() && !command.timed
                && !command.has("-dr") && !command.has("--grid") && scene.file().toString().endsWith(".lws")) {
            animation();
        }
    }

    /** An animation of one frame: the light is that of the frame. */
    private void animation() throws IOException, InterruptedException {
        String frame = command.frame();
        List<String> words = words(command.lightWithout(Set.of("--frame")), "--frames", frame + "-" + frame,
                scene.file(), directory.resolve("frames.scene"));
        Path made = directory.resolve(String.format("frames-%04d.scene", Integer.parseInt(frame)));
        LightFile light = end("animation", start(words, java()), DONE) == null ? null : checks.whole("animation", made);
        if (light != null) {
            checks.same("animation", reference, light);
            tally.count("option", "--frames");
        }
    }

    /** A change that is none: the light is the same. */
    private void unchanged() throws IOException, InterruptedException {
        Path more = directory.resolve("unchanged.scene");
        LightFile light = end("changing nothing", start(words(command.lightWithout(Set.of()), "--change", output,
                scene.file(), more), java()), DONE) == null ? null : checks.whole("changing nothing", more);
        if (light != null) {
            checks.same("changing nothing", reference, light);
            tally.count("option", "--change");
        }
    }

    /** After --time: calculates by the options that it printed. False where there is nothing to compare. */
    private boolean reproduced(Running.Ended ended, LightFile got) throws IOException, InterruptedException {
        Matcher options = REPRODUCED.matcher(ended.printed());
        Matcher cut = CUT_OFF.matcher(ended.printed());
        if (cut.find()) {
            timedAndCut(List.of(cut.group(1).split(" ")), got);
            return false;
        }
        if (!options.find()) {
            checks.fail("--time: expected the options that give the same, got " + ended.printed().strip());
            return false;
        }
        List<String> printed = List.of(options.group(1).split(" "));
        Set<String> replaced = new TreeSet<>(printed);
        replaced.add("--time");
        return reference(words(command.lightWithout(replaced), printed));
    }

    private void timedAndCut(List<String> accuracy, LightFile got) throws IOException, InterruptedException {
        List<String> light = words(command.lightWithout(Set.of("--time")), accuracy);
        if (reference(light)) {
            Path more = out.resolve("more.scene");
            Running.Ended ended = end("going on after --time", start(words(light, "-tf", output, got.shots(),
                    scene.file(), more), java()), DONE);
            LightFile whole = ended == null ? null : checks.whole("going on after --time", more);
            if (whole != null) {
                checks.same("going on after --time", reference, whole);
            }
        }
    }

    /** Ended early, saved; then gone on with, once or several times. */
    private void stopped(List<String> first) throws IOException, InterruptedException {
        List<String> words = first;
        int stops = fault == Fault.TERM_AGAIN_AND_AGAIN ? dice.integer(2, 4) : 1;
        for (int n = 0; n < stops; n++) {
            double moment = moment() / stops;
            boolean terminal = fault.needsTerminal();
            Running running = terminal ? start(tools.onTerminal(moment, fault == Fault.KEY ? 'x' : 3,
                    subject.command(subject.renderer(), java(), words))) : start(words, java());
            if (!terminal) {
                Thread.sleep((long) (1000 * moment));
                running.signal("TERM");
            }
            double waited = running.waitingTime();
            Running.Ended ended = end("stopped", running, stopCodes());
            if (ended == null) {
                return;
            }
            if (ended.seconds() > moment + LONGEST_END + running.waitingTime() - (terminal ? 0 : waited)) {
                checks.fail("stopped: " + (ended.seconds() - moment) + " s from the signal to the end");
            }
            boolean done = DONE.contains(ended.exitCode()) && !ended.printed().contains("stopping after this round");
            if (done) {
                done(ended);
                return;
            }
            struck();
            LightFile light = checks.oldOrWhole("stopped", output);
            if (light == null && DONE.contains(ended.exitCode())) {
                checks.fail("stopped: nothing was saved");
            }
            if (command.timed) {
                return;
            }
            words = light == null ? everything(resumed)
                    : everything(List.of("-tf", output.toString(), "" + light.shots()));
        }
        done(end("going on", start(words, java()), DONE));
    }

    private Set<Integer> stopCodes() {
        return fault == Fault.KEY ? DONE : Set.of(0, 5, fault == Fault.CONTROL_C ? 130 : 143);
    }

    private void killed(List<String> words) throws IOException, InterruptedException {
        for (int n = fault == Fault.MASTER_KILLED ? 1 : dice.integer(2, 3); n > 0; n--) {
            Running running = start(words, java());
            Thread.sleep((long) (1000 * moment()));
            if (running.isAlive()) {
                struck();
                running.kill();
            }
            running.await(patience());
            log.append(running.printed()).append("[killed]\n");
            checks.oldOrWhole("killed", output);
        }
        done(end("after kill -9", start(words, java()), DONE));
    }

    /** What fills up the disk is the scene file, or pictures and points after it. */
    private void fullDisk(List<String> words) throws IOException, InterruptedException {
        long size = command.timed ? 100_000 : Files.size(directory.resolve("reference/out.scene"));
        try (Toolbox.Disk disk = tools.disk(out, 4096 + (long) (size * dice.between(.1, 2.5)))) {
            if (disk == null) {
                skipFault("needs root and mount for a small disk");
                done(end("otherwise", start(words, java()), DONE));
                return;
            }
            Running.Ended ended = end("full disk", start(words, java()), Set.of(0, 5, 3));
            if (ended != null && ended.exitCode() == 3) {
                struck();
                expectLine(ended, "expected to be written, got ");
            }
            checks.oldOrWhole("full disk", output);
            disk.enlarge();
            done(end("on a larger disk", start(words, java()), DONE));
        }
    }

    private void expectLine(Running.Ended ended, String words) {
        if (!ended.printed().contains(words)) {
            checks.fail("expected a line with \"" + words + "\", got " + ended.printed().strip());
        }
    }

    private void fileLimit(List<String> words) throws IOException, InterruptedException {
        long size = command.timed ? 100_000 : Files.size(directory.resolve("reference/out.scene"));
        long blocks = 1 + (long) (size / 512.0 * dice.between(.05, 1.2));
        List<String> java = java();
        java.add("-XX:-UsePerfData");
        List<String> limited = words("sh", "-c", "ulimit -f " + blocks + "; exec \"$@\"", "sh",
                subject.command(subject.renderer(), java, words));
        Running.Ended ended = end("file limit", start(limited), Set.of(0, 5, 3));
        if (ended != null && ended.exitCode() == 3) {
            struck();
            expectLine(ended, "expected to be written, got ");
        }
        checks.oldOrWhole("file limit", output);
        done(end("without a limit", start(words, java()), DONE));
    }

    private void heap(List<String> words) throws IOException, InterruptedException {
        List<String> java = new ArrayList<>(compiler);
        java.add("-Xmx" + dice.integer(8, 40) + "m");
        Running.Ended ended = end("small heap", start(words, java), Set.of(0, 1, 2, 3, 5));
        if (ended == null) {
            return;
        }
        struck();
        if (DONE.contains(ended.exitCode())) {
            done(ended);
            return;
        }
        expectLine(ended, ended.exitCode() == 1 ? "memory: expected more than " : "expected ");
        checks.oldOrWhole("small heap", output);
        done(end("with a larger heap", start(words, java()), DONE));
    }

    /** At most one of them is refused; what is there in the end is whole and right. */
    private void twice(List<String> words) throws IOException, InterruptedException {
        Running one = start(words, java());
        Thread.sleep((long) (1000 * moment() / 2));
        if (one.isAlive()) {
            struck();
        }
        Running other = start(words, java());
        Set<Integer> allowed = workers.isEmpty() ? Set.of(0, 5, 3) : Set.of(0, 5, 3, 4);
        Running.Ended first = end("first of two", one, allowed);
        Running.Ended second = end("second of two", other, allowed);
        if (first != null && second != null) {
            if (!DONE.contains(first.exitCode()) && !DONE.contains(second.exitCode())) {
                checks.fail("both of two renders failed");
            }
            done(DONE.contains(second.exitCode()) ? second : first);
        }
    }

    /** A file that was cut off or changed is refused, or what was changed had no part in it. */
    private void damaged(List<String> words) throws IOException, InterruptedException {
        if (resumed.isEmpty()) {
            done(end("otherwise", start(words, java()), DONE));
            return;
        }
        Path part = Path.of(resumed.get(1));
        byte[] sound = Files.readAllBytes(part);
        byte[] damaged = sound.clone();
        if (dice.chance(.5)) {
            damaged = Arrays.copyOf(sound, dice.integer(0, sound.length - 1));
        } else {
            damaged[dice.integer(0, sound.length - 1)] ^= (byte) (1 << dice.integer(0, 7));
        }
        Files.write(part, damaged);
        Running.Ended ended = end("damaged file", start(words, java()), Set.of(0, 2, 3, 5));
        struck();
        if (ended != null && DONE.contains(ended.exitCode())) {
            done(ended);
        } else if (ended != null) {
            expectLine(ended, "expected ");
            checks.oldOrWhole("damaged file", output);
        }
        Files.write(part, sound);
        done(end("with the sound file", start(words, java()), DONE));
    }

    private void pause(Running running, double seconds) throws IOException, InterruptedException {
        if (running.isAlive()) {
            struck();
            running.signal("STOP");
            Thread.sleep((long) (1000 * seconds));
            running.signal("CONT");
        }
    }

    private void withWorkers(List<String> words) throws IOException, InterruptedException {
        Running master = start(words, java());
        Thread.sleep((long) (1000 * moment()));
        Worker worker = workers.get(0);
        if (master.isAlive() && fault != Fault.WORKER_PAUSED) {
            struck();
        }
        switch (fault) {
            case WORKER_KILLED -> worker.running().kill();
            case WORKERS_KILLED -> workers.forEach(each -> each.running().kill());
            case WORKER_RESTARTED -> {
                worker.running().close();
                worker.start();
            }
            case WORKER_PAUSED -> pauseWorker(worker, master);
            case WORKER_SILENT -> worker.running().signal("STOP");
            case WORKER_LATE -> worker.start();
            default -> {
                // its heap was small from the beginning
            }
        }
        done(end("with workers", master, fault == Fault.WORKERS_KILLED ? Set.of(0, 4, 5) : DONE));
        for (Worker each : workers) {
            if (each.running() != null && fault != Fault.WORKER_HEAP) {
                serverText(each.running().printed());
            }
        }
    }

    private void serverText(String printed) {
        log.append(printed).append("[a worker]\n");
        checks.ended("worker", new Running.Ended(List.of(), 0, printed, 0), false, Set.of(0));
    }

    private void pauseWorker(Worker worker, Running master) throws IOException, InterruptedException {
        if (master.isAlive()) {
            pause(worker.running(), dice.between(.5, 5));
        }
    }

    private void wrongCommand() throws IOException, InterruptedException {
        struck();
        tally.count("schedule", command.schedule);
        List<String> wrong = dice.of(List.of("--no-such-option"), List.of("-pa", "0"), List.of("-pa", "-3"),
                List.of("-it", "many"), List.of("-nr", "1.5"), List.of("-se", "2"), List.of("--schedule", "none"),
                List.of("--time", "5s", "--accuracy", "5%"), List.of("-h", "2", "localhost:1"), List.of("--statistics"),
                List.of("-key", "none.key"), List.of("--size", "0x3"), List.of("-it", "3", "-it", "4"),
                List.of("third.scene"), List.of("--picture", "picture.txt"), List.of("--accuracy", "5%", "-it", "3"));
        List<String> content = scene.library() == null ? List.of() : List.of("--content", scene.library().toString());
        List<String> words = words(wrong, content, scene.file(), output);
        Running.Ended ended = end("wrong command line", start(words, java()), Set.of(2));
        if (ended != null && ended.printed().lines().count() > 2) {
            checks.fail("wrong command line: more than a line: " + ended.printed());
        }
        checks.oldOrWhole("wrong command line", output);
    }

    /** --info, --help, --version. */
    private void information() throws IOException, InterruptedException {
        for (String asked : List.of("--info", "--help", "--version")) {
            if (command.runOptions.contains(asked)) {
                tally.count("option", asked);
                List<String> words = asked.equals("--info") ? words(asked, output) : List.of(asked);
                Set<Integer> allowed = asked.equals("--info") && checks.oldOrWhole("--info", output) == null
                        ? Set.of(3) : Set.of(0);
                end(asked, start(words, List.of("-XX:TieredStopAtLevel=1")), allowed);
            }
        }
    }
}
