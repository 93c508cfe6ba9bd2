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
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.prediction.AmbientLevel;
import radiosity.prediction.CoarseSystem;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.settings.FormFactors;
import radiosity.settings.StopRule;
import radiosity.setup.InitialMesh;
import radiosity.solution.Certificate;

/**
 * Every patch shoots once what it will have in the end, as far as that can be predicted, then what the prediction
 * lacked.
 *
 * <p>The linear system of a coarse mesh is made once; it turns unshot radiosity into the radiosity that will come of
 * it. What is shot is both together (overshooting: M. Feda, W. Purgathofer, Accelerating radiosity by overshooting,
 * 1992), so what is left after a round is small, and signed, at any reflectance. As soon as it is, the mesh is
 * subdivided where the light on it requires it, and the new vertices gather all that was shot before.
 */
final class Prediction implements Planner {

    /** Unshot flux, relative to the emitted, at which the mesh is looked at. */
    private static final double SETTLED = 0.05;
    private static final int MOST_SPLITS = 12;
    /** How often shots may leave more unshot than before: then nothing is predicted until the mesh is finer. */
    private static final int MOST_MISPREDICTED = 3;
    /** What the rows of the coarse system are good to: form factor that one ray may stand for. */
    private static final double ROW_TOLERANCE = 0.02;

    /** Patches of the coarse mesh up to which light is predicted: each sees some hundred others, some 2 kB. */
    private static final int MOST_PREDICTED = 100_000;

    /** Everybody. */
    private static final Order ALL = Order.asking(Order.Kind.ASK, Integer.MAX_VALUE);

    /** Flux that is predicted to matter on some of the faces, W. */
    private interface PredictedFlux {
        double of(IntPredicate counts, int channel);
    }

    /** What the last round was. */
    private enum Stage { NOTHING, SHOOT, SPLIT, GATHER, RENEW, REGATHER, AVERAGE, BALANCE, DONE, MEND }

    /** Changes of the scene of which no more count. */
    private static final int MOST_CHANGES = 3;
    /** Unshot flux of a changed scene, relative to the emitted, above which what becomes of it is predicted. */
    private static final double PREDICTED = 0.1;
    /** Unshot flux, relative to the emitted, that may be left, over the error: most of it has both signs. */
    private static final double ENOUGH = 0.3;
    /** The same, over the error that is asked for, of what is left if that of one sign is taken off the other. */
    private static final double ENOUGH_ONE_SIDED = 0.05;
    /** Error after some changes, over that when all had gathered anew last, that is taken. */
    private static final double WORSE = 1.15;
    /** Part of the unshot flux that may be left to later rounds of a changed scene. */
    private static final double LEFT = 0.05;

    /**
     * What an earlier scene's calculation ended with.
     *
     * @param rules     how closely it looked
     * @param isSettled whether what elements have not shot is only the noise of rays
     */
    record Earlier(Order.Rules rules, boolean isSettled) { }

    /** Looks at the solution anew; nothing where there is no light to look at. */
    interface Audit {
        Optional<Certificate> certificate() throws IOException;
    }

    private final World world;
    private final double wanted;
    /** Of an answer, see {@link Flux#oneSided}. */
    private final ToDoubleFunction<Answer> oneSided;
    /** Of the scene, scene units squared. */
    private final double area;
    /** Null where the scene is too large for it. */
    private final CoarseSystem coarse;
    private final AccuracyLoop loop;
    private final Audit audit;
    /** See {@link Weights}: 1 / mean reflected radiosity, m²/W; irradiance of dark surfaces counts a little. */
    private final double[] weight;
    private Stage stage = Stage.NOTHING;
    private int splits;
    private int elements;
    private boolean refined;
    /**
     * Unshot flux before the last shots, relative to the emitted: where they leave more, the next ones are without
     * prediction. At the end what is left, or 0 where that is more than was to be.
     */
    private double left = Double.POSITIVE_INFINITY;
    /** How often shots have left more unshot than before, since the mesh was looked at last. */
    private int mispredicted;
    /** How often the scene was changed since all have gathered anew; above 0, the light is an earlier scene's. */
    private int changes;

