package radiosity.testkit;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Assumptions;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/** Reference data beside the repository; a test that uses it is skipped, with a message, where it is absent. */
public final class SharedData {

    private static final Path TRUTH = Path.of("..", "shared", "truth");

    private SharedData() { }

    /** A file or folder of the reference data. */
    public static Path truth(String first, String... more) {
        Path path = TRUTH.resolve(Path.of(first, more));
        Assumptions.assumeTrue(Files.exists(path), () -> "no reference data: " + path + " is not there");
        return path;
    }

    /** The cases of a file of references. */
    public static List<JsonNode> cases(String file) {
        List<JsonNode> cases = new ArrayList<>();
        json(truth(file)).get("cases").forEach(cases::add);
        return cases;
    }

    /** The case of that id. */
    public static JsonNode find(String file, String id) {
        return cases(file).stream().filter(c -> c.get("id").asText().equals(id)).findFirst().orElseThrow();
    }

    public static JsonNode json(Path file) {
        try {
            return new ObjectMapper().readTree(file.toFile());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A scene from its list of {@code surfaces}; polygons are convex. */
    public static Scene scene(String name, JsonNode surfaces) {
        SceneBuilder builder = new SceneBuilder();
        for (JsonNode s : surfaces) {
            builder.polygon(new Surface(s.get("name").asText(), rgb(s.get("emission")), rgb(s.get("reflectance")),
                    false),
                    polygon(s.get("vertices")));
        }
        return builder.scene(name);
    }

    public static Rgb rgb(JsonNode v) {
        return new Rgb(v.get(0).asDouble(), v.get(1).asDouble(), v.get(2).asDouble());
    }

    public static Vec3 vector(JsonNode v) {
        return new Vec3(v.get(0).asDouble(), v.get(1).asDouble(), v.get(2).asDouble());
    }

    public static Vec3[] polygon(JsonNode vertices) {
        Vec3[] polygon = new Vec3[vertices.size()];
        for (int i = 0; i < polygon.length; i++) {
            polygon[i] = vector(vertices.get(i));
        }
        return polygon;
    }
}
