package radiosity.solver;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import radiosity.mesh.Weights;
import radiosity.prediction.AmbientLevel;
import radiosity.prediction.CoarseSystem;
import radiosity.protocol.Answer;
import radiosity.protocol.Mark;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.settings.FormFactors;
import radiosity.settings.StopRule;
import radiosity.setup.InitialMesh;
import radiosity.solution.Certificate;

/**
 * The default schedule: every patch shoots its predicted final radiosity in one round, later rounds shoot what the
 * prediction lacked, and mesh and rays are refined until the estimated error is the one asked for.
 *
 * <p>Prediction: the linear system of a coarse mesh is set up once. Solved for the unshot radiosity of all patches, the
 * system gives the radiosity that multiple reflections will add to each patch. A patch shoots the sum of both
 * (overshooting: M. Feda, W. Purgathofer, Accelerating radiosity by overshooting, 1992), so that the unshot radiosity
 * after a round is small, and signed, at any reflectance.
 *
 * <p>The calculation as stages, see {@link #next}: SHOOT until little is unshot; SPLIT the mesh and let new vertices
 * GATHER all light shot so far, until no element is to be divided; SHOOT what the finer mesh changed, at last without
 * prediction and with few rays; MEND vertices with negative irradiance; BALANCE the received flux against the flux that
 * was shot; then an {@link Estimator} finds the error and marks elements that err too much between their vertices, and
 * {@link AccuracyLoop} decides between a finer mesh (SPLIT again), more rays (RENEW, REGATHER and AVERAGE: all vertices
 * gather a second, independent sample) and the end (DONE). Before light is predicted, the flux that rays have lost is
 * given back, by an order without a stage of its own.
 */
final class Prediction implements Planner {

    /** Unshot flux over emitted flux at which the first rounds of shooting end and the mesh is divided. */
    private static final double SETTLED = 0.05;
    /** SPLIT stages in a row: the depth that the mesh may gain between two estimates of the error. */
    private static final int MOST_SPLITS = 12;
    /** Rounds that may go wrong, see {@link #mispredicted}; then nothing is predicted until marks divide the mesh. */
    private static final int MOST_MISPREDICTED = 3;
    /** Form factor that one ray may stand for in a row of the coarse system. */
    private static final double ROW_TOLERANCE = 0.02;
    /** Patches of the coarse mesh up to which light is predicted: a row has some hundred entries, 2 kB. */
    private static final int MOST_PREDICTED = 100_000;
    /** Asks all partitions for all patches with unshot flux. */
    private static final Order ALL = Order.asking(Order.Kind.ASK, Integer.MAX_VALUE);
    private static final Order MEANS = Order.asking(Order.Kind.MEANS, Integer.MAX_VALUE);

    /** The kind of the last round, see the class comment. The ordinal is part of saved calculations. */
    private enum Stage { NOTHING, SHOOT, SPLIT, GATHER, RENEW, REGATHER, AVERAGE, BALANCE, DONE, MEND }

    /** {@link #changes} is counted up to this number. */
    private static final int MOST_CHANGES = 3;
    /**
     * Unshot flux over emitted flux in an edited scene above which the coarse system is set up for a prediction, and
     * down to which light is shot before the mesh is divided.
     */
    private static final double PREDICTED = 0.1;
    /** Factor by which edits may let the error exceed the usual one before mesh or rays are refined. */
    private static final double WORSE = 1.15;
    /** Part of the unshot flux that a round in an edited scene may leave to later rounds. */
    private static final double LEFT = 0.05;