    /** @param wanted unshot flux at which the calculation may end, relative to the emitted */
    Prediction(World world, double wanted, ToDoubleFunction<Answer> oneSided, Audit audit) {
        this.audit = audit;
        this.oneSided = oneSided;
        this.wanted = wanted;
        this.world = world;
        area = world.mesh.faces.area() * world.mesh.faces.size() * world.mesh.faces.size();
        loop = new AccuracyLoop(world.mesh);
        weight = new double[Weights.count(world.mesh.rooms, world.channels())];
        Arrays.fill(weight, 1);
        coarse = world.mesh.coarse.patches() - world.mesh.representatives.followers() <= MOST_PREDICTED
                ? new CoarseSystem(world.mesh, world.parallel) : null;
    }

    /** What the coarse system is made of; it changes nothing, and is asked for again by who goes on later. */
    private Order rows() {
        double[] equal = new double[world.channels()];
        Arrays.fill(equal, 1);
        return new Order(Order.Kind.ROWS, coarse.importance(),
                new Order.Rules(ROW_TOLERANCE, equal, 0, new double[0], new double[0]), Order.Question.candidates(0));
    }

    @Override
    public void take(int shots, List<byte[]> rows) throws IOException {
        coarse.take(shots, rows);
    }

    @Override
    public Order next(Answer last, double unsent, BooleanSupplier goOn) throws IOException {
        if (changes > 0) {
            return nextOfChange(last, unsent, goOn);
        }
        switch (stage) {
            case SPLIT -> {
                refined = last.elements == elements || splits == MOST_SPLITS;
                if (last.elements > elements) {
                    return gather();
                }
            }
            case GATHER -> {
                if (!refined) {
                    return split(last);
                }
            }
            case RENEW -> {
                return regather();
            }
            case REGATHER -> {
                return average();
            }
            case AVERAGE, MEND, BALANCE -> {
                return stage != Stage.BALANCE && world.mesh.boundsReceived() ? balance() : refine(last);
            }
            default -> { }
        }
        if (!refined && stage == Stage.SHOOT && unsent <= SETTLED) {
            return split(last);
        }
        if (coarse != null && !coarse.isMade()) {
            return rows();
        }
        boolean isWorse = stage == Stage.SHOOT && unsent >= left;
        boolean isEnough = isEnough(last, unsent);
        if (refined && stage == Stage.SHOOT && (isEnough || isWorse && mispredicted == MOST_MISPREDICTED)) {
            left = unsent <= enough() ? unsent : 0;
            return isEnough && !loop.lacksRays() ? mend() : renew();
        }
        boolean isPredicted = coarse != null && !isWorse && mispredicted < MOST_MISPREDICTED;
        List<Shot> shots = isPredicted ? withPrediction(last, goOn) : withoutPrediction(last);
        if (shots.isEmpty()) {
            return null;
        }
        mispredicted += isWorse && mispredicted < MOST_MISPREDICTED ? 1 : 0;
        return shoot(shots, unsent);
    }

    /** Looks at the solution, and refines what most of its error is due to; null where that is enough. */
    private Order refine(Answer last) throws IOException {
        Optional<Certificate> certificate = wanted > StopRule.DEFAULT_UNSENT ? Optional.empty() : audit.certificate();
        AccuracyLoop.Refine refine = certificate.isEmpty() ? AccuracyLoop.Refine.NOTHING
                : loop.refine(certificate.get(), last.elements);
        return switch (refine) {
            case MESH -> {
                left = Double.POSITIVE_INFINITY;
                splits = 0;
                mispredicted = 0;
                yield split(last);
            }
            case RAYS -> renew();
            case NOTHING -> {
                stage = Stage.DONE;
                yield null;
            }
        };
    }

