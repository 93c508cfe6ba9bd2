package radiosity.output.model;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import radiosity.gltf.GltfLists;
import radiosity.gltf.GltfModel;
import radiosity.output.file.AtomicFile;
import radiosity.output.gltf.GlbWriter;
import radiosity.output.lightmap.ExrImage;
import radiosity.output.lightmap.Lightmap;
import radiosity.scene.Affine;

/**
 * Writes a model with an additional set of texture coordinates and a lightmap of irradiance: as half floats in a file
 * beside it, and as an RGBM image in it, which the "extras" of materials describe (docs/RECIPES.md).
 *
 * <p>A vertex that lies at several places of the lightmap is repeated. A mesh that stands at several nodes is copied
 * for each node, because its light differs from node to node.
 */
public final class LightmapModel {

    /**
     * Limits of the largest irradiance that half floats hold as it is, W/m² or lx: digits are lost below, floats end
     * above.
     */
    private static final double LEAST_RANGE = 1;
    private static final double MOST_RANGE = 60000;
    private static final int TRIANGLES = 4;
    private static final String INSTANCES = "EXT_mesh_gpu_instancing";
    private static final String DRACO = "KHR_draco_mesh_compression";

    private final GltfModel model;
    private final ObjectNode json;
    private final Lightmap lightmap;
    private final ObjectMapper mapper = new ObjectMapper();
    private final VertexCopier copier;
    /** The morph weights that nodes with instances had, by the node's number; missing where a node had none. */
    private final Map<Integer, JsonNode> weightsOf = new HashMap<>();
    /** Number of the lightmap's set of texture coordinates: the first that no mesh has. */
    private final int set;
    /** The material of primitives that have none in the user's model; -1 if there is no such primitive so far. */
    private int noMaterial = -1;

    private LightmapModel(GltfModel model, Lightmap lightmap) {
        this.model = model;
        this.lightmap = lightmap;
        json = model.json();
        copier = new VertexCopier(model);
        set = freeSet();
    }

    /**
     * The file of a model's lightmap: room-lightmap.exr for room.glb.
     *
     * @param file of the model; its name must end in .glb
     */
    public static Path beside(Path file) {
        String name = file.getFileName().toString();
        return file.resolveSibling(name.substring(0, name.length() - ".glb".length()) + "-lightmap.exr");
    }

    /**
     * Writes the model and, beside it, its lightmap; both replace older files.
     *
     * @param file     of the model; its name must end in .glb
     * @param model    of the scene that the lightmap belongs to; modified
     * @param exposure factor from radiosity to linear light of a screen, for programs that show the model
     */
    public static void write(Path file, GltfModel model, Lightmap lightmap, double exposure) throws IOException {
        double range = lightmap.range();
        double scale = range >= LEAST_RANGE && range <= MOST_RANGE ? 1
                : Math.scalb(1.0, Math.getExponent(MOST_RANGE) - Math.getExponent(range) - 1);
        byte[] exr = ExrImage.of(lightmap.irradiance(), scale);
        LightmapModel writer = new LightmapModel(model, lightmap);
        writer.placeTriangles();
        Map<String, Object> description = new LinkedHashMap<>();
        description.put("texCoord", writer.set);
        description.put("encoding", "RGBM");
        description.put("range", range);
        description.put("unit", lightmap.units().irradiance());
        description.put("exposure", exposure);
        description.put("emissionScale", 1 / lightmap.units().luminancePerRadiosity());
        description.put("file", beside(file).getFileName().toString());
        description.put("fileScale", scale);
        description.put("texelsPerUnit", lightmap.samples());
        description.put("index", writer.texture(lightmap.rgbm(range)));
        writer.describeLightmap(description);
        writer.json.putArray("buffers").addObject().put("byteLength", model.length());
        byte[] text = writer.mapper.writeValueAsBytes(writer.json);
        AtomicFile.write(beside(file), exr);
        AtomicFile.write(file, channel -> GlbWriter.write(channel, text, List.copyOf(model.arrays())));
    }

    private int freeSet() {
        int free = 1;
        for (JsonNode mesh : json.path("meshes")) {
            for (JsonNode primitive : mesh.path("primitives")) {
                while (primitive.path("attributes").has("TEXCOORD_" + free)) {
                    free++;
                }
            }
        }
        return free;
    }