    private final World world;
    /** Unshot flux over emitted flux at which the calculation may end. */
    private final double wanted;
    private final SolveCounters counters;
    private final FirstWeights firstWeights;
    /** Null where the scene has more than {@link #MOST_PREDICTED} patches. */
    private final CoarseSystem coarse;
    private final AccuracyLoop loop;
    private final UnshotLimit limit;
    private final Estimator estimator;
    /** See {@link Weights}: 1 / mean reflected radiosity, m²/W; irradiance of dark surfaces counts a little. */
    private final double[] weight;
    private Stage stage = Stage.NOTHING;
    /** Number of SPLIT stages since the error was estimated last. */
    private int splits;
    /** Number of elements before the last SPLIT. */
    private int elements;
    /** Whether the mesh is as fine as the loop's tolerance asks for. */
    private boolean refined;
    /**
     * Unshot flux over emitted flux before the last SHOOT; where that round leaves more, the next one is shot without
     * prediction. After the last round of shooting: the unshot flux that is left, at most {@link UnshotLimit#flux}, or
     * 0 where more shooting would be in vain.
     */
    private double left = Double.POSITIVE_INFINITY;
    /**
     * Number of SHOOT stages that have left more flux unshot than there was before, and of those that followed an
     * estimate as too much flux of one sign was left, since an estimate has marked elements to divide.
     */
    private int mispredicted;
    /**
     * Whether flux that rays lost has been given back since light was received last, so that it is shot with the rest.
     * On the first mesh that is done between white surfaces only, as elements there do not receive quite what arrives.
     */
    private boolean balanced = true;
    /** Whether the last edit has left so much flux unshot that rounds shoot what the coarse system predicts, too. */
    private boolean isLargeChange;
    /** Number of edits since all vertices gathered anew. Above 0 the light is that of an earlier scene, edited. */
    private int changes;

    /**
     * @param wanted   unshot flux over emitted flux at which the calculation may end
     * @param counters shots and flux of the calculation so far
     */
    Prediction(World world, double wanted, SolveCounters counters, Estimator estimator) {
        this.estimator = estimator;
        this.counters = counters;
        this.wanted = wanted;
        this.world = world;
        firstWeights = new FirstWeights(world.mesh, world.channels());
        loop = new AccuracyLoop(world.mesh);
        weight = new double[Weights.count(world.mesh.rooms, world.channels())];
        Arrays.fill(weight, 1);
        coarse = world.mesh.coarse.patches() - world.mesh.representatives.followers() <= MOST_PREDICTED
                ? new CoarseSystem(world.mesh, world.parallel) : null;
        limit = new UnshotLimit(world.mesh, counters, coarse, loop, wanted, weight);
    }

    /** The order that makes the coarse system; a resumed calculation gives the order again. */
    private Order rows() {
        double[] equal = new double[world.channels()];
        Arrays.fill(equal, 1);
        return new Order(Order.Kind.ROWS, coarse.importance(), new Order.Rules(ROW_TOLERANCE, equal, 0),
                Order.Question.candidates(0));
    }

    @Override
    public void take(int shots, List<byte[]> rows) throws IOException {
        coarse.take(shots, rows);
    }

    @Override
    public Order next(Answer last, double unsent, BooleanSupplier goOn) throws IOException {
        if (stage == Stage.SPLIT) {
            refined = last.elements == elements || splits == MOST_SPLITS;
            left = changes > 0 ? Double.POSITIVE_INFINITY : left;
        }
        return switch (stage) {
            case NOTHING, SHOOT, DONE -> distribute(last, unsent, goOn);
            case SPLIT -> last.elements > elements ? gather() : distribute(last, unsent, goOn);
            case GATHER -> refined ? distribute(last, unsent, goOn) : split(last, List.of());
            case RENEW -> regather();
            case REGATHER -> average();
            case AVERAGE, MEND -> balance(last);
            case BALANCE -> changes > 0 ? endOfChange(last, unsent, goOn) : refine(last, unsent, goOn);
        };
    }

