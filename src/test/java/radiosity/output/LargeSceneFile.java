package radiosity.output;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
import radiosity.world.Solution;

/** Writes the scene file of a room with many elements, to measure how fast it opens (docs/VIEWER.md). */
public final class LargeSceneFile {

    /** Of its textures, per scene unit. */
    private static final double SAMPLES = 40;

    private LargeSceneFile() { }

    /** @param arguments file, number of elements */
    public static void main(String[] arguments) throws IOException {
        write(Path.of(arguments[0]), Integer.parseInt(arguments[1]));
    }

    /** Six walls of a cube of size 10, seen from inside, brighter to the right, above and in front. */
    public static void write(Path file, int elements) throws IOException {
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
        Solution solution = room.solution(null);
        Camera camera = new Camera(new Vec3(5, 5, 9), new Vec3(0, 0, -1), new Vec3(0, 1, 0), 0.7, 4.0 / 3);
        SceneFile.write(file, solution, Map.of(), Optional.of(camera), ToneMapping.automatic(solution),
                OptionalDouble.of(SAMPLES));
    }
}