    /**
     * Unshot flux, relative to the emitted, at which no more is shot: a part of the error that points have found, or
     * of the one that is asked for if that is more, and less where the user has asked for less.
     */
    private double enough() {
        double error = Math.max(loop.asked(), loop.found());
        return wanted < StopRule.DEFAULT_UNSENT ? wanted : Math.max(wanted, ENOUGH * error);
    }

    private boolean isEnough(Answer last, double unsent) {
        return unsent <= enough()
                && oneSided.applyAsDouble(last) <= Math.max(wanted, ENOUGH_ONE_SIDED * loop.asked());
    }

    /**
     * Light and mesh are those of an earlier scene, and what its changes leave unshot is signed: it is shot where it
     * is, the mesh is divided where the light has become another, and nobody gathers anew all that was ever shot but
     * those who have received less than nothing.
     */
    private Order nextOfChange(Answer last, double unsent, BooleanSupplier goOn) throws IOException {
        if (stage == Stage.SPLIT) {
            refined = last.elements == elements || splits == MOST_SPLITS;
            left = Double.POSITIVE_INFINITY;
            if (last.elements > elements) {
                return gather();
            }
        }
        if (stage == Stage.MEND && world.mesh.boundsReceived()) {
            return balance();
        }
        if (stage == Stage.MEND || stage == Stage.BALANCE) {
            return endOfChange(unsent);
        }
        if (unsent > enough() && unsent < left) {
            if (unsent > PREDICTED && coarse != null && !coarse.isMade()) {
                return rows();
            }
            List<Shot> shots = unsent > PREDICTED && coarse != null ? withPrediction(last, goOn) : largest();
            if (!shots.isEmpty()) {
                return shoot(shots, unsent);
            }
        }
        return refined ? mend() : split(last);
    }

    /**
     * Where independent points find clearly more error than was asked for, all gather anew what was ever shot; after
     * several changes also where they find more than before, and most of it is noise: that of one change is little, but
     * that of many adds up.
     */
    private Order endOfChange(double unsent) throws IOException {
        Optional<Certificate> certificate = wanted > StopRule.DEFAULT_UNSENT ? Optional.empty() : audit.certificate();
        if (certificate.isPresent() && certificate.get().expected() > WORSE * usual(certificate.get())) {
            changes = 0;
            left = unsent <= enough() ? unsent : 0;
            return renew();
        }
        stage = Stage.DONE;
        return null;
    }

    /** The error that is no reason to do anything. */
    private double usual(Certificate now) {
        boolean isNoise = 2 * now.sampling() * now.sampling() > now.expected() * now.expected();
        return changes == MOST_CHANGES && isNoise ? loop.found() : Math.max(loop.asked(), loop.found());
    }

    /** Those with most unshot flux, who have most of it together. */
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
     * What later shots take back goes along other rays than what came before, and where little arrives more may be
     * taken back than had come: there vertices gather anew what surfaces have shot in all, none of which is negative.
     */
    private Order mend() throws IOException {
        stage = Stage.MEND;
        List<Shot> totals = world.totals();
        return order(Order.Kind.MEND, totals, AmbientLevel.lowest(world.mesh, totals));
    }

    /**
     * All vertices gather anew, at once, what surfaces radiate then: that is averaged with what they had, unless that
     * was negative, and as its rays are others the average has less noise. So is it where the last shots left more
     * unshot than there was before: what was predicted too much is taken back by all at once.
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

    private Order split(Answer last) {
        stage = Stage.SPLIT;
        splits++;
        elements = last.elements;
        return order(Order.Kind.SPLIT, List.of(), new double[0]);
    }

    private Order average() {
        stage = Stage.AVERAGE;
        Order order = order(Order.Kind.AVERAGE, List.of(), new double[0]);
        loop.gatheredAnew();
        return order;
    }

    /** Nobody shoots: vertices are given back what rays have lost. */
    private Order balance() {
        stage = Stage.BALANCE;
        return order(Order.Kind.BALANCE, List.of(), new double[0]);
    }

    private Order gather() throws IOException {
        stage = Stage.GATHER;
        List<Shot> totals = world.totals();
        return order(Order.Kind.GATHER, totals, AmbientLevel.of(world.mesh, totals));
    }

