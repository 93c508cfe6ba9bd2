package radiosity.output.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import de.javagl.jgltf.model.AccessorFloatData;
import de.javagl.jgltf.model.AccessorModel;
import de.javagl.jgltf.model.GltfModel;
import de.javagl.jgltf.model.MeshPrimitiveModel;
import de.javagl.jgltf.model.NodeModel;
import de.javagl.jgltf.model.io.GltfModelReader;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.input.SceneReader;
import radiosity.scene.SceneFormatException;
import radiosity.settings.ReadOptions;
import radiosity.output.lightmap.Lightmap;
import radiosity.output.model.LightmapModel;
import radiosity.output.model.SceneModel;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.testkit.EvenLight;
import radiosity.testkit.RoomScenes;

/** A model gets a lightmap and stays what it was. */
class LightmapModelTest {

    private static final Path ROOM = Path.of("src/test/resources/radiosity/input/room.glb");

    @TempDir
    Path folder;

    private Path lit(Path model) throws IOException {
        ReadOptions options = ReadOptions.defaults();
        Scene scene = SceneReader.read(model, options, warning -> { });
        Path file = folder.resolve("lit.glb");
        radiosity.gltf.GltfModel original = SceneReader.original(model, options, scene).isPresent()
                ? SceneReader.original(model, options, scene).get() : SceneModel.of(scene);
        LightmapModel.write(file, original, Lightmap.of(EvenLight.on(scene), OptionalDouble.empty()), 1);
        return file;
    }

    private static JsonNode json(Path glb) throws IOException {
        ByteBuffer file = ByteBuffer.wrap(Files.readAllBytes(glb)).order(ByteOrder.LITTLE_ENDIAN);
        return new ObjectMapper().readTree(file.array(), 20, file.getInt(12));
    }

    /** Positions, normals and the first texture coordinates of all triangles of all nodes, in their order. */
    private static List<String> triangles(Path file) throws IOException {
        GltfModel model = new GltfModelReader().read(file.toUri());
        List<String> triangles = new ArrayList<>();
        for (NodeModel node : model.getNodeModels()) {
            node.getMeshModels().forEach(mesh -> mesh.getMeshPrimitiveModels()
                    .forEach(primitive -> add(node.getName(), primitive, triangles)));
        }
        return triangles;
    }

    private static void add(String name, MeshPrimitiveModel primitive, List<String> triangles) {
        int[] corners = indices(primitive);
        for (String attribute : List.of("POSITION", "NORMAL", "TEXCOORD_0")) {
            AccessorModel accessor = primitive.getAttributes().get(attribute);
            boolean isOriginal = accessor != null && accessor != primitive.getAttributes().get("TEXCOORD_1");
            for (int i = 0; isOriginal && i < corners.length; i++) {
                AccessorFloatData data = (AccessorFloatData) accessor.getAccessorData();
                StringBuilder text = new StringBuilder(name + " " + attribute);
                for (int c = 0; c < data.getNumComponentsPerElement(); c++) {
                    text.append(' ').append(data.get(corners[i], c));
                }
                triangles.add(text.toString());
            }
        }
    }

