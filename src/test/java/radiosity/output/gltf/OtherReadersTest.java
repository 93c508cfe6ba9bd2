package radiosity.output.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import de.javagl.jgltf.model.AccessorFloatData;
import de.javagl.jgltf.model.AccessorModel;
import de.javagl.jgltf.model.GltfModel;
import de.javagl.jgltf.model.MeshPrimitiveModel;
import de.javagl.jgltf.model.io.GltfModelReader;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.output.image.ToneMapping;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;
import radiosity.solution.Solution;
import radiosity.testkit.EvenLight;

/** What others make of our scene files. */
@Tag("slow")
class OtherReadersTest {

    private static final Vec3 FAR = new Vec3(5000, -200, 31);
    private static final Camera CAMERA = new Camera(FAR.plus(new Vec3(1, 1, 6)), new Vec3(0, 0, -1),
            new Vec3(0, 1, 0), .3, 1.25);

    @TempDir
    Path folder;
    private Path file;
    private List<Mesh> meshes;
    private Vec3 origin;

    @BeforeEach
    void write() throws IOException {
        file = folder.resolve("room.scene");
        Handmade room = Handmade.room(FAR, 2, p -> new Rgb(p.x() - 4999, p.y() + 201, 31 / p.z()));
        int sheet = room.surface("sheet \u00e9\n\u0001", Rgb.BLACK, new Rgb(.25, .5, .75), true);
        room.grid(sheet, FAR.plus(new Vec3(.5, .5, .5)), new Vec3(1, 0, 0), new Vec3(0, 1, 0), 2, 2, p -> Rgb.grey(3));
        room.state = new byte[12345];
        write(room.solution());
        try (SceneFile scene = SceneFile.open(file)) {
            meshes = scene.meshes();
            origin = scene.origin();
        }
    }

    private void write(Solution solution) throws IOException {
        SceneFile.write(file, solution, Map.of("commandLine", "RadiosityRenderer \"a b.lws\" room.scene"),
                Optional.of(CAMERA), ToneMapping.automatic(solution));
    }

    private JsonNode validated() throws IOException, InterruptedException {
        return Node.run("validate.mjs", "gltf-validator@2.0.0-dev.3.10", file).get("issues");
    }

    @Test
    void khronosValidator_findsNothingWrong() throws IOException, InterruptedException {
        JsonNode issues = validated();
        assertEquals(0, issues.get("numErrors").asInt(), issues.toString());
        assertEquals(0, issues.get("numWarnings").asInt(), issues.toString());
    }

    @Test
    void khronosValidator_findsNothingWrong_whereThereIsNothing() throws IOException, InterruptedException {
        write(new Handmade().solution());
        JsonNode issues = validated();
        assertEquals(0, issues.get("numErrors").asInt(), issues.toString());
    }

    @Test
    void khronosValidator_findsNothingWrong_whereObjectsAreWithinObjects() throws IOException, InterruptedException {
        write(EvenLight.on(LightWaveReader.read(Path.of("scenes/study.lws"), ReadOptions.defaults(), warning -> { })));
        JsonNode issues = validated();
        assertEquals(0, issues.get("numErrors").asInt(), issues.toString());
        assertEquals(0, issues.get("numWarnings").asInt(), issues.toString());
    }

    @Test
    void jgltf_readsTheSameLight() throws IOException {
        GltfModel model = new GltfModelReader().read(file.toUri());
        assertEquals(meshes.size(), model.getMeshModels().size());
        for (int i = 0; i < meshes.size(); i++) {
            MeshPrimitiveModel primitive = model.getMeshModels().get(i).getMeshPrimitiveModels().get(0);
            assertEquals(meshes.get(i).corners().length, primitive.getIndices().getCount());
            assertSame(meshes.get(i).positions(), primitive.getAttributes().get("POSITION"));
            assertSame(meshes.get(i).normals(), primitive.getAttributes().get("NORMAL"));
            assertSame(meshes.get(i).radiosity(), primitive.getAttributes().get("_RADIOSITY"));
            assertSame(meshes.get(i).irradiance(), primitive.getAttributes().get("_IRRADIANCE"));
        }
    }

    private static void assertSame(float[] expected, AccessorModel got) {
        AccessorFloatData data = (AccessorFloatData) got.getAccessorData();
        assertEquals(expected.length, data.getTotalNumComponents());
        for (int i = 0; i < expected.length; i++) {
            assertEquals(expected[i], data.get(i / 3, i % 3));
        }
    }

    @Test
    void threeJs_seesTheSameScene() throws IOException, InterruptedException {
        JsonNode seen = Node.run("three.mjs", "three@0.180.0", file);
        assertEquals(meshes.size(), seen.get("meshes").size());
        for (int i = 0; i < meshes.size(); i++) {
            assertSees(meshes.get(i), seen.get("meshes").get(i));
        }
        assertEquals("RadiosityRenderer \"a b.lws\" room.scene", seen.get("extras").get("commandLine").asText());
        JsonNode camera = seen.get("camera");
        assertEquals(CAMERA.position().x(), camera.get("at").get(0).asDouble(), 1e-9);
        assertEquals(-1, camera.get("towards").get(2).asDouble(), 1e-12);
        assertEquals(Math.toDegrees(.6), camera.get("fov").asDouble(), 1e-9);
        assertEquals(1.25, camera.get("aspect").asDouble(), 1e-12);
    }

    private void assertSees(Mesh mesh, JsonNode seen) {
        assertTrue(seen.get("unlit").asBoolean() && seen.get("vertexColours").asBoolean());
        assertEquals(0, seen.get("side").asInt(), "front side only");
        assertEquals(mesh.elements(), seen.get("elements").asInt());
        assertEquals(mesh.vertices(), seen.get("vertices").asInt());
        assertEquals(mesh.vertices(), seen.get("colour").get(3).asDouble(), 1e-9);
        double[] o = {origin.x(), origin.y(), origin.z()};
        for (int c = 0; c < 3; c++) {
            assertEquals(mesh.surface().reflectance().channel(c), seen.get("reflectance").get(c).asDouble());
            assertEquals(sum(mesh.positions(), c) + mesh.vertices() * o[c], seen.get("position").get(c).asDouble(),
                    1e-6);
            assertEquals(sum(mesh.radiosity(), c), seen.get("radiosity").get(c).asDouble(), 1e-9);
            assertEquals(sum(mesh.irradiance(), c), seen.get("irradiance").get(c).asDouble(), 1e-9);
            double colour = seen.get("colour").get(c).asDouble();
            assertTrue(colour > 0 && colour <= mesh.vertices(), mesh.surface().name() + " " + colour);
        }
    }

    private static double sum(float[] values, int component) {
        double sum = 0;
        for (int i = component; i < values.length; i += 3) {
            sum += values[i];
        }
        return sum;
    }
}