    /** Shoots until little flux is unshot; then divides the mesh, or prepares the estimate where that is done. */
    private Order distribute(Answer last, double unsent, BooleanSupplier goOn) throws IOException {
        if (changes > 0) {
            return distributeChange(last, unsent, goOn);
        }
        if (!refined && stage == Stage.SHOOT && unsent <= SETTLED) {
            return split(last, List.of());
        }
        if (coarse != null && !coarse.isMade()) {
            return rows();
        }
        if (!balanced && (refined || world.mesh.rounding.exact())) {
            return giveBack(last, true);
        }
        boolean isWorse = stage == Stage.SHOOT && unsent >= left;
        boolean isPredicted = coarse != null && !isWorse && mispredicted < MOST_MISPREDICTED;
        double[] h = isPredicted ? predict(goOn) : null;
        if (isPredicted && h == null) {
            return null;
        }
        boolean isShot = refined && (stage == Stage.SHOOT || stage == Stage.SPLIT || stage == Stage.GATHER);
        boolean isEnough = isShot && isLittle(last, unsent, h);
        if (isEnough && !isWorse && limit.leavesTooMuch(unsent)) {
            return shoot(withoutPrediction(last), unsent, true);
        }
        if (isEnough || isShot && isWorse && mispredicted == MOST_MISPREDICTED) {
            left = isEnough ? Math.min(unsent, limit.flux()) : 0;
            return isEnough && !loop.lacksRays() ? mend() : renew();
        }
        List<Shot> shots = isPredicted ? withPrediction(last, h) : withoutPrediction(last);
        if (shots.isEmpty()) {
            return null;
        }
        mispredicted += isWorse && mispredicted < MOST_MISPREDICTED ? 1 : 0;
        return shoot(shots, unsent, false);
    }

    /**
     * Estimates the error and refines mesh or rays. Where the error is the one asked for, or cannot fall, the result is
     * null, the end; but where BALANCE has left much light of one sign unshot, a round that shoots it comes first.
     */
    private Order refine(Answer last, double unsent, BooleanSupplier goOn) throws IOException {
        if (coarse != null && !coarse.isMade()) {
            return rows();
        }
        Optional<Estimator.Estimate> estimate = estimate(goOn);
        return switch (estimate.map(found -> loop.refine(found.certificate(), found.marked().share(),
                last.elements)).orElse(AccuracyLoop.Refine.NOTHING)) {
            case MESH -> divide(last, estimate.get());
            case RAYS -> renew();
            case NOTHING -> {
                if (mispredicted < MOST_MISPREDICTED && counters.flux.oneSided(last) > 2 * limit.oneSided()) {
                    mispredicted++;
                    Order order = distribute(last, unsent, goOn);
                    mispredicted -= order == null ? 1 : 0; // nothing was shot: whoever goes on estimates again
                    yield order;
                }
                stage = Stage.DONE;
                yield null;
            }
        };
    }

    /** Divides the elements that an estimate has marked. */
    private Order divide(Answer last, Estimator.Estimate estimate) {
        left = Double.POSITIVE_INFINITY;
        splits = 0;
        mispredicted = 0;
        return split(last, estimate.marked().marks());
    }

    /**
     * Whether what is unshot may stay so: the unshot flux is small, or, unless the user sets a limit for it, is
     * predicted to change little.
     *
     * @param h predicted irradiance, channels per vertex, W/m²; null where nothing is predicted
     */
    private boolean isLittle(Answer last, double unsent, double[] h) throws IOException {
        return limit.isMet(last, unsent)
                || h != null && wanted == StopRule.DEFAULT_UNSENT && limit.changesLittle(h, world.totals());
    }

    /** Irradiance that all unshot flux is predicted to cause; null where {@code goOn} ends the calculation. */
    private double[] predict(BooleanSupplier goOn) throws IOException {
        double[] unshot = coarse.restrict(world.joined(world.answer(MEANS).candidates));
        if (stage != Stage.NOTHING) {
            coarse.rebalance(world.totals(), unshot);
        }
        return coarse.irradiance(unshot, goOn);
    }

    /**
     * The same after an edit. Light and mesh are those of the earlier scene, and the unshot flux is the signed
     * difference that the edit makes: patches shoot the difference, elements are divided where the light has changed,
     * and only vertices with negative irradiance gather anew.
     *
     * <p>Shoots the difference until little flux is unshot, then divides the mesh, then shoots until what is unshot
     * would change little. A round of shots takes long here, as the mesh is fine from the beginning; so after a small
     * change unshot flux of one sign is no reason for another one: the next change goes on with the flux.
     */
    private Order distributeChange(Answer last, double unsent, BooleanSupplier goOn) throws IOException {
        isLargeChange |= unsent > PREDICTED;
        boolean isPredicted = coarse != null && isLargeChange;
        if (isPredicted && !coarse.isMade()) {
            return rows();
        }
        boolean isShooting = unsent < left && !(refined && isPredicted ? limit.isMet(last, unsent)
                : unsent <= (refined ? limit.flux() : PREDICTED));
        if (isShooting && !balanced) {
            return giveBack(last, true);
        }
        double[] h = isShooting && isPredicted ? predict(goOn) : null;
        if (isShooting && isPredicted && h == null) {
            return null;
        }
        isShooting &= !refined || !isLittle(last, unsent, h);
        List<Shot> shots = !isShooting ? List.of() : isPredicted ? withPrediction(last, h) : largest();
        return !shots.isEmpty() ? shoot(shots, unsent, true) : refined ? mend() : split(last, List.of());
    }

