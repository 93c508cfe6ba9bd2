package radiosity.world;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import radiosity.scene.SceneFormatException;

/**
 * The loop of figure 7: who has unshot flux shoots, everybody receives, until little enough is left.
 *
 * <p>Who shoots is the schedule's choice, see {@link Schedule}.
 */
public final class ProgressiveRadiosity {

    private final World world;
    private final StopRule stop;
    private int shots;
    private int rounds;
    /** One per channel: flux that left shooters, W. */
    private final double[] shotFlux;
    /** What a round that was cut short has still to shoot; null where there is none. */
    private Order pending;
    private Planner planner;
    private Answer answer;

    public ProgressiveRadiosity(World world, StopRule stop) {
        this.world = world;
        this.stop = stop;
        shotFlux = new double[world.channels()];
    }

    /**
     * Shoots until the stop rule holds or the listener asks to stop.
     *
     * @throws IOException where a partition cannot be reached
     */
    public void run(RoundListener listener) throws IOException {
        prepare();
        answer = world.answer(new Order(Order.Kind.ASK, 0, List.of(), 0, new double[0], 0, Integer.MAX_VALUE));
        while (!isDone() && round() && listener.afterRound(progress())) {
            continue;
        }
    }

    private void prepare() throws IOException {
        if (planner == null) {
            planner = world.mesh.predicts() ? new Prediction(world) : new ShootAndSort(world.channels());
        }
    }

    /** @return whether anything was left to shoot */
    private boolean round() throws IOException {
        boolean begun = pending != null;
        Order order = begun ? pending : planner.next(answer, shots);
        int size = Math.min(order.shots().size(), stop.shots() - shots);
        if (size == 0) {
            return false;
        }
        rounds += begun ? 0 : 1;
        Order now = order.cut(rounds, 0, size);
        pending = now.kind() == Order.Kind.SHOOT ? null : order.cut(rounds, size, order.shots().size());
        now.shots().forEach(this::count);
        shots += size;
        answer = world.answer(now);
        return true;
    }

    private void count(Shot shot) {
        double area = world.mesh.faces.size() * world.mesh.faces.size();
        double[] flux = shot.flux(world.mesh.faces);
        for (int c = 0; c < shotFlux.length; c++) {
            shotFlux[c] += flux[c] * area;
        }
    }

    private boolean isDone() {
        return shots >= stop.shots() || pending == null && planner.isEnough(unsent(), stop.unsent());
    }

    private double unsent() {
        double emitted = world.mesh.totalEmitted();
        return emitted == 0 ? 0 : answer.unshotFlux.value() / emitted;
    }

    public Progress progress() {
        return new Progress(shots, rounds, unsent(), answer.elements);
    }

    /** Where the light went so far. */
    public EnergyLedger ledger() {
        return new EnergyLedger(world.mesh.emitted.clone(), shotFlux.clone(), values(answer.received),
                values(answer.absorbed), values(answer.unshot));
    }

    private static double[] values(ExactSum[] sums) {
        double[] values = new double[sums.length];
        for (int c = 0; c < sums.length; c++) {
            values[c] = sums[c].value();
        }
        return values;
    }

    /** Everything so far, merged from all partitions; may be asked for between rounds. */
    public Solution solution() throws IOException {
        List<byte[]> blocks = new ArrayList<>();
        for (int b = 0; b < world.mesh.blocks.size(); b++) {
            blocks.add(world.block(b));
        }
        return new Merger(world.mesh, blocks).solution(shots, rounds, answer.unshotFlux.value(), ledger(), state(blocks));
    }

    private byte[] state(List<byte[]> blocks) {
        return Wire.bytes(out -> {
            out.writeUTF(world.mesh.fingerprint());
            out.writeInt(shots);
            out.writeInt(rounds);
            for (double flux : shotFlux) {
                out.writeDouble(flux);
            }
            planner.write(out);
            byte[] rest = pending == null ? new byte[0] : pending.encode();
            out.writeInt(rest.length);
            out.write(rest);
            for (byte[] block : blocks) {
                out.writeInt(block.length);
                out.write(block);
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
            for (int c = 0; c < shotFlux.length; c++) {
                shotFlux[c] = in.readDouble();
            }
            prepare();
            planner.read(in);
            byte[] rest = in.readNBytes(in.readInt());
            pending = rest.length == 0 ? null : Order.decode(rest);
            for (int b = 0; b < world.mesh.blocks.size(); b++) {
                world.restore(b, in.readNBytes(in.readInt()));
            }
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    /** Patches that have shot. */
    public int shots() {
        return shots;
    }
}
