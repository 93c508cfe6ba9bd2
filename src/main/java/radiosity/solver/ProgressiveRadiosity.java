package radiosity.solver;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import radiosity.certificate.Audit;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.protocol.SavedScene;
import radiosity.protocol.SceneBytes;
import radiosity.protocol.Wire;
import radiosity.scene.SceneFormatException;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.setup.InitialMesh;
import radiosity.solution.Certificate;
import radiosity.solution.EnergyLedger;
import radiosity.solution.Progress;
import radiosity.solution.RoundListener;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.util.ParallelFor;

/**
 * The loop of figure 7: who has unshot flux shoots, everybody receives, until little enough is left.
 *
 * <p>Who shoots is the schedule's choice, see {@link Schedule}.
 *
 * <p>Whatever is asked for meanwhile ({@link #progress}, {@link #ledger}, {@link #state}, {@link #solution}) only
 * reads: the calculation goes on to the same bits whenever and however often a listener asks.
 */
public final class ProgressiveRadiosity {

    private final World world;
    /** Shots after which the listener is to be asked. */
    private final List<Integer> pauses = new ArrayList<>();
    private final StopRule stop;
    private final SolveCounters counters;
    private final RoundQueue queue = new RoundQueue();
    private final StepSizer sizer;
    private final LatestStatus last;
    private Planner planner;
    /** What was found by looking at the solution after that round, and that many shots. */
    private Optional<Certificate> certificate = Optional.empty();
    private int certifiedRound = -1;
    private int certifiedShots;
    /** What {@link #state} ends with; null until it is first wanted. */
    private byte[] scene;

    public ProgressiveRadiosity(World world, StopRule stop) {
        this(world, stop, StepSizer.STEP_SECONDS);
    }

    /** @param stepSeconds how long a step may take; without influence on the result */
    public ProgressiveRadiosity(World world, StopRule stop, double stepSeconds) {
        this.world = world;
        this.stop = stop;
        sizer = new StepSizer(stepSeconds / world.stepsAhead());
        last = new LatestStatus(world, sizer);
        counters = new SolveCounters(world.mesh);
    }

    /**
     * Shoots until the stop rule holds or the listener asks to stop.
     *
     * @throws IOException where a partition cannot be reached
     */
    public void run(RoundListener listener) throws IOException {
        ask();
        boolean goOn = true;
        while (goOn && !isDone()) {
            if (queue.isEmpty() && !choose(listener)) {
                return;
            }
            goOn = round(listener);
        }
        last.know();
    }

    /**
     * Chooses who shoots in the next round, by what was unshot after the last one.
     *
     * @return whether anybody was chosen: not where nothing is left to shoot, or the listener asks to stop
     */
    private boolean choose(RoundListener listener) throws IOException {
        Order next = planner.next(last.afterRound(), unsent(), nowAndThen(listener));
        if (next != null) {
            queue.add(next, unsent());
        }
        return next != null;
    }

    /**
     * One round: those who were chosen shoot, all elements receive and are refined, and the listener saves. A long
     * round is done in several steps, after each of which the listener may stop it.
     *
     * @return whether to go on
     */
    private boolean round(RoundListener listener) throws IOException {
        boolean goOn;
        do {
            shootAndReceive();
            goOn = listener.afterRound(progress());
        } while (goOn && !queue.isBetweenRounds() && !isDone());
        return goOn;
    }

    /** What was left to shoot after the last round of which the answer was read, relative to what was emitted. */
    private double unsent() {
        return counters.flux.unsent(last.afterRound());
    }

    /** Asks the listener as often as between steps. */
    private BooleanSupplier nowAndThen(RoundListener listener) {
        long[] asked = {world.now()};
        return () -> {
            if ((world.now() - asked[0]) * 1e-9 < StepSizer.STEP_SECONDS) {
                return true;
            }
            asked[0] = world.now();
            return listener.afterRound(progress());
        };
    }