    /** Estimates the error; empty where there is no light, or the user lets much flux be unshot. */
    private Optional<Estimator.Estimate> estimate(BooleanSupplier goOn) throws IOException {
        return wanted > StopRule.DEFAULT_UNSENT ? Optional.empty() : estimator.estimate(loop.meshError(), goOn);
    }

    /**
     * Ends the calculation after an edit, unless the estimated error is not {@linkplain #isUsual usual}: then mesh or
     * rays are refined as in a scene that is no edit. The noise that one edit adds is small, but the noise of many
     * edits adds up: where the error is still the one asked for, all vertices gather anew.
     */
    private Order endOfChange(Answer last, double unsent, BooleanSupplier goOn) throws IOException {
        Optional<Estimator.Estimate> estimate = estimate(goOn);
        if (estimate.isEmpty() || isUsual(estimate.get().certificate())) {
            stage = Stage.DONE;
            return null;
        }
        changes = 0;
        left = unsent <= limit.flux() ? unsent : 0;
        loop.forget();
        AccuracyLoop.Refine refine = loop.refine(estimate.get().certificate(), estimate.get().marked().share(),
                last.elements);
        return refine == AccuracyLoop.Refine.MESH ? divide(last, estimate.get()) : renew();
    }

    /**
     * Whether the estimated error is one that an edited scene may have: not clearly above the error asked for, or above
     * the last estimate where that was larger; after several edits, where most of the error is noise, not clearly above
     * the last estimate alone.
     */
    private boolean isUsual(Certificate now) {
        boolean isNoise = 2 * now.sampling() * now.sampling() > now.expected() * now.expected();
        double usual = changes == MOST_CHANGES && isNoise ? loop.found() : Math.max(loop.asked(), loop.found());
        return now.expected() <= WORSE * usual;
    }

    /** The patches with most unshot flux, as many as have all but {@link #LEFT} of the unshot flux together. */
    private List<Shot> largest() throws IOException {
        List<Shot> all = world.joined(world.answer(ALL).candidates);
        double rest = all.stream().mapToDouble(Shot::flux).sum();
        double enough = LEFT * rest;
        List<Shot> chosen = new ArrayList<>();
        for (Shot shot : all) {
            if (rest > enough) {
                chosen.add(world.mesh.rounding.of(shot));
            }
            rest -= shot.flux();
        }
        return chosen;
    }

    /**
     * Vertices with negative irradiance gather anew the total radiosity that surfaces have shot, which is nowhere
     * negative. Their irradiance is negative because negative shots use other rays than the shots that they correct.
     */
    private Order mend() throws IOException {
        stage = Stage.MEND;
        List<Shot> totals = world.totals();
        return order(Order.Kind.MEND, totals, AmbientLevel.lowest(world.mesh, totals));
    }

    /**
     * All vertices gather anew the total radiosity of all surfaces, in the stages RENEW, REGATHER and AVERAGE. The
     * second sample has rays of its own, so that the average of both samples has less noise; a negative first sample is
     * dropped. Also where predictions have failed: the new sample holds no flux that was predicted and never came.
     */
    private Order renew() throws IOException {
        stage = Stage.RENEW;
        return order(Order.Kind.RENEW, world.unshot(), new double[0]);
    }

    private Order regather() throws IOException {
        stage = Stage.REGATHER;
        List<Shot> totals = world.totals();
        return order(Order.Kind.REGATHER, totals, AmbientLevel.lowest(world.mesh, totals));
    }

