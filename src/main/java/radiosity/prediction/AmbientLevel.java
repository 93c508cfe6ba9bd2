package radiosity.prediction;

import java.util.Arrays;
import java.util.List;
import radiosity.mesh.PatchTree;
import radiosity.protocol.Shot;
import radiosity.setup.InitialMesh;

/**
 * Chooses the uniform radiosity of each closed room, see {@link radiosity.mesh.UniformRadiosity}: surfaces shoot by
 * rays only their difference from this level.
 *
 * <p>Every level gives the right light, provided that all surfaces of the room shoot. With the mean radiosity as level,
 * rays carry least; with the least radiosity, all differences have one sign, which few rays sample best. The level is
 * halfway between the two, and the mean where unshot light has both signs. Emitting surfaces do not count where a room
 * has others.
 */
public final class AmbientLevel {

    private final InitialMesh mesh;
    private final int channels;
    /** channels per room for surfaces that do not emit, then for those that do: flux, area, least mean of a tree. */
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

    /** @return channels per closed room, W/m²; empty without closed rooms, or where not all of the scene shoots */
    public static double[] of(InitialMesh mesh, List<Shot> shots) {
        return of(mesh, shots, false);
    }

    /**
     * The least radiosity at any corner of a room's elements, at least 0, in the shape of {@link #of}. No surface is
     * darker than this level, so no vertex receives less than the level, however rays sample the difference.
     */
    public static double[] lowest(InitialMesh mesh, List<Shot> shots) {
        return of(mesh, shots, true);
    }

    private static double[] of(InitialMesh mesh, List<Shot> shots, boolean isLowest) {
        if (mesh.rooms.count() == 0) {
            return new double[0];
        }
        double shooting = shots.stream().flatMap(shot -> shot.trees().stream())
                .mapToDouble(tree -> mesh.faces.area(tree.face(), tree.path())).sum();
        if (shooting < mesh.faces.area() * (1 - 1e-6)) {
            return new double[0];
        }
        AmbientLevel light = new AmbientLevel(mesh);
        shots.forEach(shot -> shot.trees().forEach(light::add));
        double[] level = new double[light.flux.length / 2];
        Arrays.setAll(level, i -> isLowest ? Math.max(0, light.least[i])
                : light.level(light.area[i] > 0 ? i : level.length + i));
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
        double its = mesh.faces.area(tree.face(), tree.path());
        for (int c = 0; c < channels; c++) {
            int i = channels * room + c + (mesh.faces.exitance(tree.face(), c) > 0 ? flux.length / 2 : 0);
            flux[i] += sum[c];
            area[i] += its;
            lowest[i] = Math.min(lowest[i], sum[c] / its);
            least[channels * room + c] = Math.min(least[channels * room + c], tree.least(c));
        }
    }
}
