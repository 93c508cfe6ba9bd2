package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;

/** What was written to LightWave files comes back as it was before: right-handed, the same side visible. */
class TruthGeometryTest {

    @ParameterizedTest
    @ValueSource(strings = {"cornell_blocks", "cornell_empty", "two_room", "touching"})
    void triangles_coverThePolygonsAndFaceTheSameWay(String name) throws IOException {
        JsonNode surfaces = new ObjectMapper().readTree(Shared.path("truth/scenes/" + name + ".json").toFile())
                .get("surfaces");
        Scene scene = LightWaveReader.read(Shared.path("truth/lightwave/" + name + ".lws"),
                ReadOptions.defaults(), w -> { });
        int triangle = 0;
        for (JsonNode surface : surfaces) {
            int corners = surface.get("vertices").size();
            Vec3 expected = Vec3.ZERO;
            Vec3 read = Vec3.ZERO;
            for (int i = 2; i < corners; i++, triangle++) {
                expected = expected.plus(normal(vertex(surface, 0), vertex(surface, i - 1), vertex(surface, i)));
                read = read.plus(normal(scene.corner(triangle, 0), scene.corner(triangle, 1),
                        scene.corner(triangle, 2)));
            }
            assertTrue(expected.minus(read).length() < 1e-5 * expected.length(), name + " " + surface.get("name"));
            assertReflectance(surface.get("reflectance"), scene, triangle - 1);
            assertEmission(surface.get("emission"), scene, triangle - 1);
        }
        assertEquals(triangle, scene.triangles());
    }

    private static void assertReflectance(JsonNode expected, Scene scene, int triangle) {
        for (int c = 0; c < 3; c++) {
            assertEquals(expected.get(c).asDouble(), scene.surface(triangle).reflectance().channel(c), 1e-5);
        }
    }

    private static void assertEmission(JsonNode expected, Scene scene, int triangle) {
        for (int c = 0; c < 3; c++) {
            double value = expected.get(c).asDouble();
            assertEquals(value, scene.surface(triangle).exitance().channel(c), 1e-5 * (1 + value));
        }
    }

    private static Vec3 vertex(JsonNode surface, int i) {
        JsonNode v = surface.get("vertices").get(i);
        return new Vec3(v.get(0).asDouble(), v.get(1).asDouble(), v.get(2).asDouble());
    }

    private static Vec3 normal(Vec3 a, Vec3 b, Vec3 c) {
        return b.minus(a).cross(c.minus(a));
    }
}