    /** @param marks nodes to divide whatever their vertices have received */
    private Order split(Answer last, List<Mark> marks) {
        stage = Stage.SPLIT;
        splits++;
        elements = last.elements;
        return order(Order.Kind.SPLIT, List.of(), new double[0]).dividing(marks);
    }

    private Order average() {
        stage = Stage.AVERAGE;
        Order order = order(Order.Kind.AVERAGE, List.of(), new double[0]);
        loop.gatheredAnew();
        return order;
    }

    /** Gives lost flux back after the last shots, before the error is estimated. */
    private Order balance(Answer last) {
        stage = Stage.BALANCE;
        return giveBack(last, false);
    }

    /** Scales the irradiance of all vertices by {@link Flux#missing}, without a shot. */
    private Order giveBack(Answer last, boolean isShotLater) {
        balanced = true;
        return order(Order.Kind.BALANCE, List.of(), new double[0])
                .givingBack(counters.flux.missing(last, isShotLater));
    }

    private Order gather() throws IOException {
        stage = Stage.GATHER;
        balanced = false;
        List<Shot> totals = world.totals();
        return order(Order.Kind.GATHER, totals, AmbientLevel.of(world.mesh, totals));
    }

    /** @param sparing see {@link #order} */
    private Order shoot(List<Shot> shots, double unsent, boolean sparing) {
        stage = Stage.SHOOT;
        balanced = false;
        left = unsent;
        return order(Order.Kind.SHOOT, shots, AmbientLevel.of(world.mesh, shots), sparing);
    }

    /**
     * Patches that may shoot: those with unshot flux, and reflecting patches where light is predicted; in closed
     * rooms all patches, as the uniform part of their radiosity is shot for all of them at once.
     */
    private List<Shot> candidates(Answer answer) {
        return world.joined(answer.candidates).stream().filter(shot -> shot.flux() > 0 || world.mesh.rooms.count() > 0
                || coarse != null && reflects(shot)).toList();
    }

    private boolean reflects(Shot shot) {
        return shot.trees().stream().anyMatch(tree -> IntStream.range(0, world.channels())
                .anyMatch(c -> world.mesh.faces.reflectance(tree.face(), c) > 0));
    }

    /**
     * Shots of unshot radiosity and the radiosity that is predicted to follow.
     *
     * @param h predicted irradiance, channels per vertex, W/m²
     */
    private List<Shot> withPrediction(Answer last, double[] h) throws IOException {
        List<Shot> candidates = candidates(world.answer(ALL));
        if (candidates.isEmpty()) {
            return List.of();
        }
        if (stage == Stage.NOTHING) {
            firstWeights.set(weight, last, candidates, (counts, c) -> coarse.weighted(h, c, counts));
        }
        return coarse.with(candidates, h, stage == Stage.NOTHING);
    }

    /** Shots of unshot radiosity alone. */
    private List<Shot> withoutPrediction(Answer last) throws IOException {
        List<Shot> candidates = candidates(world.answer(ALL));
        if (stage == Stage.NOTHING) {
            firstWeights.set(weight, last, candidates, firstWeights::interreflected);
        }
        return candidates.stream().map(world.mesh.rounding::of).toList();
    }

    /**
     * An order for all partitions. Orders to gather totals are sparing, as nothing is predicted from them, unless the
     * user asks for less unshot flux than the default; in an edited scene all orders are.
     */
    private Order order(Order.Kind kind, List<Shot> shots, double[] even) {
        boolean isOfAll = kind == Order.Kind.GATHER || kind == Order.Kind.REGATHER || kind == Order.Kind.MEND;
        return order(kind, shots, even, changes > 0 || isOfAll && wanted >= StopRule.DEFAULT_UNSENT);
    }

    /**
     * An order for all partitions. Partitions answer without candidates: most rounds need none, and all candidates
     * together are the whole mesh.
     *
     * @param sparing whether rays are omitted at random ("Russian roulette"). Orders to shoot predicted radiosity are
     *                not sparing but use the same rays in every round: in a white room the prediction multiplies
     *                differences between rounds by up to 10,000, and their sum would diverge
     */
    private Order order(Order.Kind kind, List<Shot> shots, double[] even, boolean sparing) {
        boolean isAnew = kind == Order.Kind.RENEW || kind == Order.Kind.REGATHER;
        return new Order(kind, shots,
                new Order.Rules(isAnew ? loop.toleranceAnew() : loop.tolerance(), weight, loop.meshError(), even,
                        new double[0], sparing && world.settings().factors() == FormFactors.RAYCAST,
                        loop.weightAnew(), List.of()),
                Order.Question.candidates(0));
    }

