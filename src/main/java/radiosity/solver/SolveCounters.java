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
    /** The round whose new or discarded vertices have not gathered yet; 0 where there is none. */
    private int dark;
    /** The answer before they were made: until they have gathered, it is what the light that is shown comes to. */
    private Answer beforeDark;
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
        if (done.kind() == Order.Kind.SHOOT) {
            shots += done.shots().size();
            done.shots().forEach(flux::count);
        }
        if (done.kind() == Order.Kind.SPLIT && after.elements > before.elements || done.kind() == Order.Kind.DISCARD) {
            dark = done.number();
            beforeDark = before;
        } else if (done.kind() != Order.Kind.ROWS && !done.more()) {
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

    /** The round whose new or discarded vertices have not gathered yet; 0 where there is none. */
    int dark() {
        return dark;
    }

    /** What the light that is shown comes to. */
    Answer shown(Answer last) {
        return dark == 0 ? last : beforeDark;
    }

    Progress progress(Answer last) {
        return new Progress(shots, rounds, flux.unsent(shown(last)), last.elements, dark != 0);
    }

    void write(DataOutputStream out) throws IOException {
        out.writeInt(shots);
        out.writeInt(rounds);
        out.writeInt(dark);
        if (dark != 0) {
            beforeDark.write(out);
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
        flux.read(in);
    }
}