    /**
     * Ends steps at every multiple of a number of shots, so that the listener is called there.
     *
     * @param shots at least 1
     * @throws IllegalArgumentException where the number is below 1
     */
    public void pauseEvery(int shots) {
        if (shots < 1) {
            throw new IllegalArgumentException("pause: expected a number of shots of at least 1, got " + shots);
        }
        pauses.add(shots);
    }

    private void prepare() {
        if (planner == null) {
            planner = planner();
        }
    }

    /** Asks how things stand where nobody has asked yet. */
    private void ask() throws IOException {
        prepare();
        if (last.newest() == null) {
            last.askFirst(Order.asking(Order.Kind.ASK, planner.wanted()));
            counters.begin(last.newest());
        }
    }

    /** Makes the newest answer the one to the last order. */
    private void know() throws IOException {
        ask();
        last.know();
    }

    /**
     * Asks for less error: the next {@link #run} goes on from where the last one ended. Only where light is predicted;
     * otherwise, and where as little was asked for before, nothing changes.
     *
     * @param error relative, above 0; see {@link Certificate#expected}
     * @throws IllegalArgumentException where the error is not above 0
     */
    public void aim(double error) {
        if (!(error > 0)) {
            throw new IllegalArgumentException("aim: expected an error above 0, got " + error);
        }
        prepare();
        planner.aim(error);
    }

    /** The relative error that is asked for; nothing where the schedule looks at no error. */
    public OptionalDouble aim() {
        prepare();
        return planner.aim();
    }

    private Planner planner() {
        return switch (world.settings().schedule()) {
            case PREDICT -> new Prediction(world, stop.unsent(), counters.flux::oneSided,
                    () -> certificate(world.parallel));
            case PAPER -> new ShootAndSort(world.patches(), world.channels());
            case SHOOTING -> new CyclicSchedule(world.channels(), false);
            case GATHERING -> new CyclicSchedule(world.channels(), true);
            case MATRIX -> new MatrixSolution(world);
        };
    }

    private boolean isDone() {
        double left = queue.isEmpty() ? unsent() : queue.unsent();
        return counters.shots() >= stop.shots() || queue.isBetweenRounds()
                && planner.isEnough(last.afterRound(), left, Math.max(stop.unsent(), counters.flux.rounding()));
    }

    /** Whether more is unshot than the stop rule asks for, but only as {@linkplain StopRule#ROUNDING rounding}. */
    public boolean isOnlyRoundingLeft() {
        double left = counters.flux.unsent(counters.shown(last.newest()));
        return left > stop.unsent() && left <= counters.flux.rounding();
    }

    /*---- Rounds that overlap ----*/

    /** All of a round was begun: what comes then may be chosen before the round is over. */
    private void lookAhead(Order done) throws IOException {
        if (queue.isEmpty() && done.changes() && planner.looksAhead()) {
            last.catchUpToRoundBefore();
            chooseAhead();
        }
    }

    /**
     * Chooses the next round by the answer before the present one; where that answer names no candidate who is left,
     * partitions are asked.
     */
    private void chooseAhead() throws IOException {
        double left = unsent();
        Answer known = last.afterRound().without(queue.shooters(), world.mesh.faces, world.mesh.fluxScale());
        Order next = planner.next(known, left, () -> true);
        queue.add(next == null ? Order.asking(Order.Kind.ASK, planner.wanted()) : next, left);
    }

    /**
     * A step: as much of the present round as takes no longer than a user waits. Where the round is cut into steps has
     * no influence on the result.
     */
    private void shootAndReceive() throws IOException {
        if (queue.isBetweenRounds()) {
            begin();
        }
        Order pending = queue.round();
        int receive = pending.kind() == Order.Kind.ROWS ? world.mesh.entriesPerShot() : last.newest().elements;
        int all = pending.shots().size();
        int size = pending.kind() == Order.Kind.MEND ? all : Math.min(all, sizer.size(pending.kind(), receive, all));
        if (pending.kind() == Order.Kind.SHOOT) {
            size = Math.min(size, stop.shots() - counters.shots());
            for (int every : pauses) {
                size = Math.min(size, every - counters.shots() % every);
            }
        }
        Order now = pending.first(size);
        if (now.more() && !last.isOld()) {
            now = now.asking(Order.Question.NOTHING);
        }
        Answer before = last.afterRound();
        carryOut(now);
        counters.count(now, before, last.afterRound());
        queue.done(size);
        if (!now.more()) {
            lookAhead(now);
        }
    }

