package radiosity.solver;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import radiosity.mesh.face.Faces;
import radiosity.protocol.Answer;
import radiosity.protocol.Shot;
import radiosity.settings.StopRule;
import radiosity.setup.InitialMesh;
import radiosity.solution.EnergyLedger;
import radiosity.util.ExactSum;
import radiosity.util.ParallelFor;

/** Flux that was emitted and shot so far; together with the partitions' answers, the energy ledger. */
final class Flux {

    /** Rays that find escaping light, times the square of the relative error that is asked for. */
    private static final double RAYS = 100;
    /** The least number of these rays. */
    private static final double LEAST_RAYS = 100_000;
    /** Standard errors of the escaped flux below which lost flux may be that error. */
    private static final double CERTAIN = 2;

    private final Faces faces;
    /** Square scene units per unit of area of {@link Faces}. */
    private final double squared;
    /** One per channel: flux that shooters and lights without geometry have sent, W. */
    private final double[] shot;
    /** One per channel: flux of shots that receivers will gather in a later round, W. */
    private final double[] underWay;
    /** One per channel: flux of emitting surfaces, and flux that arrives from lights without geometry, W. */
    private final double[] emitted;
    /** One per channel: the part of it that comes from the sun and skies, W. A finer mesh may receive more or less. */
    private final double[] outside;
    /** Part of {@link #shot} that escapes, W, one per channel; then the variance of that estimate, W², one each. */
    private final double[] escaped;
    /** The same of {@link #underWay}. */
    private final double[] escapedUnderWay;
    /** Flux for which one ray stands that finds escaping light in the present round, W; 0 without such rays. */
    private double perRay;
    private final InitialMesh mesh;
    private final ParallelFor parallel;

    Flux(InitialMesh mesh, ParallelFor parallel) {
        this.mesh = mesh;
        this.parallel = parallel;
        faces = mesh.faces;
        squared = faces.size() * faces.size();
        shot = new double[faces.channels()];
        underWay = new double[faces.channels()];
        emitted = mesh.emitted.clone();
        outside = new double[faces.channels()];
        escaped = new double[2 * faces.channels()];
        escapedUnderWay = new double[2 * faces.channels()];
    }

    /**
     * Counts the flux of lights without geometry, before the first shot of a patch. All flux received by then came from
     * those lights; but where the received flux is bounded by the flux that is shot, the first mesh is too coarse to
     * integrate it, and points on all faces are used instead, for all lights but the sun and skies.
     *
     * @param first the partitions' first answer
     */
    void countLights(Answer first) {
        if (mesh.scene.lights().isEmpty()) {
            return;
        }
        double[] exact = mesh.predicts() ? mesh.lightFlux() : new double[shot.length];
        for (int c = 0; c < shot.length; c++) {
            double rest = Math.max(0, first.received[c].value() - exact[c]);
            outside[c] = mesh.isLitFromOutside() ? rest : 0;
            shot[c] = exact[c] + (mesh.predicts() ? outside[c] : rest);
            emitted[c] = mesh.emitted[c] + shot[c];
        }
    }

    /**
     * Begins a round of shots, whose escaping light is found by rays in proportion to their part of all flux. The
     * number of rays makes the error of the escaping light, multiplied by interreflection, a small part of the error
     * that is asked for; there are more where that is coarse, as a smaller error may be asked for later.
     */
    void begin(List<Shot> round) {
        double flux = round.stream().mapToDouble(patch -> DoubleStream.of(patch.flux(faces)).map(Math::abs).sum()).sum()
                * squared;
        double before = DoubleStream.of(shot).map(Math::abs).sum();
        double rays = Math.max(LEAST_RAYS, RAYS / (mesh.accuracy() * mesh.accuracy()));
        perRay = mesh.predicts() && !mesh.conserves() ? Math.max(flux, before) / rays : 0;
    }

    /** Counts shots of the present round, or some of them. */
    void count(List<Shot> some) {
        count(some, shot, escaped);
    }

