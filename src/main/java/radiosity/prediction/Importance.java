package radiosity.prediction;

import java.util.Arrays;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.mesh.room.ClosedRooms;
import radiosity.protocol.Shot;
import radiosity.setup.InitialMesh;

/**
 * Importance of surfaces in the rows of a {@link CoarseSystem}: 1 plus the surface's exitance relative to the mean
 * exitance of its room. Rays sample important surfaces more finely.
 */
final class Importance {

    private final InitialMesh mesh;
    private final Faces faces;
    private final ClosedRooms rooms;
    /** Mean by area of the exitance in the largest channel, one per layer and room (see {@link Weights}), W/m². */
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

    /** A shot of the elements below some nodes with their importance as radiosity, in all channels. */
    Shot of(RadiosityNodes nodes, int[] tops) {
        return mesh.rounding.of(Shot.of(nodes, tops, 0, (element, values, at) ->
                Arrays.fill(values, at, at + 3 * nodes.channels(), 1 + brightness(nodes.face(element)))));
    }

    /** Index into {@link #mean} of a layer in the room of a face. */
    private int at(int face, int layer) {
        return Weights.at(rooms, face, layer, faces.layers(), mean.length);
    }

    /** Exitance of a face relative to the mean in its room, in the layer in which the quotient is largest. */
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