    private static int[] indices(MeshPrimitiveModel primitive) {
        AccessorModel indices = primitive.getIndices();
        int[] corners = new int[indices.getCount()];
        ByteBuffer bytes = indices.getAccessorData().createByteBuffer().order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < corners.length; i++) {
            corners[i] = switch (indices.getComponentType()) {
                case 5121 -> bytes.get(i) & 0xFF;
                case 5123 -> bytes.getShort(2 * i) & 0xFFFF;
                default -> bytes.getInt(4 * i);
            };
        }
        return corners;
    }

    @Test
    void nodesMaterialsAndTriangles_areTheInputs() throws IOException {
        Path lit = lit(ROOM);
        List<String> before = triangles(ROOM);
        assertTrue(before.size() > 100, before.size() + " corners");
        assertEquals(before, triangles(lit));
        JsonNode original = json(ROOM);
        JsonNode got = json(lit);
        assertEquals(withoutMeshes(original), withoutMeshes(got));
        assertEquals(original.get("cameras"), got.get("cameras"));
        for (int m = 0; m < original.get("materials").size(); m++) {
            ObjectNode material = (ObjectNode) got.get("materials").get(m);
            ObjectNode extras = (ObjectNode) material.get("extras");
            assertEquals(1, extras.get("lightmap").get("texCoord").asInt());
            assertEquals("lit-lightmap.exr", extras.get("lightmap").get("file").asText());
            extras.remove("lightmap");
            if (extras.isEmpty()) {
                material.remove("extras");
            }
            assertEquals(original.get("materials").get(m), material);
        }
    }

    private static List<JsonNode> withoutMeshes(JsonNode file) {
        List<JsonNode> nodes = new ArrayList<>();
        file.get("nodes").forEach(node -> nodes.add(((ObjectNode) node.deepCopy()).without("mesh")));
        return nodes;
    }

    /** In lm/m² in the scene, in cd/m² in the model, which is read again. */
    @Test
    void emissionOfPhotometricScenes_isLuminance() throws IOException {
        Scene lamp = new SceneBuilder().polygon(RoomScenes.grey("lamp", 31, .5), Vec3.ZERO, new Vec3(0, 0, 1),
                new Vec3(1, 0, 1), new Vec3(1, 0, 0)).scene("lamp").with(new Units(1, true));
        Path file = folder.resolve("lamp.glb");
        LightmapModel.write(file, SceneModel.of(lamp), Lightmap.of(EvenLight.on(lamp), OptionalDouble.empty()), 1);
        assertEquals(Math.PI, json(file).at("/materials/0/extras/lightmap/emissionScale").asDouble(), 1e-12);
        Scene again = SceneReader.read(file, ReadOptions.defaults().withUnits(new Units(1, true)), warning -> { });
        assertEquals(31, again.surfaces().get(0).exitance().r(), 1e-4);
    }

    /** Two squares at the coordinates of a survey, where floats are a quarter of a metre apart. */
    @Test
    void modelFarFromTheOrigin_keepsItsShape() throws IOException {
        Vec3 p = new Vec3(500_000.25, 12, 4_000_000.41);
        Scene square = new SceneBuilder().polygon(RoomScenes.grey("square", 1, .5), p, p.plus(new Vec3(0, 0, .2)),
                p.plus(new Vec3(.2, 0, .2)), p.plus(new Vec3(.2, 0, 0))).scene("square");
        Path file = folder.resolve("far.glb");
        LightmapModel.write(file, SceneModel.of(square), Lightmap.of(EvenLight.on(square), OptionalDouble.empty()), 1);
        Scene again = SceneReader.read(file, ReadOptions.defaults(), warning -> { });
        assertEquals(.04, again.area(), 1e-6);
    }

    /** A strip of 500 by 1, which at 600,000 texels would be 17,000 long. */
    @Test
    void longScene_getsFewerTexels() throws IOException {
        Scene strip = new SceneBuilder().polygon(RoomScenes.grey("strip", 1, .5), Vec3.ZERO, new Vec3(0, 0, 500),
                new Vec3(1, 0, 500), new Vec3(1, 0, 0)).scene("strip");
        Lightmap chosen = Lightmap.of(EvenLight.on(strip), OptionalDouble.empty());
        assertTrue(chosen.irradiance().height() <= 8192 && chosen.irradiance().width() <= 8192);
        assertEquals(Math.sqrt(600_000 / 500.0) / 4, chosen.samples(), 1e-9);
        assertThrows(IOException.class, () -> Lightmap.of(EvenLight.on(strip), OptionalDouble.of(17)));
    }

    /** A square of two triangles that share vertices, and one that is turned: at two nodes, and at two instances. */
    private Path instances() throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(5 * 12 + 9 * 2 + 2 + 2 * 12).order(ByteOrder.LITTLE_ENDIAN);
        for (float x : new float[] {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 1}) {
            bytes.putFloat(x);
        }
        for (int corner : new int[] {0, 1, 2, 0, 2, 3, 3, 2, 4}) {
            bytes.putShort((short) corner);
        }
        bytes.putShort((short) 0);
        for (float x : new float[] {0, 0, 3, 0, 0, 4}) {
            bytes.putFloat(x);
        }
        String text = """
                {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
                 "extensionsUsed": ["EXT_mesh_gpu_instancing"], "extensionsRequired": ["EXT_mesh_gpu_instancing"],
                 "nodes": [{"name": "a", "mesh": 0}, {"name": "b", "mesh": 0, "translation": [0, 0, 1.5],
                   "scale": [-1, 1, 1]}, {"name": "c", "mesh": 0, "extensions": {"EXT_mesh_gpu_instancing":
                   {"attributes": {"TRANSLATION": 2}}}}],
                 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
                 "accessors": [
                  {"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3", "min": [0, 0, 0],
                   "max": [1, 1, 1]},
                  {"bufferView": 1, "componentType": 5123, "count": 9, "type": "SCALAR"},
                  {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}],
                 "bufferViews": [{"buffer": 0, "byteLength": 60, "target": 34962},
                  {"buffer": 0, "byteOffset": 60, "byteLength": 18, "target": 34963},
                  {"buffer": 0, "byteOffset": 80, "byteLength": 24}],
                 "buffers": [{"byteLength": 104, "uri": "data:application/octet-stream;base64,BYTES"}]}
                """;
        return Files.writeString(folder.resolve("instances.gltf"), text.replace("BYTES",
                Base64.getEncoder().encodeToString(bytes.array())), StandardCharsets.UTF_8);
    }

    @Test
    void everyInstance_hasItsOwnPlacesInTheLightmap() throws IOException {
        Path lit = lit(instances());
        JsonNode got = json(lit);
        assertTrue(got.path("extensionsRequired").isMissingNode(), got.path("extensionsRequired").toString());
        Set<Integer> meshes = new HashSet<>();
        got.get("nodes").forEach(node -> {
            if (node.has("mesh")) {
                meshes.add(node.get("mesh").asInt());
            }
        });
        assertEquals(4, meshes.size());
        assertEquals(4, new HashSet<>(got.get("meshes").findValues("TEXCOORD_1")).size());
        for (JsonNode mesh : got.get("meshes")) {
            JsonNode position = mesh.at("/primitives/0/attributes/POSITION");
            assertEquals(9, got.get("accessors").get(position.asInt()).get("count").asInt(),
                    "a vertex for each place: in this light each triangle is lit for itself");
        }
    }

    private Path changed(String before, String after) throws IOException {
        Path model = instances();
        String text = Files.readString(model);
        assertTrue(text.contains(before), before);
        return Files.writeString(model, text.replace(before, after));
    }

    /** The node whose mesh they get keeps neither the weights nor what animates them: it has no mesh. */
    @Test
    void instancesOfAMorphedMesh_haveItsWeights() throws IOException {
        JsonNode got = json(lit(morphed("""
                {"channels": [{"sampler": 0, "target": {"node": 2, "path": "weights"}},
                  {"sampler": 0, "target": {"node": 2, "path": "scale"}}], "samplers": []}""")));
        int weighted = 0;
        for (JsonNode node : got.get("nodes")) {
            assertTrue(node.has("mesh") || !node.has("weights"), node.toString());
            weighted += node.has("weights") ? 1 : 0;
        }
        assertEquals(2, weighted);
        assertEquals("[{\"sampler\":0,\"target\":{\"node\":2,\"path\":\"scale\"}}]",
                got.get("animations").get(0).get("channels").toString());
    }

    private Path morphed(String animations) throws IOException {
        Path model = changed("\"indices\": 1}]}]", "\"indices\": 1, \"targets\": [{\"POSITION\": 0}]}]}]");
        return Files.writeString(model, Files.readString(model).replace("\"name\": \"c\", \"mesh\": 0,",
                "\"name\": \"c\", \"mesh\": 0, \"weights\": [0.5],").replace("\"accessors\": [",
                "\"animations\": [" + animations + "], \"accessors\": ["));
    }

    /** Both an animation without channels and an empty list of animations are not valid. */
    @Test
    void animationsOfWeightsAlone_areRemoved() throws IOException {
        String weights = "{\"channels\": [{\"sampler\": 0, \"target\": {\"node\": 2, \"path\": \"weights\"}}]}";
        assertFalse(json(lit(morphed(weights + ", " + weights))).has("animations"));
        JsonNode animations = json(lit(morphed(weights + ", " + weights.replace("weights", "scale"))))
                .get("animations");
        assertEquals(1, animations.size());
        assertEquals("scale", animations.at("/0/channels/0/target/path").asText());
    }

    /** A loader that decodes the compressed vertices would lay the lightmap on others. */
    @Test
    void compressionOfVerticesThatAreOthersNow_isRemoved() throws IOException {
        Path model = changed("\"indices\": 1}]}]", "\"indices\": 1, \"extensions\": {\"KHR_draco_mesh_compression\":"
                + " {\"bufferView\": 1}}}]}]");
        Files.writeString(model, Files.readString(model).replace("\"byteLength\": 60, \"target\"",
                "\"byteLength\": 60, \"extensions\": {\"EXT_meshopt_compression\": {\"buffer\": 1}}, \"target\""));
        String got = json(lit(model)).toString();
        assertFalse(got.contains("KHR_draco") || got.contains("meshopt"), got);
    }

    @Test
    void extrasOfAnyKind_stay() throws IOException {
        JsonNode got = json(lit(changed("\"meshes\"", "\"materials\": [{\"extras\": \"mine\"}], \"meshes\"")));
        assertEquals("mine", got.at("/materials/0/extras/extras").asText());
        assertTrue(got.at("/materials/0/extras/lightmap").isObject());
    }

    /** The reader needs neither; a copy of the vertices needs all of their arrays. */
    @ParameterizedTest
    @CsvSource(delimiter = ';', quoteCharacter = '`', value = {
        "\"POSITION\": 0}; \"POSITION\": 0, \"_SHORT\": 2}; an element for each of 5 vertices",
        "\"POSITION\": 0}; \"POSITION\": 0, \"_ODD\": 1}; an element for each of 5 vertices",
        "[\"EXT_mesh_gpu_instancing\"], \"extensionsR; \"EXT_mesh_gpu_instancing\", \"extensionsR; to be a list",
        "\"meshes\"; \"animations\": [{\"channels\": 7}], \"meshes\"; an animation with a list of channels",
        "\"meshes\"; \"materials\": [7], \"meshes\"; an object"})
    void whatTheReaderDoesNotLookAt_isCheckedBeforeItIsCopied(String before, String after, String expected)
            throws IOException {
        assertRefused(changed(before, after), expected);
    }

    private static void assertRefused(Path model, String expected) throws IOException {
        ReadOptions options = ReadOptions.defaults();
        Scene scene = SceneReader.read(model, options, warning -> { });
        String message = assertThrows(SceneFormatException.class,
                () -> SceneReader.original(model, options, scene)).getMessage();
        assertTrue(message.contains(expected), message);
    }

    /** An attribute that only the copy of the vertices needs. */
    @ParameterizedTest
    @CsvSource(delimiter = ';', quoteCharacter = '`', value = {
        "'bufferView': 0, 'byteOffset': -4; elements within their bufferView",
        "'sparse': {'count': 1}; /accessors/3/sparse/values",
        "'sparse': {'count': 1, 'values': {'bufferView': 2}}; /accessors/3/sparse/indices",
        "'sparse': {'count': 1, 'values': {'bufferView': 2}, 'indices': {'bufferView': 2, 'byteOffset': 8,"
            + " 'componentType': 5125}}; elements that there are",
        "'sparse': {'count': 3, 'values': {'bufferView': 2}, 'indices': {'bufferView': 1, 'componentType': 5123}};"
            + " elements within their bufferView"})
    void bytesOfOtherAttributes_areCheckedBeforeTheyAreCopied(String accessor, String expected) throws IOException {
        Path model = changed("\"POSITION\": 0}", "\"POSITION\": 0, \"_OTHER\": 3}");
        Files.writeString(model, Files.readString(model).replace("\"count\": 2, \"type\": \"VEC3\"}",
                "\"count\": 2, \"type\": \"VEC3\"}, {\"componentType\": 5126, \"count\": 5, \"type\": \"VEC3\", "
                + accessor.replace('\'', '"') + "}"));
        assertRefused(model, expected);
    }

    @Test
    void primitiveWithoutMaterial_doesNotGetTheUsersMaterialOfTheSameName() throws IOException {
        Path model = instances();
        Files.writeString(model, Files.readString(model).replace("\"meshes\"",
                "\"materials\": [{\"name\": \"no material\", \"doubleSided\": true}], \"meshes\""));
        JsonNode got = json(lit(model));
        assertEquals(2, got.get("materials").size());
        assertEquals(Set.of(1), got.get("meshes").findValues("material").stream().map(JsonNode::asInt)
                .collect(Collectors.toSet()), "one material for all primitives that have none");
    }

    /** By the Khronos validator, where node and npm are there. */
    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"src/test/resources/radiosity/input/room.glb", "src/test/resources/radiosity/input/room.obj",
        "scenes/study.lws", "instances"})
    void khronosValidator_findsNothingWrong(String model) throws Exception {
        Path lit = lit(model.equals("instances") ? instances() : Path.of(model));
        JsonNode issues = Node.run("validate.mjs", "gltf-validator@2.0.0-dev.3.10", lit).get("issues");
        assertEquals(0, issues.get("numErrors").asInt(), issues.toString());
        assertEquals(0, issues.get("numWarnings").asInt(), issues.toString());
    }
}