    private Order shoot(List<Shot> shots, double unsent) {
        stage = Stage.SHOOT;
        left = unsent;
        return order(Order.Kind.SHOOT, shots, AmbientLevel.of(world.mesh, shots));
    }

    /**
     * All that have something to shoot, or will have if that is predicted; in closed rooms all, as what they have in
     * common is taken off.
     */
    private List<Shot> candidates(Answer answer) {
        return world.joined(answer.candidates).stream()
                .filter(shot -> shot.flux() > 0 || world.mesh.rooms.count() > 0 || coarse != null && reflects(shot))
                        .toList();
    }

    private boolean reflects(Shot shot) {
        Faces faces = world.mesh.faces;
        return shot.trees().stream().anyMatch(tree -> IntStream.range(0, faces.channels())
                .anyMatch(c -> faces.reflectance(tree.face(), c) > 0));
    }

    /** With what will become of them, which is reckoned while they are on their way; none where it was not to go on. */
    private List<Shot> withPrediction(Answer last, BooleanSupplier goOn) throws IOException {
        World.Begun means = world.begin(Order.asking(Order.Kind.MEANS, Integer.MAX_VALUE), World.NOBODY);
        World.Begun all = world.begin(ALL, World.NOBODY);
        double[] h = coarse.irradiance(coarse.unshot(world.joined(means.answer(World.NOBODY).candidates)), goOn);
        List<Shot> candidates = candidates(all.answer(World.NOBODY));
        if (h == null || candidates.isEmpty()) {
            return List.of();
        }
        if (stage == Stage.NOTHING) {
            weigh(last, candidates, (counts, c) -> coarse.weighted(h, c, counts));
        }
        return coarse.with(candidates, h, stage == Stage.NOTHING);
    }

    /** In a scene of too many patches every block shoots what it has. */
    private List<Shot> withoutPrediction(Answer last) throws IOException {
        List<Shot> candidates = candidates(world.answer(ALL));
        if (stage == Stage.NOTHING) {
            weigh(last, candidates, this::interreflected);
        }
        return candidates.stream().map(world.mesh.rounding::of).toList();
    }

    /** Flux that would be reflected, as counted by {@link Faces#importance}, if every surface saw every other alike. */
    private double interreflected(IntPredicate counts, int c) {
        Faces faces = world.mesh.faces;
        double whole = 0;
        double emitted = 0;
        double reflected = 0;
        double counted = 0;
        for (int f = 0; f < faces.count(); f++) {
            double a = counts.test(f) ? faces.area(f) : 0;
            whole += a;
            emitted += a * faces.exitance(f, c);
            reflected += a * faces.reflectance(f, c);
            counted += a * faces.importance(f, c);
        }
        return emitted == 0 ? 0 : emitted * counted / (whole - reflected) * area / faces.area();
    }

    /** By the radiosity that is there and is predicted, over all area; a channel without light does not count. */
    private void weigh(Answer last, List<Shot> unshot, PredictedFlux predicted) {
        int channels = world.channels();
        for (int c = 0; c < channels; c++) {
            double received = last.received[c].value();
            double reflected = Math.max(Faces.LEAST_IMPORTANCE * received, received - last.absorbed[c].value());
            double lit = predicted.of(f -> true, c) + reflected;
            weight[c] = lit > 0 ? area / lit : 0;
        }
        for (int i = weight.length - 1; i >= 0 && weight.length > channels; i--) {
            weight[i] = weightIn(i / channels - 1, i % channels, unshot, predicted);
        }
    }