    @Override
    public int wanted() {
        return 0;
    }

    @Override
    public OptionalDouble aim() {
        return OptionalDouble.of(loop.asked());
    }

    @Override
    public void aim(double error) {
        if (error < loop.asked()) {
            loop.aim(error);
            changes = 0;
            stage = stage == Stage.DONE ? Stage.BALANCE : stage;
        }
    }

    @Override
    public boolean isEnough(Answer last, double unsent, double wanted) {
        return stage == Stage.DONE;
    }

    @Override
    public void write(DataOutput out) throws IOException {
        out.writeByte(stage.ordinal());
        out.writeByte(changes);
        loop.write(out);
        out.writeInt(splits);
        out.writeInt(elements);
        out.writeBoolean(refined);
        out.writeDouble(left);
        out.writeDouble(wanted);
        out.writeByte(mispredicted);
        out.writeBoolean(balanced);
        out.writeBoolean(isLargeChange);
        for (double w : weight) {
            out.writeDouble(w);
        }
    }

    @Override
    public void read(DataInput in) throws IOException {
        double before = read(in, weight);
        if (stage == Stage.DONE && changes == 0 && wanted < before && left > limit.flux()) {
            stage = Stage.SHOOT; // the resumed calculation has a lower limit of unshot flux
            left = Double.POSITIVE_INFINITY;
        }
    }

    /**
     * Reads what {@link #write} has written.
     *
     * @param weights modified: the weights that were in use
     * @return the unshot flux over emitted flux at which that calculation might end
     */
    private double read(DataInput in, double[] weights) throws IOException {
        stage = Stage.values()[in.readByte()];
        changes = in.readByte();
        loop.read(in);
        splits = in.readInt();
        elements = in.readInt();
        refined = in.readBoolean();
        left = in.readDouble();
        double before = in.readDouble();
        mispredicted = in.readByte();
        balanced = in.readBoolean();
        isLargeChange = in.readBoolean();
        for (int i = 0; i < weights.length; i++) {
            weights[i] = in.readDouble();
        }
        return before;
    }

    /**
     * How the calculation of an earlier scene ended.
     *
     * @param rules     tolerances and weights of the last round
     * @param isSettled whether the unshot radiosity of the elements is nothing but the noise of rays
     */
    record EarlierEnd(Order.Rules rules, boolean isSettled) { }

    /**
     * Reads the state that an earlier scene's calculation wrote, and goes on from that state with the edited scene.
     *
     * @param earlier initial mesh of the earlier scene
     * @return how the earlier calculation ended; empty where that was stopped before its end
     */
    Optional<EarlierEnd> readChanged(DataInput in, InitialMesh earlier) throws IOException {
        double[] old = new double[Weights.count(earlier.rooms, world.channels())];
        read(in, old);
        boolean isDone = stage == Stage.DONE;
        int before = changes;
        for (int i = 0; i < weight.length; i++) {
            int c = i % world.channels();
            double lamps = earlier.emitted[c] > 0 && world.mesh.emitted[c] > 0
                    ? earlier.emitted[c] / world.mesh.emitted[c] : 1;
            weight[i] = old[weight.length == old.length ? i : c] * lamps;
        }
        stage = Stage.SHOOT;
        splits = 0;
        refined = false;
        left = Double.POSITIVE_INFINITY;
        mispredicted = 0;
        balanced = true;
        isLargeChange = false;
        changes = Math.min(MOST_CHANGES, before + 1);
        return !isDone ? Optional.empty() : Optional.of(new EarlierEnd(
                new Order.Rules(loop.tolerance(), old, loop.meshError()), before == 0));
    }

    /** The weights in use, not copied; see {@link Weights}. */
    double[] weight() {
        return weight;
    }
}
