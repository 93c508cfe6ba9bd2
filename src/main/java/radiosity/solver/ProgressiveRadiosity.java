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
 * The loop of figure 7: patches with unshot flux shoot, all elements receive, until little flux is unshot. The
 * {@link Schedule} chooses the patches that shoot.
 *
 * <p>{@link #progress}, {@link #ledger}, {@link #state} and {@link #solution} only read: the calculation gives the same
 * bits whenever and however often a listener calls them.
 */
public final class ProgressiveRadiosity {

    private final World world;
    /** Numbers of shots: at every multiple of each, a step ends. */
    private final List<Integer> pauses = new ArrayList<>();
    private final StopRule stop;
    private final SolveCounters counters;
    private final RoundQueue queue = new RoundQueue();
    private final StepSizer sizer;
    private final LatestStatus last;
    private Planner planner;
    /** The last estimate of the error, made after {@link #certifiedRound} rounds and {@link #certifiedShots} shots. */
    private Optional<Certificate> certificate = Optional.empty();
    private int certifiedRound = -1;
    private int certifiedShots;
    /** The encoded scene at the end of every {@link #state}; null before the first. */
    private byte[] scene;

    public ProgressiveRadiosity(World world, StopRule stop) {
        this(world, stop, StepSizer.STEP_SECONDS);
    }

    /** @param stepSeconds wanted duration of a step, s; without influence on the result */
    public ProgressiveRadiosity(World world, StopRule stop, double stepSeconds) {
        this.world = world;
        this.stop = stop;
        sizer = new StepSizer(stepSeconds / world.stepsAhead());
        last = new LatestStatus(world, sizer);
        counters = new SolveCounters(world.mesh, world.parallel);
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
            int estimates = counters.estimates();
            if (queue.isEmpty() && !choose(listener)) {
                return;
            }
            goOn = counters.estimates() == estimates || listener.afterEstimate(progress()) && !isEstimated();
            goOn = goOn && round(listener);
        }
        last.know();
    }

    /**
     * Chooses the shots of the next round by the unshot flux after the last one.
     *
     * @return false where no flux is left to shoot, or the listener asks to stop
     */
    private boolean choose(RoundListener listener) throws IOException {
        Order next;
        boolean[] stopped = {false};
        try {
            next = planner.next(last.afterRound(), unsent(), nowAndThen(listener, stopped));
        } catch (CancellationException e) {
            if (!stopped[0]) {
                throw e; // the listener's own
            }
            return false;
        }
        if (next != null) {
            queue.add(next, unsent());
        }
        return next != null;
    }

    /** Whether the error was estimated as often as the stop rule says. */
    private boolean isEstimated() {
        return counters.estimates() >= stop.estimates();
    }

    /**
     * One round: the chosen patches shoot, all elements receive and are refined, and the listener saves. A long round
     * is done in several steps, after each of which the listener may stop the calculation.
     *
     * @return false where the listener asks to stop
     */
    private boolean round(RoundListener listener) throws IOException {
        boolean goOn;
        do {
            shootAndReceive();
            goOn = listener.afterRound(progress());
        } while (goOn && !queue.isBetweenRounds() && !isDone());
        return goOn;
    }

    /** Unshot flux over emitted flux after the last round whose answer was read. */
    private double unsent() {
        return counters.flux.unsent(last.afterRound());
    }

    /** Calls the listener, but no more often than between steps; true where the calculation is to go on. */
    private BooleanSupplier nowAndThen(RoundListener listener, boolean[] stopped) {
        long[] asked = {world.now()};
        return () -> {
            if ((world.now() - asked[0]) * 1e-9 < StepSizer.STEP_SECONDS) {
                return true;
            }
            asked[0] = world.now();
            stopped[0] = !listener.afterRound(progress());
            return !stopped[0];
        };
    }

    /**
     * Ends steps at every multiple of a number of shots, where the listener is called then.
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

    /** Asks the partitions for their first answer, unless there is one. */
    private void ask() throws IOException {
        prepare();
        if (last.newest() == null) {
            last.askFirst(Order.asking(Order.Kind.ASK, planner.wanted()));
            counters.begin(last.newest());
        }
    }

    /** Waits for the answer to the last order. */
    private void know() throws IOException {
        ask();
        last.know();
    }

    /**
     * Lowers the error asked for: the next {@link #run} goes on from the end of the last one. Nothing changes where the
     * schedule estimates no error, and where the error asked for was as low before.
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

    /** The relative error asked for; empty where the schedule estimates no error. */
    public OptionalDouble aim() {
        prepare();
        return planner.aim();
    }

    private Planner planner() {
        return switch (world.settings().schedule()) {
            case PREDICT -> new Prediction(world, stop.unsent(), counters, this::estimate);
            case PAPER -> new ShootAndSort(world.patches(), world.channels());
            case SHOOTING -> new CyclicSchedule(world.channels(), false);
            case GATHERING -> new CyclicSchedule(world.channels(), true);
            case MATRIX -> new MatrixSolution(world);
        };
    }

    private boolean isDone() {
        double left = queue.isEmpty() ? unsent() : queue.unsent();
        return counters.shots() >= stop.shots() || isEstimated() || queue.isBetweenRounds()
                && planner.isEnough(last.afterRound(), left, Math.max(stop.unsent(), counters.flux.rounding()));
    }

    /** Whether the unshot flux exceeds the stop rule's, but is nothing but {@linkplain StopRule#ROUNDING rounding}. */
    public boolean isOnlyRoundingLeft() {
        double left = counters.flux.unsent(counters.shown(last.newest()));
        return left > stop.unsent() && left <= counters.flux.rounding();
    }

    /*---- Rounds that overlap ----*/

    /** Chooses the next round where a round was begun as a whole and the schedule's rounds overlap. */
    private void lookAhead(Order done) throws IOException {
        if (queue.isEmpty() && done.changes() && planner.looksAhead()) {
            last.catchUpToRoundBefore();
            chooseAhead();
        }
    }

    /**
     * Chooses the next round by the answer to the round before the present one; asks the partitions where all
     * candidates of that answer shoot in the present round.
     */
    private void chooseAhead() throws IOException {
        double left = unsent();
        Answer known = last.afterRound().without(queue.shooters(), world.mesh.faces, world.mesh.fluxScale());
        Order next = planner.next(known, left, () -> true);
        queue.add(next == null ? Order.asking(Order.Kind.ASK, planner.wanted()) : next, left);
    }

    /**
     * A step: a part of the present round that is short enough for a user who wants to stop. The division of a round
     * into steps has no influence on the result.
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
        queue.begin(next.changes() ? next.numbered(counters.nextRound(next.shots())) : next, planner.looksAhead());
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

    /**
     * Progress by the newest answer that was read; waits for the partitions before {@link #run} only.
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
     * Emitted, shot, received and absorbed flux so far. May be called before and after {@link #run}, and by the
     * listener.
     *
     * @throws UncheckedIOException where a partition cannot be reached
     */
    public EnergyLedger ledger() {
        try {
            know();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return counters.ledger(last.newest());
    }

    /**
     * The present solution, merged from all partitions. May be called before and after {@link #run}, and by the
     * listener.
     *
     * @throws IOException where a partition cannot be reached
     */
    public Solution solution() throws IOException {
        know();
        List<byte[]> blocks = world.blocks();
        Answer now = last.newest();
        return new Merger(world.mesh, blocks, counters.dark(), counters.shownShare(now)).solution(counters.shots(),
                counters.rounds(), Flux.sum(counters.shown(now).unshotFlux), counters.ledger(now), state(blocks));
    }

    /**
     * Estimates the error of the present solution; takes a small part of the time that the solution took.
     *
     * @param threads at least 1
     * @throws IllegalArgumentException where the number of threads is below 1
     * @return empty where some vertices have not gathered yet, no patch has shot, or no point is lit
     */
    public Optional<Certificate> certificate(int threads) throws IOException {
        return certificate(new ParallelFor(threads));
    }

    private Optional<Certificate> certificate(ParallelFor parallel) throws IOException {
        return isCertified() || estimate(parallel).isPresent() ? certificate : Optional.empty();
    }

    /** The certificate of the present solution where it was estimated already; else empty. */
    public Optional<Certificate> knownCertificate() {
        return isCertified() ? certificate : Optional.empty();
    }

    private boolean isCertified() {
        return certifiedRound == counters.rounds() && certifiedShots == counters.shots();
    }

    private Optional<Estimator.Estimate> estimate(double meshError, BooleanSupplier goOn) throws IOException {
        Optional<Audit> audit = estimate(world.parallel.cancelledUnless(goOn));
        if (audit.isEmpty() || certificate.isEmpty()) {
            return Optional.empty();
        }
        counters.countEstimate();
        return Optional.of(new Estimator.Estimate(certificate.get(), audit.get().marked(meshError)));
    }

    /** Sets {@link #certificate} to that of the present solution; empty, and not set, where that is incomplete. */
    private Optional<Audit> estimate(ParallelFor parallel) throws IOException {
        if (counters.dark() != 0 || counters.shots() == 0) {
            return Optional.empty();
        }
        know();
        Answer now = last.newest();
        Audit audit = new Audit(world.mesh, world, world.blocks(), counters.flux.byChannel(now), now.elements,
                planner.aim().orElse(world.mesh.accuracy()), counters.rounds(), parallel);
        certificate = Optional.of(audit.certificate(Flux.sum(counters.shown(now).unshotFlux)))
                .filter(found -> found.points() > 0);
        certifiedRound = counters.rounds();
        certifiedShots = counters.shots();
        return Optional.of(audit);
    }

    /**
     * The state that {@link #resume} takes. May be called before and after {@link #run}, and by the listener.
     *
     * @throws IOException where a partition cannot be reached
     */
    public SavedState state() throws IOException {
        ask();
        last.catchUp();
        return state(world.blocks());
    }

    /** Whether the round after the present one is chosen by an answer that partitions cannot give again. */
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

    /** The encoded scene, for {@link #change} by a later calculation. */
    private byte[] scene() {
        if (scene == null) {
            scene = SavedScene.write(SceneBytes.write(world.mesh.original, world.settings()));
        }
        return scene;
    }

    /**
     * Goes on from the solution of an earlier scene, of which this scene is an edited copy: light that no longer
     * arrives is taken back, new light is sent, and all other light stays. The same bits for any number of threads and
     * hosts. To be called before every other method of this class.
     *
     * @param earlier state of the earlier {@link Solution}
     * @return why the scene has to be rendered anew, in a few words; empty where the earlier solution is used
     * @throws IllegalStateException where the calculation was run already, or was asked for anything
     */
    public Optional<String> change(SavedState earlier) throws IOException {
        return change(earlier, null, () -> true);
    }

    /**
     * Goes on from the solution of an earlier scene, see {@link #change(SavedState)}, unless cancelled.
     *
     * @param mesh initial mesh of the earlier scene, with the same settings; null to make the mesh from the state
     * @param goOn called now and then, by any thread
     * @throws CancellationException where {@code goOn} returns false; this object cannot be used then
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
     * Goes on with an earlier calculation that was stopped: the same scene and settings give the same bits as without a
     * stop. To be called before every other method of this class.
     *
     * @param state state of the earlier {@link Solution}
     * @throws SceneFormatException where the state belongs to another scene or other settings
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

    /** Number of shots so far. */
    public int shots() {
        return counters.shots();
    }

    /** Number of estimates of the error so far that have decided how the calculation goes on. */
    public int estimates() {
        return counters.estimates();
    }
}
