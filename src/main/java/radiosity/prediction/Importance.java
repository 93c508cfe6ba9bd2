package radiosity.prediction;

import java.util.Arrays;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.mesh.room.ClosedRooms;
import radiosity.protocol.Shot;
import radiosity.setup.InitialMesh;

/** What surfaces matter for light to come: 1, and more for what emits. */
final class Importance {

    private final InitialMesh mesh;
    private final Faces faces;
    private final ClosedRooms rooms;
    /** Mean of the brightest channel, one per layer and room, W/m². */
    private final double[] mean;

    Importance(InitialMesh mesh) {
        this.mesh = mesh;
        faces = mesh.faces;
        rooms = mesh.rooms;
        mean = new double[Weights.count(rooms, faces.layers())];
        double[] area = new double[mean.length];
        for (int f = 0; f < faces.count(); f++) {
            for (int layer = 0; layer < faces.layers(); layer++) {
                mean[at(f, layer)] += faces.area(f) * brightest(f, layer);
                area[at(f, layer)] += faces.area(f);
            }
        }
        Arrays.setAll(mean, i -> mean[i] == 0 ? 0 : mean[i] / area[i]);
    }

    /** What some nodes matter, as a shot. */
    Shot of(RadiosityNodes nodes, int[] tops) {
        return mesh.rounding.of(Shot.of(nodes, tops, 0, (element, values, at) ->
                Arrays.fill(values, at, at + 3 * nodes.channels(), 1 + brightness(nodes.face(element)))));
    }

    /** Where a face's room has its values of a layer. */
    private int at(int face, int layer) {
        return Weights.at(rooms, face, layer, faces.layers(), mean.length);
    }

    /** Of the layer in which a face is brightest, relative to the layer's mean in its room. */
    private double brightness(int face) {
        double most = 0;
        for (int layer = 0; layer < faces.layers(); layer++) {
            double all = mean[at(face, layer)];
            most = Math.max(most, all == 0 ? 0 : brightest(face, layer) / all);
        }
        return most;
    }

    private double brightest(int face, int layer) {
        double e = 0;
        for (int c = layer * faces.colours(); c < (layer + 1) * faces.colours(); c++) {
            e = Math.max(e, faces.exitance(face, c));
        }
        return e;
    }
}