    /**
     * The same over the faces of a closed room, or of none; no less than that of the whole, and that where no light was
     * seen.
     */
    private double weightIn(int room, int c, List<Shot> unshot, PredictedFlux predicted) {
        Faces faces = world.mesh.faces;
        IntPredicate counts = f -> world.mesh.rooms.room(f) == room;
        double emitted = 0;
        double within = 0;
        for (int f = 0; f < faces.count(); f++) {
            within += counts.test(f) ? faces.area(f) : 0;
            emitted += counts.test(f) ? faces.area(f) * faces.exitance(f, c) : 0;
        }
        double[] leaving = new double[world.channels()];
        unshot.stream().flatMap(shot -> shot.trees().stream()).filter(tree -> counts.test(tree.face()))
                .forEach(tree -> tree.addFlux(faces, leaving));
        double unit = area / faces.area();
        double lit = predicted.of(counts, c) + unit * Math.max(0, leaving[c] - emitted);
        return lit > 0 ? Math.max(weight[c], unit * within / lit) : weight[c];
    }

    /**
     * No candidates are named: most rounds need none, and all of them together are the whole mesh. What is predicted is
     * shot along the same rays in every round, each at every point: in a white room the prediction makes 10,000 times
     * as much of what rounds differ by, and their sum would grow without end. Others are sparing, as nothing is made of
     * them, but where less is to be left unshot than is usual; what changes leave unshot is shot only as long as it
     * becomes less.
     */
    private Order order(Order.Kind kind, List<Shot> shots, double[] even) {
        boolean isOfAll = kind == Order.Kind.GATHER || kind == Order.Kind.REGATHER || kind == Order.Kind.MEND;
        boolean isAnew = kind == Order.Kind.REGATHER;
        boolean sparing = world.settings().factors() == FormFactors.RAYCAST
                && (changes > 0 || isOfAll && wanted >= StopRule.DEFAULT_UNSENT);
        return new Order(kind, shots,
                new Order.Rules(isAnew ? loop.toleranceAnew() : loop.tolerance(), weight, loop.meshError(), even,
                        new double[0], sparing, loop.weightAnew()),
                Order.Question.candidates(0));
    }

    /** It asks when it knows the coarse system. */
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

    /** The accuracy that was asked for is reached, or cannot be. */
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
        out.writeByte(mispredicted);
        for (double w : weight) {
            out.writeDouble(w);
        }
    }

    @Override
    public void read(DataInput in) throws IOException {
        stage = Stage.values()[in.readByte()];
        changes = in.readByte();
        loop.read(in);
        splits = in.readInt();
        elements = in.readInt();
        refined = in.readBoolean();
        left = in.readDouble();
        mispredicted = in.readByte();
        for (int c = 0; c < weight.length; c++) {
            weight[c] = in.readDouble();
        }
        if (stage == Stage.DONE && changes == 0 && left > enough()) {
            stage = Stage.SHOOT; // less is to be left now
            left = Double.POSITIVE_INFINITY;
        }
    }

    /**
     * Reads what an earlier scene's calculation wrote, to go on with that of a changed scene.
     *
     * @return how closely it looked, by its own weights; nothing where it was not at its end
     */
    Optional<Earlier> readChanged(DataInput in, InitialMesh earlier) throws IOException {
        boolean isDone = Stage.values()[in.readByte()] == Stage.DONE;
        int before = in.readByte();
        loop.read(in);
        splits = in.readInt();
        elements = in.readInt();
        refined = in.readBoolean();
        in.readDouble();
        in.readByte();
        double[] old = new double[Weights.count(earlier.rooms, world.channels())];
        for (int c = 0; c < old.length; c++) {
            old[c] = in.readDouble();
        }
        for (int i = 0; i < weight.length; i++) {
            int c = i % world.channels();
            double lamps = earlier.emitted[c] > 0 && world.mesh.emitted[c] > 0
                    ? earlier.emitted[c] / world.mesh.emitted[c] : 1;
            weight[i] = old[weight.length == old.length ? i : c] * lamps;
        }
        stage = Stage.SHOOT;
        splits = 0;
        refined = false;
        changes = Math.min(MOST_CHANGES, before + 1);
        return !isDone ? Optional.empty() : Optional.of(new Earlier(new Order.Rules(loop.tolerance(), old,
                loop.meshError(), new double[0], new double[0]), before == 0));
    }

    /** See {@link Weights}. */
    double[] weight() {
        return weight;
    }
}
