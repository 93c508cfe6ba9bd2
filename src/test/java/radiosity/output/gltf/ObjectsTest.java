package radiosity.output.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.Test;
import radiosity.input.SceneReader;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Affine;
import radiosity.scene.Hierarchy;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneNode;
import radiosity.scene.Surface;
import radiosity.settings.ReadOptions;
import radiosity.testkit.EvenLight;

/** The objects of the input, their names, hierarchy and instances, are nodes of the scene file. */
class ObjectsTest extends WrittenScene {

    private static final Path STUDY = Path.of("scenes/study.lws");

    /** Version 3: objects in the order of the file, parents by their number in it. */
    @Test
    void study_keepsObjectsHierarchyAndInstances() throws IOException {
        List<String> files = new ArrayList<>();
        List<Integer> parents = new ArrayList<>();
        for (String line : Files.readAllLines(STUDY)) {
            String[] words = line.split(" ");
            if (words[0].equals("LoadObjectLayer")) {
                files.add(words[2] + (words[1].equals("1") ? "" : ":" + words[1]));
                parents.add(-1);
            } else if (words[0].equals("ParentItem")) {
                parents.set(files.size() - 1, Integer.parseInt(words[1], 16) & 0xFFFF);
            }
        }
        Scene study = LightWaveReader.read(STUDY, ReadOptions.defaults(), warning -> { });
        write(EvenLight.on(study));
        assertEquals(35, files.size());
        for (int parent = -1; parent < files.size(); parent++) {
            int of = parent;
            List<String> expected = IntStream.range(0, files.size()).filter(i -> parents.get(i) == of)
                    .mapToObj(files::get).toList();
            JsonNode node = parent < 0 ? top() : object(parent);
            List<JsonNode> objects = children(node).stream().filter(child -> child.has("extras")).toList();
            assertEquals(expected, objects.stream().map(n -> n.at("/extras/object/geometry").asText()).toList());
            assertEquals(expected.stream().map(path -> path.replaceAll("^study/|\\.lwo", "")).toList(),
                    objects.stream().map(n -> n.get("name").asText()).toList());
        }
        try (SceneFile scene = SceneFile.open(file)) {
            assertEquals(names(study.hierarchy().nodes()), names(scene.objects()));
            Map<List<Object>, Double> areas = areas(study);
            assertEquals(areas.size(), scene.meshes().size());
            for (Mesh mesh : scene.meshes()) {
                double area = IntStream.range(0, mesh.elements()).mapToDouble(e -> mesh.cross(e).length() / 2).sum();
                double expected = areas.get(List.of(mesh.node(), mesh.surface().name()));
                assertEquals(expected, area, 1e-5 * expected, mesh.surface().name() + " of object " + mesh.node());
            }
        }
    }

    /** An object of the study by its number in the input. */
    private JsonNode object(int number) throws IOException {
        return StreamSupport.stream(json().get("nodes").spliterator(), false)
                .filter(node -> node.at("/extras/object").isObject()).skip(number).findFirst().orElseThrow();
    }

    /** By object and surface. */
    private static Map<List<Object>, Double> areas(Scene scene) {
        Map<List<Object>, Double> areas = new HashMap<>();
        for (int t = 0; t < scene.triangles(); t++) {
            areas.merge(List.of(scene.hierarchy().of(t), scene.surface(t).name()), scene.area(t), Double::sum);
        }
        return areas;
    }

    private static List<String> names(List<SceneNode> nodes) {
        return nodes.stream().map(node -> node.name() + "|" + node.parent() + "|" + node.geometry() + "|"
                + Arrays.toString(node.placement().m())).toList();
    }

    /** Nodes of a file of Blender's, by the names of their parents: they are in the scene file as they are in it. */
    @Test
    void blendersRoom_keepsObjectsHierarchyAndInstances() throws IOException, URISyntaxException {
        Path room = Path.of(ObjectsTest.class.getResource("/radiosity/input/room.glb").toURI());
        write(EvenLight.on(SceneReader.read(room, ReadOptions.defaults(), warning -> { })));
        assertEquals(7, edges(json(room)).size());
        assertEquals(edges(json(room)), edges(json()).stream().map(edge -> edge.replaceFirst("^room.glb/", "/"))
                .filter(edge -> !edge.matches("/room.glb|Room/(white|red)")).sorted().toList());
    }

    /** Each node's name after its parent's. */
    private static List<String> edges(JsonNode json) {
        Map<Integer, String> parents = new HashMap<>();
        for (JsonNode node : json.get("nodes")) {
            node.path("children").forEach(child -> parents.put(child.asInt(), node.path("name").asText()));
        }
        return IntStream.range(0, json.get("nodes").size())
                .mapToObj(i -> parents.getOrDefault(i, "") + "/" + json.get("nodes").get(i).path("name").asText())
                .sorted().toList();
    }

    @Test
    void objectsWithinObjects_nullObjects_andObjectsOfTwoSurfaces_areNodesWithinNodes() throws IOException {
        Affine up = Affine.move(0, 2, 0);
        List<SceneNode> nodes = List.of(new SceneNode("group", -1, "", Affine.IDENTITY),
                new SceneNode("chair", 0, "chair.lwo", up), new SceneNode("chair", 1, "chair.lwo", up));
        Surface wood = new Surface("wood", Rgb.BLACK, Rgb.grey(.5), false);
        Surface seat = new Surface("seat", Rgb.BLACK, Rgb.grey(.25), false);
        Scene scene = new Scene("room", new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0},
                new int[] {0, 1, 2, 1, 3, 2, 1, 4, 3}, new int[] {0, 1, 0}, List.of(wood, seat), List.of(),
                Optional.empty(), new float[0], new float[0], new Hierarchy(nodes, new int[] {1, 1, 2}));
        write(EvenLight.on(scene));
        JsonNode group = children(top()).get(0);
        assertEquals("group", group.get("name").asText());
        assertTrue(!group.has("mesh"));
        JsonNode chair = children(group).get(0);
        assertEquals("chair", chair.get("name").asText());
        assertEquals(List.of("chair", "wood", "seat"),
                children(chair).stream().map(node -> node.get("name").asText()).toList());
        assertTrue(children(chair).get(0).has("mesh"), "an object of one surface has its mesh itself");
        assertEquals(2, chair.at("/extras/object/matrix/13").asDouble());
        try (SceneFile read = SceneFile.open(file)) {
            assertEquals(names(nodes), names(read.objects()));
            assertEquals(List.of(1, 2, 1), read.meshes().stream().map(Mesh::node).toList());
        }
    }

    private JsonNode json() throws IOException {
        return json(file);
    }

    private static JsonNode json(Path glb) throws IOException {
        ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(glb)).order(ByteOrder.LITTLE_ENDIAN);
        return new ObjectMapper().readTree(bytes.array(), 20, bytes.getInt(12));
    }

    private JsonNode top() throws IOException {
        JsonNode json = json();
        return json.get("nodes").get(json.at("/scenes/0/nodes/0").asInt());
    }

    private List<JsonNode> children(JsonNode of) throws IOException {
        JsonNode nodes = json().get("nodes");
        List<JsonNode> children = new ArrayList<>();
        StreamSupport.stream(of.path("children").spliterator(), false)
                .forEach(child -> children.add(nodes.get(child.asInt())));
        return children;
    }
}
