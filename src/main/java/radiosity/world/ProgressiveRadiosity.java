package radiosity.world;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import radiosity.scene.SceneFormatException;

/**
 * The loop of figure 7: who has unshot flux shoots, everybody receives, until little enough is left.
 *
 * <p>Who shoots is the schedule's choice, see {@link Schedule}.
 */
public final class ProgressiveRadiosity {

    /** So often at least it is asked within a round how things stand, for whoever watches; it costs time. */
    private static final double ANSWER_SECONDS = 4;

    private final World world;
    private final StopRule stop;
    private int shots;
    private int rounds;
    private final Flux flux;
    /** What is left of the present round; null where there is none. */
    private Order pending;
    /** Who shoots in the round that was begun last. */
    private List<Shot> shooters = List.of();
    /** What was left to shoot when the present round was chosen, relative to what was emitted. */
    private double unsent = Double.POSITIVE_INFINITY;
    /** The round after the present one; null where it is not chosen yet. */
    private Choice following;
    private Planner planner;
    private Answer answer;
    /** Whether that is the answer to the last order. */
    private boolean isKnown = true;
    /** When the last answer came, ns. */
    private long known;
    /** The round whose new vertices have not gathered yet; 0 where there is none. */
    private int dark;
    /** The answer before they were made: until they have gathered, it is what the light that is shown comes to. */
    private Answer beforeDark;
    private final Pace pace;

    /** @param unsent when it was chosen */
    private record Choice(Order round, double unsent) { }

    public ProgressiveRadiosity(World world, StopRule stop) {
        this(world, stop, Pace.STEP_SECONDS);
    }

    /** @param stepSeconds how long a step may take; without influence on the result */
    ProgressiveRadiosity(World world, StopRule stop, double stepSeconds) {
        this.world = world;
        this.stop = stop;
        known = world.now();
        pace = new Pace(stepSeconds / world.stepsAhead());
        flux = new Flux(world.mesh);
    }

    /**
     * Shoots until the stop rule holds or the listener asks to stop.
     *
     * @throws IOException where a partition cannot be reached
     */
    public void run(RoundListener listener) throws IOException {
        prepare();
        answer = world.answer(Order.plain(Order.Kind.ASK, Integer.MAX_VALUE));
        if (rounds == 0) {
            flux.countLights(answer);
        }
        boolean goOn = true;
        while (goOn && !isDone()) {
            if (pending == null) {
                unsent = flux.unsent(answer);
                pending = planner.next(answer, unsent, nowAndThen(listener));
                if (pending == null) {
                    return;
                }
            }
            step();
            goOn = listener.afterRound(progress());
        }
        know();
    }

    /** Asks how things stand, where the last order wanted no answer. */
    private void know() throws IOException {
        readAll();
        if (!isKnown) {
            answer = world.answer(Order.plain(Order.Kind.ASK, 0));
            isKnown = true;
        }
    }

    /** Asks the listener as often as between steps. */
    private BooleanSupplier nowAndThen(RoundListener listener) {
        long[] asked = {world.now()};
        return () -> {
            if ((world.now() - asked[0]) * 1e-9 < Pace.STEP_SECONDS) {
                return true;
            }
            asked[0] = world.now();
            return listener.afterRound(progress());
        };
    }

    private void prepare() {
        if (planner == null) {
            planner = world.settings().schedule().planner(world);
        }
    }

    private boolean isDone() {
        double left = pending == null ? flux.unsent(answer) : unsent;
        boolean between = pending == null || !pending.begun();
        return shots >= stop.shots() || between && planner.isEnough(left, stop.unsent());
    }

    /*---- Rounds that overlap ----*/

    /** All of a round was begun: what comes then, where that is chosen before the round is over. */
    private void turn(Order done) throws IOException {
        if (following == null && done.changes() && planner.looksAhead()) {
            while (world.unread() > 1) {
                read();
            }
            following = choose();
        }
        if (following != null) {
            pending = following.round();
            unsent = following.unsent();
            following = null;
        }
    }

    /** From the last answer, which knows nothing of the round after it; where too little is left, all is asked for. */
    private Choice choose() throws IOException {
        double left = flux.unsent(answer);
        List<Shot> before = pending == null || pending.begun() ? shooters : pending.shots();
        Order next = planner.next(answer.without(before, world.mesh.faces, world.mesh.fluxScale()), left, () -> true);
        return new Choice(next == null ? Order.plain(Order.Kind.ASK, Integer.MAX_VALUE) : next, left);
    }

    private void read() throws IOException {
        answer = world.read(pace::took);
        known = world.now();
        isKnown = world.unread() == 0 && (pending == null || !pending.begun());
    }

    /** Reads what is answered by now, and chooses by it what was to be chosen by it. */
    private void readAll() throws IOException {
        while (world.unread() > 0) {
            read();
        }
        if (pending != null && pending.changes() && following == null && planner.looksAhead()) {
            following = choose();
        }
    }

    /** As much of the present round as takes no longer than a user waits. Where it is cut has no influence. */
    private void step() throws IOException {
        if (!pending.begun()) {
            begin();
        }
        boolean counts = pending.kind() == Order.Kind.SHOOT;
        int size = Math.min(pending.shots().size(), pace.size(pending.kind(), answer.elements, pending.shots().size()));
        if (counts) {
            size = Math.min(size, stop.shots() - shots);
        }
        Order now = pending.first(size);
        if (now.more() && world.now() - known <= ANSWER_SECONDS * 1e9) {
            now = now.naming(-1);
        } else if (now.more()) {
            readAll();
        }
        carryOut(now);
        pending = now.more() ? pending.after(size) : null;
        if (counts) {
            shots += size;
            now.shots().forEach(flux::count);
        }
        if (pending == null) {
            turn(now);
        }
    }

