package radiosity.output.gltf;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Queue;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import radiosity.gltf.CameraPose;
import radiosity.gltf.GltfLists;
import radiosity.gltf.JsonCursor;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Affine;
import radiosity.scene.Camera;
import radiosity.scene.Lamp;
import radiosity.scene.SceneNode;
import radiosity.scene.Specular;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/** Reads the meshes, objects and camera of a scene file: the nodes below the one top node of its default scene. */
final class SceneMeshes {

    private final GlbReader glb;
    private final List<Lamp> lamps;
    private final JsonCursor root;
    private final JsonCursor top;
    /** The top node and all nodes below it, each after its parent. */
    private final List<Placed> nodes = new ArrayList<>();
    private final List<SceneNode> objects = new ArrayList<>();

    /** @param lamps whose light is kept apart, one per layer */
    SceneMeshes(GlbReader glb, List<Lamp> lamps) throws IOException {
        this.glb = glb;
        this.lamps = lamps;
        root = new JsonCursor(glb.name, glb.json);
        JsonCursor scene = root.at("scenes").at(root.at("scene").integer());
        top = root.at("nodes").at(scene.at("nodes").at(0).integer());
        collect();
    }

    /**
     * A node of the file.
     *
     * @param number index in the file's list of nodes; -1 for the top node
     * @param object index of the object that the node is or is a part of; -1 without an object
     */
    private record Placed(JsonCursor node, int number, int object) { }

    /** Collects the nodes, in the file's order as far as each comes after its parent; several parents are an error. */
    private void collect() throws IOException {
        Queue<Placed> ahead = new PriorityQueue<>(Comparator.comparingInt(Placed::number));
        ahead.add(new Placed(top, -1, -1));
        Set<Integer> met = new HashSet<>();
        while (!ahead.isEmpty()) {
            Placed parent = ahead.remove();
            int object = parent.object;
            Optional<JsonCursor> original = parent.node.optional("extras").flatMap(extras -> extras.optional("object"));
            if (original.isPresent()) {
                objects.add(object(parent.node, original.get(), object));
                object = objects.size() - 1;
            }
            nodes.add(new Placed(parent.node, parent.number, object));
            for (JsonCursor child : parent.node.list("children")) {
                int index = child.integer();
                if (!met.add(index)) {
                    throw parent.node.at("children").wrong("nodes that have one parent");
                }
                ahead.add(new Placed(root.at("nodes").at(index), index, object));
            }
        }
    }

    private static SceneNode object(JsonCursor node, JsonCursor original, int parent) throws IOException {
        double[] m = new double[12];
        Optional<JsonCursor> matrix = original.optional("matrix");
        for (int i = 0; i < m.length; i++) {
            m[i] = matrix.isEmpty() ? Double.NaN : matrix.get().numbers(16)[4 * (i % 4) + i / 4];
        }
        return new SceneNode(node.at("name").text(), parent, original.at("geometry").text(), new Affine(m));
    }

    /** The input's objects, each after its parent. */
    List<SceneNode> objects() {
        return List.copyOf(objects);
    }

    Vec3 origin() throws IOException {
        return translation(top);
    }

    private static Vec3 translation(JsonCursor node) throws IOException {
        Optional<JsonCursor> translation = node.optional("translation");
        if (translation.isEmpty()) {
            return Vec3.ZERO;
        }
        double[] t = translation.get().numbers(3);
        return new Vec3(t[0], t[1], t[2]);
    }

    Optional<Camera> camera() throws IOException {
        Optional<JsonCursor> first = nodes.stream().map(Placed::node).filter(n -> n.node().has("camera")).findFirst();
        if (first.isEmpty()) {
            return Optional.empty();
        }
        JsonCursor node = first.get();
        JsonCursor perspective = root.at("cameras").at(node.at("camera").integer()).at("perspective");
        try {
            return Optional.of(CameraPose.camera(translation(node).plus(origin()), node.at("rotation").numbers(4),
                    perspective.at("yfov").number(), perspective.at("aspectRatio").number()));
        } catch (IllegalArgumentException e) {
            throw perspective.wrong("a perspective");
        }
    }

    List<Mesh> read() throws IOException {
        SortedMap<Integer, Mesh> meshes = new TreeMap<>();
        for (Placed placed : nodes) {
            Optional<JsonCursor> mesh = placed.node.optional("mesh");
            if (mesh.isPresent()) {
                int number = mesh.get().integer();
                meshes.put(number, mesh(root.at("meshes").at(number).at("primitives").at(0), placed.object));
            }
        }
        return List.copyOf(meshes.values());
    }

    /** Reads the meshes of the second scene; none if there is only one scene. */
    List<TexturedMesh> readTextured() throws IOException {
        List<TexturedMesh> meshes = new ArrayList<>();
        if (root.at("scenes").size() > 1) {
            JsonCursor second = root.at("nodes").at(root.at("scenes").at(1).at("nodes").at(0).integer());
            for (JsonCursor child : second.list("children")) {
                JsonCursor node = root.at("nodes").at(child.integer());
                meshes.add(textured(root.at("meshes").at(node.at("mesh").integer()).at("primitives").at(0)));
            }
        }
        return meshes;
    }

