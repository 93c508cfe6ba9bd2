package radiosity.prediction;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleBiFunction;
import radiosity.mesh.PatchTree;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.protocol.Shot;
import radiosity.setup.InitialMesh;

/**
 * The radiosity that all surfaces of a closed room have in common, see {@link radiosity.mesh.UniformRadiosity}.
 *
 * <p>Any level is right, as long as all of the room shoots. The mean leaves least to rays, the least leaves differences
 * of one sign, of which few rays tell most: it is halfway between them, and the mean where unshot light has both signs.
 * Lamps are left out where there are other surfaces.
 */
public final class AmbientLevel {

    private final InitialMesh mesh;
    private final int channels;
    /** channels per room: flux, area and lowest mean of what does not emit, then of what does. */
    private final double[] flux;
    private final double[] area;
    private final double[] lowest;
    /** channels per room: least radiosity at any corner, W/m². */
    private final double[] least;

    private AmbientLevel(InitialMesh mesh) {
        this.mesh = mesh;
        channels = mesh.faces.channels();
        flux = new double[2 * channels * mesh.rooms.count()];
        area = new double[flux.length];
        lowest = new double[flux.length];
        Arrays.fill(lowest, Double.POSITIVE_INFINITY);
        least = new double[channels * mesh.rooms.count()];
        Arrays.fill(least, Double.POSITIVE_INFINITY);
    }

    /** @return channels per closed room, W/m²; empty where there is none, or not all of the scene shoots */
    public static double[] of(InitialMesh mesh, List<Shot> shots) {
        return of(mesh, shots, AmbientLevel::level);
    }

    /**
     * The largest level of which nothing in a room shoots less at any corner: what differs from it is not negative
     * anywhere, and so nothing receives less than the level, however it is sampled.
     */
    public static double[] lowest(InitialMesh mesh, List<Shot> shots) {
        return of(mesh, shots, (light, i) -> Math.max(0, light.least[i % light.least.length]));
    }

    private static double[] of(InitialMesh mesh, List<Shot> shots, ToDoubleBiFunction<AmbientLevel, Integer> levels) {
        if (mesh.rooms.count() == 0) {
            return new double[0];
        }
        double shooting = shots.stream().flatMap(shot -> shot.trees().stream())
                .mapToDouble(tree -> area(mesh.faces, tree)).sum();
        if (shooting < mesh.faces.area() * (1 - 1e-6)) {
            return new double[0];
        }
        AmbientLevel light = new AmbientLevel(mesh);
        shots.forEach(shot -> shot.trees().forEach(light::add));
        double[] level = new double[light.flux.length / 2];
        Arrays.setAll(level, i -> levels.applyAsDouble(light, light.area[i] > 0 ? i : level.length + i));
        return level;
    }

    private double level(int i) {
        double mean = flux[i] / area[i];
        return lowest[i] > 0 ? (lowest[i] + mean) / 2 : mean;
    }

    private void add(PatchTree tree) {
        int room = mesh.rooms.room(tree.face());
        if (room < 0) {
            return;
        }
        double[] sum = new double[channels];
        tree.addFlux(mesh.faces, sum);
        double its = area(mesh.faces, tree);
        for (int c = 0; c < channels; c++) {
            int i = channels * room + c + (mesh.faces.exitance(tree.face(), c) > 0 ? flux.length / 2 : 0);
            flux[i] += sum[c];
            area[i] += its;
            lowest[i] = Math.min(lowest[i], sum[c] / its);
            least[channels * room + c] = Math.min(least[channels * room + c], tree.least(c));
        }
    }

    private static double area(Faces faces, PatchTree tree) {
        return faces.area(tree.face()) / (1L << 2 * NodePath.level(tree.path()));
    }
}