    private void begin() throws IOException {
        pending = pending.changes() ? pending.numbered(++rounds) : pending;
        pending = pending.kind() == Order.Kind.SHOOT ? pending.givingBack(missing()) : pending;
        shooters = pending.shots();
    }

    private void carryOut(Order now) throws IOException {
        Answer before = answer;
        boolean isRead = now.isAnswered() && (now.more() || !planner.looksAhead() || !now.changes());
        if (now.kind() == Order.Kind.ROWS || isRead) {
            world.finish(pace::took);
            long begin = world.now();
            await(now);
            pace.took(now.shots().size(), (world.now() - begin) * 1e-9);
        } else {
            isKnown = false;
            world.begin(now, pace::took);
        }
        if (now.kind() == Order.Kind.SPLIT && answer.elements > before.elements) {
            dark = now.number();
            beforeDark = before;
        } else if (now.kind() != Order.Kind.ROWS && !now.more()) {
            dark = 0;
        }
    }

    private void await(Order now) throws IOException {
        if (now.kind() == Order.Kind.ROWS) {
            planner.take(now.shots().size(), world.round(now));
            return;
        }
        answer = world.answer(now);
        isKnown = true;
        known = world.now();
    }

    /** To be given back, where all flux must be received: W/m², one per channel. Empty elsewhere. */
    private double[] missing() {
        return world.mesh.conserves() && shots > 0 ? flux.missing(answer) : new double[0];
    }

    /** What the light that is shown comes to. */
    private Answer shown() {
        return dark == 0 ? answer : beforeDark;
    }

    public Progress progress() {
        return new Progress(shots, rounds, flux.unsent(shown()), answer.elements, dark != 0);
    }

    /**
     * Where the light went so far.
     *
     * @throws UncheckedIOException where a partition cannot be reached
     */
    public EnergyLedger ledger() {
        try {
            know();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return flux.ofAllLayers(shown());
    }

    /** Everything so far, merged from all partitions; may be asked for between rounds. */
    public Solution solution() throws IOException {
        know();
        List<byte[]> blocks = world.blocks();
        return new Merger(world.mesh, blocks, dark).solution(shots, rounds,
                Flux.sum(shown().unshotFlux), ledger(), state(blocks));
    }

    /**
     * How far the solution so far can be trusted; takes a small part of the time that the solution took.
     *
     * @param threads at least 1
     * @return nothing where some vertices have not gathered yet, nobody has shot, or all is dark
     */
    public Optional<Certificate> certificate(int threads) throws IOException {
        if (dark != 0 || shots == 0) {
            return Optional.empty();
        }
        return Optional.of(new Audit(world.mesh, world.blocks(), flux.byChannel(answer), answer.elements, threads)
                .certificate(Flux.sum(answer.unshotFlux))).filter(certificate -> certificate.points() > 0);
    }

    /** What {@link #resume} takes; for whoever wants to go on later. May be asked for between rounds. */
    public byte[] state() throws IOException {
        readAll();
        return state(world.blocks());
    }

    private byte[] state(List<byte[]> blocks) {
        return Wire.bytes(out -> {
            out.writeUTF(world.mesh.fingerprint());
            out.writeInt(shots);
            out.writeInt(rounds);
            out.writeInt(dark);
            if (dark != 0) {
                beforeDark.write(out);
            }
            flux.write(out);
            planner.write(out);
            byte[] rest = pending == null || !pending.changes() ? new byte[0] : pending.encode();
            Wire.write(out, rest);
            out.writeDouble(unsent);
            Wire.write(out, following == null ? new byte[0] : following.round().encode());
            out.writeDouble(following == null ? 0 : following.unsent());
            for (byte[] block : blocks) {
                Wire.write(out, block);
            }
        });
    }

    /**
     * Goes on from where an earlier calculation stopped: the same scene and settings give the same bits as without a
     * stop. To be called before {@link #run}.
     *
     * @param state of the earlier {@link Solution}
     * @throws SceneFormatException where scene or settings are others
     */
    public void resume(byte[] state) throws IOException {
        try (DataInputStream in = Wire.input(state)) {
            String before = in.readUTF();
            if (!before.equals(world.mesh.fingerprint())) {
                throw new SceneFormatException("the saved calculation", "", "the same scene and settings ("
                        + world.mesh.fingerprint() + ")", before);
            }
            shots = in.readInt();
            rounds = in.readInt();
            dark = in.readInt();
            if (dark != 0) {
                beforeDark = new Answer(world.mesh.faces, world.mesh.fluxScale());
                beforeDark.read(in);
            }
            flux.read(in);
            prepare();
            planner.read(in);
            byte[] rest = Wire.bytes(in);
            pending = rest.length == 0 ? null : Order.decode(rest);
            unsent = in.readDouble();
            byte[] next = Wire.bytes(in);
            double left = in.readDouble();
            following = next.length == 0 ? null : new Choice(Order.decode(next), left);
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
        return shots;
    }
}
