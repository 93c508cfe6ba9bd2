package radiosity.output.gltf;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import radiosity.gltf.Glb;
import radiosity.gltf.GltfLists;
import radiosity.output.image.PictureFormat;
import radiosity.output.image.ToneMapping;
import radiosity.output.lightmap.TextureBake;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Camera;
import radiosity.scene.Hierarchy;
import radiosity.scene.Rgb;
import radiosity.scene.SceneNode;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/** The JSON of a scene file and the arrays that the JSON refers to, in the order in which the arrays are written. */
final class SceneDocument {

    /*
     * The JSON is made with Jackson's tree, not with a glTF library: jgltf 2.0.4 builds the whole file in memory twice,
     * counts its bytes in an int and keeps a node's translation in floats.
     */

    static final String UNLIT = "KHR_materials_unlit";
    /** Largest number of vertices whose indices are exact in floats. */
    private static final int MOST_JOINED = 1 << 24;

    private final ObjectMapper mapper = new ObjectMapper().enable(SerializationFeature.ORDER_MAP_ENTRIES_BY_KEYS);
    private final ObjectNode root = mapper.createObjectNode();
    private final GltfLists lists = new GltfLists(root);
    private final ObjectNode top;
    private long binLength;
    /** Top node of the second scene; null without textures. */
    private ObjectNode textures;
    final List<Object> arrays = new ArrayList<>();
    /** The file's nodes, 1 per node of the hierarchy. */
    private final List<ObjectNode> objects = new ArrayList<>();
    /** Numbers of the meshes at each node of the hierarchy. */
    private final List<List<Integer>> meshesOf = new ArrayList<>();
    /** Number of the material of each side. */
    private final Map<Side, Integer> materials = new HashMap<>();

    private record Side(Surface surface, boolean back) { }

    /** @param origin subtracted from all positions of the file; becomes the translation of the one top node */
    SceneDocument(String sceneName, String generator, Vec3 origin, Hierarchy hierarchy) {
        root.putObject("asset").put("version", "2.0").put("generator", generator);
        root.putArray("extensionsUsed").add(UNLIT);
        root.put("scene", 0);
        root.putArray("scenes").addObject().put("name", sceneName).putArray("nodes").add(0);
        top = list("nodes").addObject().put("name", sceneName);
        if (!origin.equals(Vec3.ZERO)) {
            GltfLists.put(top.putArray("translation"), origin);
        }
        hierarchy.nodes().forEach(this::object);
    }

    /** Adds the node of an object: not placed, as positions count from the origin; its placement is in its extras. */
    private void object(SceneNode of) {
        ObjectNode parent = of.parent() < 0 ? top : objects.get(of.parent());
        ObjectNode node = child(parent).put("name", of.name());
        ObjectNode original = node.putObject("extras").putObject("object").put("geometry", of.geometry());
        if (of.placement().isFinite()) {
            GltfLists.matrix(original, of.placement());
        }
        objects.add(node);
        meshesOf.add(new ArrayList<>(1));
    }

    /** Puts the only mesh of an object on the object's node, several meshes on nodes below it. */
    void placeMeshes() {
        for (int n = 0; n < objects.size(); n++) {
            List<Integer> meshes = meshesOf.get(n);
            for (int mesh : meshes) {
                ObjectNode node = meshes.size() == 1 ? objects.get(n) : child(objects.get(n))
                        .put("name", list("meshes").get(mesh).get("name").textValue());
                node.put("mesh", mesh);
            }
        }
    }

    /** Length of all arrays so far, bytes. */
    long binLength() {
        return binLength;
    }

    /** The JSON in UTF-8. */
    byte[] json() throws IOException {
        if (binLength > 0) {
            root.putArray("buffers").addObject().put("byteLength", binLength);
        }
        return mapper.writeValueAsBytes(root);
    }

    /**
     * Sets an entry of the asset's extras.
     *
     * @param content values of JSON's types, or records of such values
     */
    void extras(String name, Map<String, ?> content) {
        ObjectNode extras = root.withObjectProperty("asset").putObject("extras");
        extras.set(name, mapper.valueToTree(content));
    }

    void mesh(Mesh mesh, ToneMapping toneMapping) {
        String name = mesh.surface().name() + (mesh.back() ? " (back)" : "");
        ObjectNode primitive = list("meshes").addObject().put("name", name).putArray("primitives").addObject();
        ObjectNode attributes = primitive.putObject("attributes");
        attributes.put("POSITION", vec3(mesh.positions()));
        attributes.put("NORMAL", vec3(mesh.normals()));
        attributes.put("COLOR_0", colours(mesh, toneMapping));
        attributes.put("_RADIOSITY", vec3(mesh.radiosity()));
        attributes.put("_IRRADIANCE", vec3(mesh.irradiance()));
        if (mesh.reflectance().length > 0) {
            attributes.put("_REFLECTANCE", vec3(mesh.reflectance()));
        }
        if (!mesh.smoothing().isFlat() && mesh.vertices() <= MOST_JOINED) {
            attributes.put("_SMOOTH", lists.accessor(view(mesh.smoothing().pairs()), GltfLists.VERTICES,
                    GltfLists.FLOAT, mesh.vertices(), "VEC2"));
        }
        for (int layer = 0; layer < mesh.layers().size(); layer++) {
            attributes.put("_IRRADIANCE_" + layer, vec3(mesh.layers().get(layer)));
        }
        primitive.put("indices", lists.accessor(view(mesh.corners()), GltfLists.INDICES, GltfLists.UNSIGNED_INT,
                3 * mesh.elements(), "SCALAR"));
        primitive.put("material", materials.computeIfAbsent(new Side(mesh.surface(), mesh.back()),
                side -> material(side.surface, side.back, name)));
        if (mesh.node() < 0) {
            child(top).put("name", name).put("mesh", lists.last("meshes"));
        } else {
            meshesOf.get(mesh.node()).add(lists.last("meshes"));
        }
    }