    private TexturedMesh textured(JsonCursor primitive) throws IOException {
        JsonCursor attributes = primitive.at("attributes");
        float[] positions = floats(attributes.at("POSITION"), -1);
        if (positions.length % 9 != 0) {
            throw attributes.wrong("3 vertices per triangle");
        }
        int texture = root.at("materials").at(primitive.at("material").integer()).at("pbrMetallicRoughness")
                .at("baseColorTexture").at("index").integer();
        JsonCursor image = root.at("images").at(root.at("textures").at(texture).at("source").integer());
        return new TexturedMesh(positions, floats(attributes.at("TEXCOORD_0"), "VEC2", 2, positions.length / 3),
                glb.view(image.at("bufferView").integer()).array());
    }

    private Mesh mesh(JsonCursor primitive, int object) throws IOException {
        JsonCursor attributes = primitive.at("attributes");
        float[] positions = floats(attributes.at("POSITION"), -1);
        int n = positions.length / 3;
        JsonCursor extras = root.at("materials").at(primitive.at("material").integer()).at("extras");
        return new Mesh(surface(extras), object, extras.at("back").node().booleanValue(), positions,
                floats(attributes.at("NORMAL"), n), floats(attributes.at("_IRRADIANCE"), n),
                floats(attributes.at("_RADIOSITY"), n), reflectance(attributes, n), layers(attributes, n),
                corners(primitive.at("indices"), n)).smoothed();
    }

    private float[] reflectance(JsonCursor attributes, int vertices) throws IOException {
        Optional<JsonCursor> own = attributes.optional("_REFLECTANCE");
        return own.isEmpty() ? new float[0] : floats(own.get(), vertices);
    }

    private List<float[]> layers(JsonCursor attributes, int vertices) throws IOException {
        List<float[]> layers = new ArrayList<>();
        for (int layer = 0; layer < lamps.size(); layer++) {
            layers.add(floats(attributes.at("_IRRADIANCE_" + layer), vertices));
        }
        return layers;
    }

    private static Surface surface(JsonCursor extras) throws IOException {
        try {
            return new Surface(extras.at("surface").text(), extras.at("exitance").rgb(),
                    extras.at("reflectance").rgb(), extras.at("twoSided").node().booleanValue())
                            .with(specular(extras)).smoothed(extras.number("smoothing", 0));
        } catch (IllegalArgumentException e) {
            throw extras.wrong("a surface");
        }
    }

    private static Optional<Specular> specular(JsonCursor extras) throws IOException {
        Optional<JsonCursor> there = extras.optional("specular");
        if (there.isEmpty()) {
            return Optional.empty();
        }
        JsonCursor specular = there.get();
        return Optional.of(new Specular(specular.at("reflectance").rgb(), specular.at("transmittance").rgb(),
                specular.at("diffuse").number(), specular.at("roughness").number(), specular.at("index").number(),
                specular.isOn("thin")));
    }

    /** @param vertices expected number of vertices, or -1 for any number */
    private float[] floats(JsonCursor accessor, int vertices) throws IOException {
        return floats(accessor, "VEC3", 3, vertices);
    }

    private float[] floats(JsonCursor accessor, String type, int components, int vertices) throws IOException {
        ByteBuffer bytes = bytes(accessor, GltfLists.FLOAT, type, components, vertices);
        float[] values = new float[bytes.remaining() / 4];
        bytes.asFloatBuffer().get(values);
        for (float value : values) {
            if (!Float.isFinite(value)) {
                throw accessor.wrong("finite numbers");
            }
        }
        return values;
    }

    private int[] corners(JsonCursor accessor, int vertices) throws IOException {
        ByteBuffer bytes = bytes(accessor, GltfLists.UNSIGNED_INT, "SCALAR", 1, -1);
        int[] corners = new int[bytes.remaining() / 4];
        bytes.asIntBuffer().get(corners);
        for (int corner : corners) {
            if (corner < 0 || corner >= vertices) {
                throw accessor.wrong("vertices below " + vertices);
            }
        }
        if (corners.length % 3 != 0) {
            throw accessor.wrong("3 corners per element");
        }
        return corners;
    }

    /** Reads an accessor of 4-byte components as this program writes them; a count of -1 stands for any count. */
    private ByteBuffer bytes(JsonCursor index, int componentType, String type, int components, int count)
            throws IOException {
        JsonCursor accessor = root.at("accessors").at(index.integer());
        ByteBuffer bytes = glb.view(accessor.at("bufferView").integer());
        long expected = 4L * components * accessor.at("count").integer();
        if (accessor.at("componentType").integer() != componentType || !accessor.at("type").text().equals(type)
                || bytes.remaining() != expected || count >= 0 && expected != 4L * components * count) {
            throw accessor.wrong("an accessor as this program writes it");
        }
        return bytes;
    }
}