    private void begin() throws IOException {
        if (!planner.looksAhead()) {
            sizer.rest();
        }
        Order next = queue.round();
        queue.begin(next.changes() ? next.numbered(counters.nextRound(), missing(next.kind())) : next,
                planner.looksAhead());
    }

    private void carryOut(Order now) throws IOException {
        if (!now.changes()) {
            await(now);
            return;
        }
        last.begun(now, world.begin(now, sizer::took));
        if (now.isAnswered() && (now.more() || !planner.looksAhead())) {
            last.catchUp();
        }
    }

    private void await(Order now) throws IOException {
        world.finish(sizer::took);
        last.catchUp();
        long begin = world.now();
        if (now.kind() == Order.Kind.ROWS) {
            world.rows(now, planner);
        } else {
            last.ask(now);
        }
        sizer.took(now.shots().size(), (world.now() - begin) * 1e-9);
    }

    /** To be given back, see {@link Flux#missing}; empty where nothing is. */
    private double[] missing(Order.Kind kind) {
        boolean gives = world.mesh.boundsReceived() && (kind == Order.Kind.BALANCE || kind == Order.Kind.SHOOT);
        return gives && counters.shots() > 0
                ? counters.flux.missing(last.afterRound()) : new double[0];
    }

    /**
     * Where the calculation stands by the newest answer; waits for nobody but before {@link #run}.
     *
     * @throws UncheckedIOException where a partition cannot be reached
     */
    public Progress progress() {
        try {
            ask();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return counters.progress(last.newest(), certificate.map(Certificate::expected).orElse(Double.NaN));
    }

    /**
     * Where the light went so far. May be asked for before and after {@link #run}, and whenever the listener is
     * called.
     *
     * @throws UncheckedIOException where a partition cannot be reached
     */
    public EnergyLedger ledger() {
        try {
            know();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return counters.flux.ofAllLayers(counters.shown(last.newest()));
    }

    /**
     * Everything so far, merged from all partitions. May be asked for before and after {@link #run}, and
     * whenever the listener is called.
     *
     * @throws IOException where a partition cannot be reached
     */
    public Solution solution() throws IOException {
        know();
        List<byte[]> blocks = world.blocks();
        return new Merger(world.mesh, blocks, counters.dark()).solution(counters.shots(), counters.rounds(),
                Flux.sum(counters.shown(last.newest()).unshotFlux), ledger(), state(blocks));
    }

    /**
     * How far the solution so far can be trusted; takes a small part of the time that the solution took.
     *
     * @param threads at least 1
     * @throws IllegalArgumentException where the number of threads is below 1
     * @return nothing where some vertices have not gathered yet, nobody has shot, or all is dark
     */
    public Optional<Certificate> certificate(int threads) throws IOException {
        return certificate(new ParallelFor(threads));
    }

    private Optional<Certificate> certificate(ParallelFor parallel) throws IOException {
        if (counters.dark() != 0 || counters.shots() == 0) {
            return Optional.empty();
        }
        know();
        if (certifiedRound != counters.rounds() || certifiedShots != counters.shots()) {
            Answer now = last.newest();
            Audit audit = new Audit(world.mesh, world.blocks(), counters.flux.byChannel(now), now.elements,
                    planner.aim().orElse(world.mesh.accuracy()), parallel);
            certificate = Optional.of(audit.certificate(Flux.sum(counters.shown(now).unshotFlux)))
                    .filter(found -> found.points() > 0);
            certifiedRound = counters.rounds();
            certifiedShots = counters.shots();
        }
        return certificate;
    }

    /**
     * What {@link #resume} takes; for whoever wants to go on later. May be asked for before and after {@link #run},
     * and whenever the listener is called.
     *
     * @throws IOException where a partition cannot be reached
     */
    public SavedState state() throws IOException {
        ask();
        last.catchUp();
        return state(world.blocks());
    }

    /** Whether the round after the present one is chosen by an answer that nobody can be asked for again. */
    private boolean isChosenAhead() {
        return planner.looksAhead() && queue.changes();
    }

    /** @param blocks states of all blocks, by id; not copied */
    private SavedState state(List<byte[]> blocks) {
        List<byte[]> pieces = new ArrayList<>();
        pieces.add(Wire.bytes(out -> {
            out.writeUTF(world.mesh.fingerprint());
            counters.write(out);
            planner.write(out);
            queue.write(out);
            if (isChosenAhead()) {
                last.write(out, queue.shooters());
            }
        }));
        for (byte[] block : blocks) {
            pieces.add(Wire.bytes(out -> out.writeInt(block.length)));
            pieces.add(block);
        }
        pieces.add(scene());
        return SavedState.of(pieces);
    }

    /** For whoever changes it later. */
    private byte[] scene() {
        if (scene == null) {
            scene = SavedScene.write(SceneBytes.write(world.mesh.original, world.settings()));
        }
        return scene;
    }

    /**
     * Goes on from the solution of an earlier scene, of which this one is an edited copy: light that no longer arrives
     * is taken back, new light is sent, and nothing else is done again. The same bits for any number of threads and
     * hosts. To be called before {@link #run} and before anything is asked for.
     *
     * @param earlier of the earlier {@link Solution}
     * @return why the scene has to be rendered anew, in a few words; nothing where it goes on from the earlier solution
     * @throws IllegalStateException where the calculation was run already, or was asked for anything
     */
    public Optional<String> change(SavedState earlier) throws IOException {
        return change(earlier, null, () -> true);
    }

    /**
     * The same for who may not wait for the end.
     *
     * @param mesh of the earlier scene, of the same settings; null where the state has to say it
     * @param goOn is asked now and then, by any thread
     * @throws CancellationException where it says no; the calculation is of no use then
     */
    public Optional<String> change(SavedState earlier, InitialMesh mesh, BooleanSupplier goOn) throws IOException {
        if (last.newest() != null) {
            throw new IllegalStateException("change: expected a calculation that nobody has run or asked yet");
        }
        EditedScene edited = new EditedScene(world, earlier, mesh);
        if (!earlier.isEmpty() && edited.isSame()) {
            resume(earlier);
            return Optional.empty();
        }
        Optional<String> obstacle = edited.obstacle();
        if (obstacle.isPresent()) {
            return obstacle;
        }
        prepare();
        obstacle = edited.begin(counters, (Prediction) planner, goOn);
        planner = obstacle.isPresent() ? null : planner;
        return obstacle;
    }

    /**
     * Goes on from where an earlier calculation stopped: the same scene and settings give the same bits as without a
     * stop. To be called before {@link #run} and before anything is asked for.
     *
     * @param state of the earlier {@link Solution}
     * @throws SceneFormatException where scene or settings are others
     * @throws IllegalStateException where the calculation was run already, or was asked for anything
     */
    public void resume(SavedState state) throws IOException {
        if (last.newest() != null) {
            throw new IllegalStateException("resume: expected a calculation that nobody has run or asked yet");
        }
        try (DataInputStream in = new DataInputStream(state.open())) {
            world.mesh.checkFingerprint(in.readUTF());
            counters.read(in);
            prepare();
            planner.read(in);
            queue.read(in);
            if (isChosenAhead()) {
                last.read(in);
            }
            List<byte[]> blocks = new ArrayList<>();
            for (int b = 0; b < world.mesh.blocks.size(); b++) {
                blocks.add(Wire.bytes(in));
            }
            world.restore(blocks);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    /** Patches that have shot. */
    public int shots() {
        return counters.shots();
    }
}
