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

/** Flux that was emitted and shot so far; with what partitions answer, where all of it went. */
final class Flux {

    private final Faces faces;
    /** Square scene units that 1 is in the faces. */
    private final double squared;
    /** One per channel: flux that left shooters, lights among them, W. */
    private final double[] shot;
    /** One per channel: flux of shooters that are marked, of which nothing has arrived yet, W. */
    private final double[] underWay;
    /** One per channel: flux of surfaces and lights, W. A light emits what arrives of it. */
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
     * Before the first shot of a patch, what was received came from lights. Where no more may be received than is shot,
     * the first mesh is not fine enough to say how much that is.
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
     * Takes over what was shot in an earlier scene.
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

    /** Counts what is marked as shot, but gathered later. */
    void mark(Shot patch) {
        double[] flux = patch.flux(faces);
        for (int c = 0; c < shot.length; c++) {
            underWay[c] += flux[c] * squared;
        }
    }

    /** What was marked has been gathered. */
    void countMarked() {
        for (int c = 0; c < shot.length; c++) {
            shot[c] += underWay[c];
            underWay[c] = 0;
        }
    }

    /**
     * Unshot flux, relative to the emitted, that is only rounding; of several layers, of the one that was shot most.
     */
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

    /** Unshot flux relative to the emitted; of several layers, of the one that has most left. */
    double unsent(Answer answer) {
        double most = 0;
        for (int layer = 0; layer < answer.unshotFlux.length; layer++) {
            double all = ofLayer(emitted, layer);
            most = Math.max(most, all == 0 ? 0 : answer.unshotFlux[layer].value() / all);
        }
        return most;
    }

    /**
     * Unshot flux relative to the emitted where that of one sign cancels that of the other: what all light together
     * will still become brighter or darker by; of several layers, of the one that has most left.
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
     * What was shot and not received, or received twice, relative to what was received, one per channel: where all must
     * be received, each vertex is given that share of its own light back, so that flux is conserved and no light
     * becomes negative. Where light may escape none is given back, but what was received beyond what was shot is
     * taken back: the share is below 0 then.
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

    /** One value per channel, layer by layer. */
    EnergyLedger byChannel(Answer answer) {
        return new EnergyLedger(emitted.clone(), shot.clone(), values(answer.received), values(answer.absorbed),
                values(answer.unshot));
    }

    /** One value per colour. */
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
