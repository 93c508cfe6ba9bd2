package radiosity.solver;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import radiosity.mesh.face.Faces;
import radiosity.protocol.Answer;
import radiosity.protocol.Shot;
import radiosity.settings.StopRule;
import radiosity.setup.InitialMesh;
import radiosity.solution.EnergyLedger;
import radiosity.util.ExactSum;

/** Flux that was emitted and shot so far; together with the partitions' answers, the energy ledger. */
final class Flux {

    private final Faces faces;
    /** Square scene units per unit of area of {@link Faces}. */
    private final double squared;
    /** One per channel: flux that shooters and lights without geometry have sent, W. */
    private final double[] shot;
    /** One per channel: flux of shots that receivers will gather in a later round, W. */
    private final double[] underWay;
    /** One per channel: flux of emitting surfaces, and flux that arrives from lights without geometry, W. */
    private final double[] emitted;
    private final InitialMesh mesh;

    Flux(InitialMesh mesh) {
        this.mesh = mesh;
        faces = mesh.faces;
        squared = faces.size() * faces.size();
        shot = new double[faces.channels()];
        underWay = new double[faces.channels()];
        emitted = mesh.emitted.clone();
    }

    /**
     * Counts the flux of lights without geometry, before the first shot of a patch. All flux received by then came from
     * those lights; but where the received flux is bounded by the flux that is shot, the first mesh is too coarse to
     * integrate it, and points on all faces are used instead.
     *
     * @param first the partitions' first answer
     */
    void countLights(Answer first) {
        if (mesh.scene.lights().isEmpty()) {
            return;
        }
        double[] exact = mesh.boundsReceived() ? mesh.lightFlux() : new double[0];
        for (int c = 0; c < shot.length; c++) {
            shot[c] = exact.length > 0 ? exact[c] : first.received[c].value();
            emitted[c] = mesh.emitted[c] + shot[c];
        }
    }

    void count(Shot patch) {
        double[] flux = patch.flux(faces);
        for (int c = 0; c < shot.length; c++) {
            shot[c] += flux[c] * squared;
        }
    }

    /**
     * Takes over the flux that was shot in an earlier scene.
     *
     * @param surfaces flux that the elements have shot, one per channel, W
     * @param lights   flux of sources without geometry that arrives, one per channel, W
     */
    void change(double[] surfaces, double[] lights) {
        for (int c = 0; c < shot.length; c++) {
            shot[c] = surfaces[c] + lights[c];
            emitted[c] = mesh.emitted[c] + lights[c];
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

    /** Counts a shot that receivers will gather in a later round. */
    void mark(Shot patch) {
        double[] flux = patch.flux(faces);
        for (int c = 0; c < shot.length; c++) {
            underWay[c] += flux[c] * squared;
        }
    }

    /** Counts all marked shots as gathered. */
    void countMarked() {
        for (int c = 0; c < shot.length; c++) {
            shot[c] += underWay[c];
            underWay[c] = 0;
        }
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
     * Flux that was shot and not received, over received flux, one per channel: the share of its irradiance that every
     * vertex is given in addition, so that flux is conserved and no irradiance becomes negative. In a closed room the
     * share has either sign. Where light may escape the share is at most 0: flux received beyond the flux that was shot
     * is taken back, and nothing is added.
     */
    double[] missing(Answer answer) {
        double[] missing = new double[shot.length];
        for (int c = 0; c < missing.length; c++) {
            double received = answer.received[c].value();
            missing[c] = received > 0 ? (shot[c] - received) / received : 0;
            if (!mesh.conserves()) {
                missing[c] = Math.min(0, missing[c]);
            }
        }
        return missing;
    }

    /** The ledger with one value per channel. */
    EnergyLedger byChannel(Answer answer) {
        return new EnergyLedger(emitted.clone(), shot.clone(), values(answer.received), values(answer.absorbed),
                values(answer.unshot));
    }

    /** The ledger with one value per colour, the sum over layers. */
    EnergyLedger ofAllLayers(Answer answer) {
        EnergyLedger all = byChannel(answer);
        return new EnergyLedger(ofAllLayers(all.emitted()), ofAllLayers(all.shot()), ofAllLayers(all.received()),
                ofAllLayers(all.absorbed()), ofAllLayers(all.unshot()));
    }

    private double[] ofAllLayers(double[] flux) {
        double[] sum = new double[faces.colours()];
        for (int c = 0; c < flux.length; c++) {
            sum[c % sum.length] += flux[c];
        }
        return sum;
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
        }
    }

    void read(DataInput in) throws IOException {
        for (int c = 0; c < shot.length; c++) {
            shot[c] = in.readDouble();
            underWay[c] = in.readDouble();
            emitted[c] = in.readDouble();
        }
    }
}