    /** Begins a second scene, to which {@link #texture} adds sides with their light in textures. */
    void beginTextures(Vec3 origin) {
        textures = list("nodes").addObject().put("name", "textures");
        list("scenes").addObject().put("name", "textures").putArray("nodes").add(lists.last("nodes"));
        if (!origin.equals(Vec3.ZERO)) {
            GltfLists.put(textures.putArray("translation"), origin);
        }
        list("samplers").addObject().put("magFilter", GltfLists.LINEAR).put("minFilter", GltfLists.LINEAR)
                .put("wrapS", GltfLists.CLAMP).put("wrapT", GltfLists.CLAMP);
    }

    /** Adds a side to the second scene. Only the encoded image of its texture is kept. */
    void texture(TextureBake.Baked side, ToneMapping toneMapping) throws IOException {
        textures.withArrayProperty("children").add(list("nodes").size());
        list("nodes").addObject().put("mesh", list("meshes").size());
        String name = side.surface().name() + (side.back() ? " (back, texture)" : " (texture)");
        int positions = vec3(side.positions());
        int places = lists.accessor(view(side.places()), GltfLists.VERTICES, GltfLists.FLOAT, side.places().length / 2,
                "VEC2");
        list("images").addObject().put("mimeType", "image/png")
                .put("bufferView", view(PictureFormat.png(side.radiosity(), toneMapping::map)));
        list("textures").addObject().put("sampler", 0).put("source", lists.last("images"));
        ObjectNode primitive = list("meshes").addObject().put("name", name).putArray("primitives").addObject();
        primitive.putObject("attributes").put("POSITION", positions).put("TEXCOORD_0", places);
        int material = material(side.surface(), side.back(), name);
        primitive.put("material", material);
        lists.get("materials", material).withObjectProperty("pbrMetallicRoughness")
                .putObject("baseColorTexture").put("index", lists.last("textures"));
    }

    private ObjectNode child(ObjectNode parent) {
        parent.withArrayProperty("children").add(list("nodes").size());
        return list("nodes").addObject();
    }

    private int material(Surface surface, boolean back, String name) {
        ObjectNode material = list("materials").addObject().put("name", name).put("doubleSided", false);
        material.putObject("pbrMetallicRoughness").put("metallicFactor", 0);
        material.putObject("extensions").putObject(UNLIT);
        ObjectNode extras = material.putObject("extras").put("surface", surface.name());
        GltfLists.put(extras.putArray("reflectance"), surface.reflectance());
        GltfLists.put(extras.putArray("exitance"), surface.exitance());
        extras.put("twoSided", surface.twoSided()).put("back", back);
        if (surface.smoothing() > 0) {
            extras.put("smoothing", surface.smoothing());
        }
        surface.specular().ifPresent(specular -> {
            ObjectNode node = extras.putObject("specular");
            GltfLists.put(node.putArray("reflectance"), specular.reflectance());
            GltfLists.put(node.putArray("transmittance"), specular.transmittance());
            node.put("diffuse", specular.diffuse()).put("roughness", specular.roughness())
                    .put("index", specular.index()).put("thin", specular.thin());
        });
        return lists.last("materials");
    }

    private int vec3(float[] values) {
        int accessor = lists.accessor(view(values), GltfLists.VERTICES, GltfLists.FLOAT, values.length / 3, "VEC3");
        lists.range(accessor, values);
        return accessor;
    }

    /**
     * Adds tone-mapped vertex colours as an accessor and returns its number: linear RGBA, opaque, 16-bit normalised,
     * because 8 bits would show bands and three components would not be aligned.
     */
    private int colours(Mesh mesh, ToneMapping toneMapping) {
        short[] colours = new short[4 * mesh.vertices()];
        float[] b = mesh.shown();
        for (int i = 0; i < mesh.vertices(); i++) {
            Rgb colour = toneMapping.map(new Rgb(b[3 * i], b[3 * i + 1], b[3 * i + 2]));
            for (int c = 0; c < 3; c++) {
                colours[4 * i + c] = (short) Math.round(65535 * colour.channel(c));
            }
            colours[4 * i + 3] = (short) 65535;
        }
        int accessor = lists.accessor(view(colours), GltfLists.VERTICES, GltfLists.UNSIGNED_SHORT, mesh.vertices(),
                "VEC4");
        lists.get("accessors", accessor).put("normalized", true);
        return accessor;
    }

    /**
     * Adds an array and returns the number of its buffer view.
     *
     * @param array of a type that {@link GlbWriter} writes
     */
    int view(Object array) {
        long bytes = GlbWriter.bytes(array);
        list("bufferViews").addObject().put("buffer", 0).put("byteOffset", binLength).put("byteLength", bytes);
        arrays.add(array);
        binLength += Glb.padded(bytes);
        return lists.last("bufferViews");
    }

    /**
     * Adds a camera below the top node.
     *
     * @param near   distance of the near plane, scene units, above 0
     * @param origin as in the constructor
     */
    void camera(Camera camera, double near, Vec3 origin) {
        lists.camera(child(top), camera, camera.position().minus(origin), near);
    }

    private ArrayNode list(String name) {
        return lists.list(name);
    }
}
