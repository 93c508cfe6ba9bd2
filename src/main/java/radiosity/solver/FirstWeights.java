package radiosity.solver;

import java.util.List;
import java.util.function.IntPredicate;
import radiosity.mesh.face.Faces;
import radiosity.protocol.Answer;
import radiosity.protocol.Shot;
import radiosity.setup.InitialMesh;

/** The weights of channels and closed rooms, chosen before the first shot; see {@link radiosity.mesh.Weights}. */
final class FirstWeights {

    /** Predicted flux on the faces that a predicate accepts, weighted by {@link Faces#importance}, W. */
    interface PredictedFlux {
        double of(IntPredicate counts, int channel);
    }

    private final InitialMesh mesh;
    private final int channels;
    /** Area of all faces, square scene units. */
    private final double area;

    FirstWeights(InitialMesh mesh, int channels) {
        this.mesh = mesh;
        this.channels = channels;
        area = mesh.faces.area() * mesh.faces.size() * mesh.faces.size();
    }

    /** Flux that surfaces would reflect, weighted by {@link Faces#importance}, if all saw each other equally, W. */
    double interreflected(IntPredicate counts, int c) {
        Faces faces = mesh.faces;
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

    /**
     * Sets the weights from present and predicted radiosity; the weight of a channel without light is 0.
     *
     * @param weight see {@link radiosity.mesh.Weights}
     * @param unshot patches with unshot flux
     */
    void set(double[] weight, Answer last, List<Shot> unshot, PredictedFlux predicted) {
        for (int c = 0; c < channels; c++) {
            double received = last.received[c].value();
            double reflected = Math.max(Faces.LEAST_IMPORTANCE * received, received - last.absorbed[c].value());
            double lit = predicted.of(f -> true, c) + reflected;
            weight[c] = lit > 0 ? area / lit : 0;
        }
        for (int room = weight.length / channels - 2; room >= -1 && weight.length > channels; room--) {
            int only = room;
            IntPredicate counts = f -> mesh.rooms.room(f) == only;
            double[] leaving = new double[channels];
            unshot.stream().flatMap(shot -> shot.trees().stream()).filter(tree -> counts.test(tree.face()))
                    .forEach(tree -> tree.addFlux(mesh.faces, leaving));
            for (int c = 0; c < channels; c++) {
                weight[channels * (room + 1) + c] = weightIn(counts, c, weight[c], leaving[c], predicted);
            }
        }
    }

    /**
     * Weight of a channel in one closed room, or on the faces outside of closed rooms; at least the weight in the whole
     * scene, and equal to that in a room without light.
     *
     * @param counts  whether a face is in the room
     * @param least   weight in the whole scene
     * @param leaving unshot flux of the room's faces, W/m² times squared scene size
     */
    private double weightIn(IntPredicate counts, int c, double least, double leaving, PredictedFlux predicted) {
        Faces faces = mesh.faces;
        double emitted = 0;
        double within = 0;
        for (int f = 0; f < faces.count(); f++) {
            within += counts.test(f) ? faces.area(f) : 0;
            emitted += counts.test(f) ? faces.exposedArea(f) * faces.exitance(f, c) : 0;
        }
        double unit = area / faces.area();
        double lit = predicted.of(counts, c) + unit * Math.max(0, leaving - emitted);
        return lit > 0 ? Math.max(least, unit * within / lit) : least;
    }
}