    /**
     * Adds the lightmap's coordinates to a primitive. The sets of a primitive must be without gaps, so the lightmap's
     * coordinates also take the place of sets before them that the primitive lacks.
     */
    private void addSets(ObjectNode attributes, int accessor) {
        for (int s = 0; s <= set; s++) {
            if (!attributes.has("TEXCOORD_" + s)) {
                attributes.put("TEXCOORD_" + s, accessor);
            }
        }
    }

    /** A place where a mesh stands: a node, or an instance at a node (null for a node without instances). */
    private record Standing(int node, Affine instance) { }

    private void placeTriangles() throws IOException {
        Map<Standing, List<GltfModel.Place>> meshes = model.places().stream().collect(Collectors.groupingBy(
                place -> new Standing(place.node(), place.instance().orElse(null)), LinkedHashMap::new,
                Collectors.toList()));
        Map<Integer, Integer> users = new HashMap<>();
        Map<Integer, JsonNode> originals = new HashMap<>();
        Map<Integer, Integer> meshOf = new HashMap<>();
        for (Standing at : meshes.keySet()) {
            int mesh = node(at.node).path("mesh").asInt();
            meshOf.put(at.node, mesh);
            originals.computeIfAbsent(mesh, m -> json.get("meshes").get(m).deepCopy());
        }
        for (Map.Entry<Standing, List<GltfModel.Place>> entry : meshes.entrySet()) {
            Standing at = entry.getKey();
            int mesh = meshOf.get(at.node);
            boolean isFirst = users.merge(mesh, 1, Integer::sum) == 1;
            int own = isFirst ? mesh : json.withArrayProperty("meshes").add(originals.get(mesh).deepCopy()).size() - 1;
            (at.instance == null ? node(at.node) : instance(at)).put("mesh", own);
            for (GltfModel.Place place : entry.getValue()) {
                place(place, (ObjectNode) json.get("meshes").get(own).get("primitives").get(place.primitive()));
            }
        }
    }

    private ObjectNode node(int number) {
        return (ObjectNode) json.get("nodes").get(number);
    }

    /** Adds a node for an instance, below the node that had instances. */
    private ObjectNode instance(Standing at) {
        ObjectNode parent = node(at.node);
        parent.remove("mesh");
        if (parent.path("extensions").has(INSTANCES)) {
            ((ObjectNode) parent.get("extensions")).remove(INSTANCES);
            if (parent.get("extensions").isEmpty()) {
                parent.remove("extensions");
            }
            removeInstances();
        }
        JsonNode weights = weightsOf.computeIfAbsent(at.node, n -> takeWeights(n, parent));
        parent.withArrayProperty("children").add(json.get("nodes").size());
        ObjectNode node = json.withArrayProperty("nodes").addObject();
        GltfLists.matrix(node, at.instance);
        if (!weights.isMissingNode()) {
            node.set("weights", weights.deepCopy());
        }
        return node;
    }

    /** Removes the morph weights of a node whose mesh its instances get, with what animates them. */
    private JsonNode takeWeights(int node, ObjectNode parent) {
        JsonNode animations = json.path("animations");
        for (int a = animations.size() - 1; a >= 0; a--) {
            ArrayNode channels = ((ObjectNode) animations.get(a)).withArrayProperty("channels");
            for (int i = channels.size() - 1; i >= 0; i--) {
                JsonNode target = channels.get(i).path("target");
                if (target.path("node").asInt(-1) == node && target.path("path").asText().equals("weights")) {
                    channels.remove(i);
                }
            }
            if (channels.isEmpty()) { // an animation without channels is not valid, nor is an empty list of animations
                ((ArrayNode) animations).remove(a);
            }
        }
        if (animations.isEmpty()) {
            json.remove("animations");
        }
        JsonNode weights = parent.path("weights");
        parent.remove("weights");
        return weights;
    }

