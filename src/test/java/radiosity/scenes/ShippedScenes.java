package radiosity.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;

/** Reads the scenes of the folder {@code scenes}. */
final class ShippedScenes {

    private ShippedScenes() {
    }

    /** Reads a scene that must give no warning. */
    static Scene read(String name) throws IOException {
        List<String> warnings = new ArrayList<>();
        Scene scene = LightWaveReader.read(Path.of("scenes", name), ReadOptions.defaults(), warnings::add);
        assertEquals(List.of(), warnings);
        return scene;
    }

    /** The unit normal of a triangle, towards its visible side. */
    static Vec3 normal(Scene scene, int triangle) {
        Vec3 a = scene.corner(triangle, 0);
        return scene.corner(triangle, 1).minus(a).cross(scene.corner(triangle, 2).minus(a)).unit();
    }

    /** Area of all triangles of a surface, square scene units. */
    static double area(Scene scene, String surface) {
        double sum = 0;
        for (int t = 0; t < scene.triangles(); t++) {
            sum += scene.surface(t).name().equals(surface) ? scene.area(t) : 0;
        }
        return sum;
    }
}