    private void count(List<Shot> some, double[] shot, double[] escaped) {
        for (Shot patch : some) {
            double[] flux = patch.flux(faces);
            for (int c = 0; c < shot.length; c++) {
                shot[c] += flux[c] * squared;
            }
        }
        if (perRay > 0) {
            double[][] escaping = new double[some.size()][];
            parallel.run(some.size(), i -> escaping[i] = mesh.escapingFlux(some.get(i), perRay));
            for (double[] one : escaping) {
                for (int i = 0; i < escaped.length; i++) {
                    escaped[i] += one[i];
                }
            }
        }
    }

    /**
     * Takes over the flux that was shot in an earlier scene.
     *
     * @param earlier  counts of the earlier scene where the geometry is the same, so that as much escapes; else null:
     *                 rays find what escapes
     * @param surfaces flux that the elements have shot, one per channel, W
     * @param totals   the radiosities that the elements have shot
     * @param lights   flux of sources without geometry that arrives, one per channel, W
     */
    void change(Flux earlier, double[] surfaces, List<Shot> totals, double[] lights) {
        begin(totals);
        if (earlier == null) {
            count(totals);
        } else {
            System.arraycopy(earlier.escaped, 0, escaped, 0, escaped.length);
        }
        for (int c = 0; c < shot.length; c++) {
            shot[c] = surfaces[c] + lights[c];
            emitted[c] = mesh.emitted[c] + lights[c];
            outside[c] = mesh.isLitFromOutside() ? lights[c] : 0;
        }
    }

    /** Flux of sources without geometry that arrives, one per channel, W. */
    double[] lights() {
        double[] lights = new double[emitted.length];
        for (int c = 0; c < lights.length; c++) {
            lights[c] = emitted[c] - mesh.emitted[c];
        }
        return lights;
    }

    /** Counts shots of the present round that receivers will gather in a later round. */
    void mark(List<Shot> some) {
        count(some, underWay, escapedUnderWay);
    }

    /** Counts all marked shots as gathered. */
    void countMarked() {
        for (int c = 0; c < shot.length; c++) {
            shot[c] += underWay[c];
        }
        for (int i = 0; i < escaped.length; i++) {
            escaped[i] += escapedUnderWay[i];
        }
        Arrays.fill(underWay, 0);
        Arrays.fill(escapedUnderWay, 0);
    }

    /** Unshot flux over emitted flux that is nothing but rounding; the largest of all layers. */
    double rounding() {
        double most = 1;
        for (int layer = 0; layer < faces.layers(); layer++) {
            double all = ofLayer(emitted, layer);
            most = Math.max(most, all == 0 ? 0 : ofLayer(shot, layer) / all);
        }
        return StopRule.ROUNDING * most;
    }

    private double ofLayer(double[] flux, int layer) {
        int colours = faces.colours();
        return DoubleStream.of(flux).skip((long) layer * colours).limit(colours).sum();
    }

    /** Sum of |unshot flux| over emitted flux; the largest of all layers. */
    double unsent(Answer answer) {
        double most = 0;
        for (int layer = 0; layer < answer.unshotFlux.length; layer++) {
            double all = ofLayer(emitted, layer);
            most = Math.max(most, all == 0 ? 0 : answer.unshotFlux[layer].value() / all);
        }
        return most;
    }

    /**
     * |Sum of unshot flux| over emitted flux, where positive and negative unshot flux cancel: the relative bias of the
     * solution as a whole; the largest of all layers.
     */
    double oneSided(Answer answer) {
        double most = 0;
        for (int layer = 0; layer < answer.unshotFlux.length; layer++) {
            double left = 0;
            for (int c = layer * faces.colours(); c < (layer + 1) * faces.colours(); c++) {
                left += Math.abs(answer.unshot[c].value());
            }
            double all = ofLayer(emitted, layer);
            most = Math.max(most, all == 0 ? 0 : left / all);
        }
        return most;
    }