    /** Removes the extension for instances from the lists of extensions if no node has instances any more. */
    private void removeInstances() {
        for (JsonNode node : json.get("nodes")) {
            if (node.path("extensions").has(INSTANCES)) {
                return;
            }
        }
        for (String list : List.of("extensionsUsed", "extensionsRequired")) {
            ArrayNode names = json.withArrayProperty(list);
            for (int i = names.size() - 1; i >= 0; i--) {
                if (names.get(i).asText().equals(INSTANCES)) {
                    names.remove(i);
                }
            }
            if (names.isEmpty()) {
                json.remove(list);
            }
        }
    }

    /** Gives a primitive its coordinates in the lightmap. */
    private void place(GltfModel.Place place, ObjectNode primitive) throws IOException {
        int count = json.get("accessors").get(primitive.get("attributes").get("POSITION").asInt()).get("count").asInt();
        VertexSplit split = new VertexSplit(count, place, lightmap.places());
        int[] rows = split.rows();
        if (rows.length > count) {
            ObjectNode attributes = (ObjectNode) primitive.get("attributes");
            copyAll(attributes, rows);
            primitive.path("targets").forEach(target -> copyAll((ObjectNode) target, rows));
        }
        addSets((ObjectNode) primitive.get("attributes"), model.accessor(split.coordinates(), 2));
        if (primitive.path("extensions").isObject()) {
            ((ObjectNode) primitive.get("extensions")).remove(DRACO); // the vertices are others now
        }
        primitive.put("indices", indices(split.corners(), rows.length));
        primitive.put("mode", TRIANGLES);
    }

    private void copyAll(ObjectNode attributes, int[] rows) {
        Map<String, JsonNode> before = new TreeMap<>();
        attributes.properties().forEach(entry -> before.put(entry.getKey(), entry.getValue()));
        before.forEach((name, accessor) -> attributes.put(name, copier.copy(accessor.asInt(), rows)));
    }

    private int indices(int[] corners, int vertices) {
        boolean isShort = vertices < 0xFFFF;
        ByteBuffer bytes = ByteBuffer.allocate((isShort ? 2 : 4) * corners.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int corner : corners) {
            if (isShort) {
                bytes.putShort((short) corner);
            } else {
                bytes.putInt(corner);
            }
        }
        return model.accessor(bytes.array(), GltfLists.INDICES,
                isShort ? GltfLists.UNSIGNED_SHORT : GltfLists.UNSIGNED_INT, corners.length, "SCALAR");
    }

    private int texture(byte[] png) {
        ArrayNode images = json.withArrayProperty("images");
        images.addObject().put("name", "lightmap").put("mimeType", "image/png").put("bufferView", model.add(png));
        ArrayNode samplers = json.withArrayProperty("samplers");
        samplers.addObject().put("magFilter", GltfLists.NEAREST).put("minFilter", GltfLists.NEAREST)
                .put("wrapS", GltfLists.CLAMP).put("wrapT", GltfLists.CLAMP);
        ArrayNode textures = json.withArrayProperty("textures");
        textures.addObject().put("name", "lightmap").put("sampler", samplers.size() - 1)
                .put("source", images.size() - 1);
        return textures.size() - 1;
    }

    /** Describes the lightmap in the extras of all materials; primitives that have no material get one. */
    private void describeLightmap(Map<String, Object> description) {
        ArrayNode materials = json.withArrayProperty("materials");
        for (JsonNode node : json.get("nodes")) {
            if (node.hasNonNull("mesh")) {
                json.get("meshes").get(node.get("mesh").asInt()).get("primitives")
                        .forEach(primitive -> giveMaterial((ObjectNode) primitive, materials));
            }
        }
        for (JsonNode material : materials) {
            ObjectNode of = (ObjectNode) material;
            JsonNode before = of.path("extras");
            ObjectNode extras = before.isObject() ? (ObjectNode) before : of.putObject("extras");
            if (!before.isObject() && !before.isMissingNode()) {
                extras.set("extras", before); // may be any value, and stays beside the lightmap
            }
            extras.set("lightmap", mapper.valueToTree(description));
        }
    }

    private void giveMaterial(ObjectNode primitive, ArrayNode materials) {
        if (!primitive.hasNonNull("material") && primitive.path("mode").asInt(TRIANGLES) == TRIANGLES) {
            if (noMaterial < 0) {
                noMaterial = materials.size();
                materials.addObject().put("name", "no material");
            }
            primitive.put("material", noMaterial);
        }
    }
}
