package radiosity.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import radiosity.output.gltf.Handmade;
import radiosity.output.gltf.SceneFile;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Camera;
import radiosity.scene.Lamp;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;

/** Writes the scene file of a room with many elements, to measure how fast it opens (docs/VIEWER.md). */
public final class LargeSceneFile {

    /** Of its textures, per scene unit. */
    private static final double SAMPLES = 40;

    private LargeSceneFile() { }

    /** @param arguments file, number of elements, and of lamps that are kept apart, if any */
    public static void main(String[] arguments) throws IOException {
        int lamps = arguments.length > 2 ? Integer.parseInt(arguments[2]) : 0;
        write(Path.of(arguments[0]), Integer.parseInt(arguments[1]), lamps);
    }

    /** Six walls of a cube of size 10, seen from inside, brighter to the right, above and in front. */
    private static void write(Path file, int elements, int lamps) throws IOException {
        int n = (int) Math.ceil(Math.sqrt(elements / 12.0));
        Vec3 x = new Vec3(10, 0, 0);
        Vec3 y = new Vec3(0, 10, 0);
        Vec3 z = new Vec3(0, 0, 10);
        Vec3[][] walls = {{Vec3.ZERO, z, x}, {y, x, z}, {Vec3.ZERO, y, z}, {x, z, y}, {Vec3.ZERO, x, y}, {z, y, x}};
        Handmade room = new Handmade();
        for (int w = 0; w < walls.length; w++) {
            room.grid(room.surface("wall " + w, 0.5), walls[w][0], walls[w][1], walls[w][2], n, n,
                    p -> new Rgb(p.x() + 1, p.y() + 1, p.z() + 1));
        }
        Solution solution = layered(room.solution(null), lamps);
        Camera camera = new Camera(new Vec3(5, 5, 9), new Vec3(0, 0, -1), new Vec3(0, 1, 0), 0.7, 4.0 / 3);
        SceneFile.write(file, solution, Map.of(), Optional.of(camera), ToneMapping.automatic(solution),
                OptionalDouble.of(SAMPLES));
    }

    /** Every lamp has the same share. */
    private static Solution layered(Solution one, int lamps) {
        if (lamps == 0) {
            return one;
        }
        double[] irradiance = new double[3 * lamps * one.vertices()];
        for (int i = 0; i < irradiance.length; i++) {
            irradiance[i] = one.irradiance()[i / (3 * lamps) * 3 + i % 3] / lamps;
        }
        List<Lamp> names = IntStream.range(0, lamps).mapToObj(i -> new Lamp("lamp " + i, false, i)).toList();
        return new Solution(one.scene(), 3 * lamps, names, one.positions(), irradiance, one.corners(), one.faceOf(), 0,
                0,
                0, one.ledger(), SavedState.NONE);
    }
}