    /**
     * Flux that was lost, over received flux, one per channel: the share of its irradiance that every vertex is given
     * in addition, so that flux is conserved and no irradiance becomes negative. Lost is what was shot and neither
     * received nor escaped; it has either sign. Of the part that may be the error of the escaped flux little counts: a
     * white room multiplies any such error. What was received beyond all that was shot is taken back in any case. The
     * flux of the sun and skies is doubtful as a whole, as what a mesh receives of it depends on the mesh. At most as
     * much again is given as was received: what a mesh does not see at all is no share of what it sees.
     *
     * @param isShotLater whether what is given is still to be shot; otherwise nothing is given where light may escape
     */
    double[] missing(Answer answer, boolean isShotLater) {
        double[] missing = new double[shot.length];
        for (int c = 0; c < missing.length; c++) {
            double received = answer.received[c].value();
            double lost = shot[c] - escaped[c] - received;
            double doubtful = CERTAIN * CERTAIN * (escaped[shot.length + c] + outside[c] * outside[c]);
            double certain = doubtful == 0 ? lost : lost * Math.max(0, 1 - doubtful / (lost * lost));
            double bound = shot[c] + CERTAIN * outside[c];
            double most = mesh.conserves() || isShotLater ? received : 0;
            missing[c] = received > 0 ? Math.min(Math.min(certain, most), bound - received) / received : 0;
        }
        return missing;
    }

    /**
     * The ledger of the calculation, with one value per channel. What enters from the sun and skies is what rays find:
     * the first mesh is too coarse for the edges of sunlight on a floor.
     */
    EnergyLedger byChannel(Answer answer) {
        double[] gone = mesh.predicts() ? Arrays.copyOf(escaped, shot.length) : new double[0];
        double[] enters = emitted.clone();
        double[] sent = shot.clone();
        if (mesh.predicts() && mesh.isLitFromOutside()) {
            double[] all = mesh.allLightFlux();
            double[] counted = lights();
            for (int c = 0; c < sent.length; c++) {
                double more = all[c] - counted[c];
                enters[c] += more;
                sent[c] += more;
            }
        }
        return new EnergyLedger(enters, sent, values(answer.received), values(answer.absorbed), values(answer.unshot),
                gone);
    }

    /**
     * The ledger of the light that is shown, with one value per colour, the sum over layers.
     *
     * @param share one per channel: share of the received flux that is shown, in [0, 1]
     */
    EnergyLedger ofAllLayers(Answer answer, double[] share) {
        EnergyLedger all = byChannel(answer);
        for (int c = 0; c < share.length; c++) {
            all.unshot()[c] -= (1 - share[c]) * (all.received()[c] - all.absorbed()[c]);
            all.received()[c] *= share[c];
            all.absorbed()[c] *= share[c];
        }
        return new EnergyLedger(faces.perColour(all.emitted()), faces.perColour(all.shot()),
                faces.perColour(all.received()), faces.perColour(all.absorbed()), faces.perColour(all.unshot()),
                faces.perColour(all.escaped()));
    }

    private static double[] values(ExactSum[] sums) {
        return Stream.of(sums).mapToDouble(ExactSum::value).toArray();
    }

    static double sum(ExactSum[] sums) {
        double all = 0;
        for (ExactSum sum : sums) {
            all += sum.value();
        }
        return all;
    }

    void write(DataOutput out) throws IOException {
        for (int c = 0; c < shot.length; c++) {
            out.writeDouble(shot[c]);
            out.writeDouble(underWay[c]);
            out.writeDouble(emitted[c]);
            out.writeDouble(outside[c]);
        }
        for (int i = 0; i < escaped.length; i++) {
            out.writeDouble(escaped[i]);
            out.writeDouble(escapedUnderWay[i]);
        }
        out.writeDouble(perRay);
    }

    void read(DataInput in) throws IOException {
        for (int c = 0; c < shot.length; c++) {
            shot[c] = in.readDouble();
            underWay[c] = in.readDouble();
            emitted[c] = in.readDouble();
            outside[c] = in.readDouble();
        }
        for (int i = 0; i < escaped.length; i++) {
            escaped[i] = in.readDouble();
            escapedUnderWay[i] = in.readDouble();
        }
        perRay = in.readDouble();
    }
}
