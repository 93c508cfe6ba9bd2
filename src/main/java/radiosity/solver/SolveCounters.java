package radiosity.solver;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.setup.InitialMesh;
import radiosity.solution.Progress;

/** What was done so far: shots and rounds, and where the light went by that. */
final class SolveCounters {

    private final InitialMesh mesh;
    private int shots;
    private int rounds;
    /** The round that has made vertices, or renewed all, that have not gathered yet; 0 where there is none. */
    private int dark;
    /** The answer before that round: until they have gathered, it is what the light that is shown comes to. */
    private Answer beforeDark;
    /** The answer before vertices gathered anew, as long as nobody has shot since; else null. */
    private Answer beforeRenewal;
    final Flux flux;

    SolveCounters(InitialMesh mesh) {
        this.mesh = mesh;
        flux = new Flux(mesh);
    }

    /** Before anything is done: the light that has no geometry. */
    void begin(Answer first) {
        if (rounds == 0) {
            flux.countLights(first);
        }
    }

    /**
     * Goes on counting after an earlier scene's calculation.
     *
     * @param surfaces flux that the elements have shot, one per channel, W
     * @param lights   flux of sources without geometry that arrives, one per channel, W
     */
    void change(SolveCounters earlier, double[] surfaces, double[] lights) {
        shots = earlier.shots;
        rounds = earlier.rounds;
        flux.change(surfaces, lights);
    }

    /** The number of a round that begins now. */
    int nextRound() {
        return ++rounds;
    }

    /**
     * An order, or a part of one, that is done or under way.
     *
     * @param before the last answer before it
     * @param after  the last answer by now
     */
    void count(Order done, Answer before, Answer after) {
        switch (done.kind()) {
            case SHOOT -> {
                shots += done.shots().size();
                done.shots().forEach(flux::count);
                beforeRenewal = null;
            }
            case RENEW -> done.shots().forEach(flux::mark);
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

    /** The round that has made vertices, or renewed all, that have not gathered yet; 0 where there is none. */
    int dark() {
        return dark;
    }

    /**
     * What the light that is shown comes to. What vertices have gathered anew differs from what was shot by the noise
     * of rays, which is nothing that is still to be sent: unsent is what had not been shot before.
     */
    Answer shown(Answer last) {
        return dark != 0 ? beforeDark : beforeRenewal != null ? last.withUnshotFlux(beforeRenewal) : last;
    }

    Progress progress(Answer last, double error) {
        return new Progress(shots, rounds, flux.unsent(shown(last)), last.elements, error, dark != 0);
    }

    void write(DataOutputStream out) throws IOException {
        out.writeInt(shots);
        out.writeInt(rounds);
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
