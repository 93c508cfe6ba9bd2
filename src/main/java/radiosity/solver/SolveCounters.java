package radiosity.solver;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.List;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.setup.InitialMesh;
import radiosity.solution.EnergyLedger;
import radiosity.solution.Progress;
import radiosity.util.ParallelFor;

/** Counts shots, rounds, estimates and flux that was emitted and shot; knows the answer that shown light belongs to. */
final class SolveCounters {

    private final InitialMesh mesh;
    private int shots;
    private int rounds;
    private int estimates;
    /** Number of the round that made or renewed vertices which have not gathered yet; 0 where there are none. */
    private int dark;
    /** The answer before the {@link #dark} round; until its vertices have gathered, this answer is shown. */
    private Answer beforeDark;
    /** The answer before vertices gathered anew, until the next shot; else null. */
    private Answer beforeRenewal;
    final Flux flux;

    SolveCounters(InitialMesh mesh, ParallelFor parallel) {
        this.mesh = mesh;
        flux = new Flux(mesh, parallel);
    }

    /** Counts the flux of lights without geometry, at the beginning of a calculation. */
    void begin(Answer first) {
        if (rounds == 0) {
            flux.countLights(first);
        }
    }

    /**
     * Goes on counting after an earlier scene's calculation.
     *
     * @param isMoved  whether the geometry has changed
     * @param surfaces flux that the elements have shot, one per channel, W
     * @param totals   the radiosities that the elements have shot
     * @param lights   flux of sources without geometry that arrives, one per channel, W
     */
    void change(SolveCounters earlier, boolean isMoved, double[] surfaces, List<Shot> totals, double[] lights) {
        shots = earlier.shots;
        rounds = earlier.rounds;
        flux.change(isMoved ? null : earlier.flux, surfaces, totals, lights);
    }

    /** Begins a round with some shots, and returns its number. */
    int nextRound(List<Shot> shots) {
        flux.begin(shots);
        return ++rounds;
    }

    /**
     * Counts an order, or a part of an order, that was begun.
     *
     * @param before the last answer before the order
     * @param after  the last answer at present
     */
    void count(Order done, Answer before, Answer after) {
        switch (done.kind()) {
            case SHOOT -> {
                shots += done.shots().size();
                flux.count(done.shots());
                beforeRenewal = null;
            }
            case RENEW -> flux.mark(done.shots());
            case MEND -> beforeRenewal = before;
            case AVERAGE -> {
                beforeRenewal = beforeDark;
                flux.countMarked();
            }
            default -> { }
        }
        if (done.kind() == Order.Kind.SPLIT && after.elements > before.elements || done.kind() == Order.Kind.RENEW) {
            beforeDark = dark == done.number() ? beforeDark : before;
            dark = done.number();
        } else if (done.kind() != Order.Kind.ROWS && done.kind() != Order.Kind.REGATHER && !done.more()) {
            dark = 0;
        }
    }

    /** Patches that have shot. */
    int shots() {
        return shots;
    }

    int rounds() {
        return rounds;
    }

    /** Counts an estimate that decides how the calculation goes on. */
    void countEstimate() {
        estimates++;
    }

    /** Number of estimates of the error that have decided how the calculation goes on. */
    int estimates() {
        return estimates;
    }

    /** Number of the round that made or renewed vertices which have not gathered yet; 0 where there are none. */
    int dark() {
        return dark;
    }

    /**
     * The answer that describes the light shown. Where vertices have gathered anew, their irradiance differs from the
     * flux that was shot by the noise of rays, which nobody will shoot; the unshot flux shown is that before.
     */
    Answer shown(Answer last) {
        return dark != 0 ? beforeDark : beforeRenewal != null ? last.withUnshotFlux(beforeRenewal) : last;
    }

    /**
     * The share of the irradiance that is shown, one per channel, in [0, 1]. It is below 1 where a calculation was
     * stopped after more flux was received than was shot, which the next round would take back; the calculation itself
     * goes on from all irradiance.
     */
    double[] shownShare(Answer last) {
        double[] share = new double[mesh.faces.channels()];
        double[] missing = mesh.predicts() && shots > 0 ? flux.missing(shown(last), false) : new double[share.length];
        for (int c = 0; c < share.length; c++) {
            share[c] = Math.max(0, Math.min(1, 1 + missing[c]));
        }
        return share;
    }

    /** The ledger of the light that is shown. */
    EnergyLedger ledger(Answer last) {
        return flux.ofAllLayers(shown(last), shownShare(last));
    }

    Progress progress(Answer last, double error) {
        return new Progress(shots, rounds, flux.unsent(shown(last)), last.elements, error, dark != 0);
    }

    void write(DataOutputStream out) throws IOException {
        out.writeInt(shots);
        out.writeInt(rounds);
        out.writeInt(estimates);
        out.writeInt(dark);
        if (dark != 0) {
            beforeDark.write(out);
        }
        out.writeBoolean(beforeRenewal != null);
        if (beforeRenewal != null) {
            beforeRenewal.write(out);
        }
        flux.write(out);
    }

    void read(DataInputStream in) throws IOException {
        shots = in.readInt();
        rounds = in.readInt();
        estimates = in.readInt();
        dark = in.readInt();
        if (dark != 0) {
            beforeDark = new Answer(mesh.faces, mesh.fluxScale());
            beforeDark.read(in);
        }
        if (in.readBoolean()) {
            beforeRenewal = new Answer(mesh.faces, mesh.fluxScale());
            beforeRenewal.read(in);
        }
        flux.read(in);
    }
}
