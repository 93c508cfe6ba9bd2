package radiosity.edit.model;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.DoubleStream;
import radiosity.gltf.Glb;
import radiosity.gltf.GltfLists;
import radiosity.gltf.Rotation;
import radiosity.input.gltf.GltfReader;
import radiosity.scene.Affine;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.settings.ReadOptions;

/**
 * The content of a glTF file in which edited objects are moved and edited surfaces are painted: nodes' placements and
 * materials' base colours change. What else the file says stays, and so do its arrays, in the file or beside it.
 */
final class GltfCopy {

    private static final String GLOSSY = "KHR_materials_pbrSpecularGlossiness";

    private final ObjectNode json;

    private GltfCopy(ObjectNode json) {
        this.json = json;
    }

    /**
     * Returns the bytes of the copy.
     *
     * @throws IllegalArgumentException where a glTF file cannot express the edits
     */
    static byte[] of(Path source, ReadOptions options, Scene before, Scene edited) throws IOException {
        GltfReader.Origins origins = GltfReader.origins(source, options);
        GltfCopy copy = new GltfCopy(origins.json());
        for (int n = 0; n < origins.nodes().size(); n++) {
            Affine was = before.hierarchy().nodes().get(n).placement();
            Affine is = edited.hierarchy().nodes().get(n).placement();
            if (!Arrays.equals(was.m(), is.m())) {
                copy.move(origins.nodes().get(n), was, is, edited.hierarchy().nodes().get(n).name());
            }
        }
        for (int s = 0; s < origins.materials().size(); s++) {
            Rgb reflectance = edited.surfaces().get(s).reflectance();
            if (!reflectance.equals(before.surfaces().get(s).reflectance())) {
                copy.paint(origins.materials().get(s), reflectance);
            }
        }
        return copy.bytes(Files.readAllBytes(source));
    }

    /*---- Nodes ----*/

    private void move(int number, Affine was, Affine is, String name) {
        if (number < 0) {
            throw new IllegalArgumentException(name + ": expected a node to be moved, got one of its instances");
        }
        if (isAnimated(number)) {
            throw new IllegalArgumentException(name + ": expected a node at rest to be moved, got one that an animation"
                    + " moves");
        }
        ObjectNode node = (ObjectNode) json.get("nodes").get(number);
        Affine turn = is.times(was.inverse());
        if (node.hasNonNull("matrix") || !isRotation(turn)) {
            node.remove(Arrays.asList("translation", "rotation", "scale"));
            GltfLists.matrix(node, is);
            return;
        }
        node.putArray("translation").add(is.m()[3]).add(is.m()[7]).add(is.m()[11]);
        double[] by = Rotation.quaternion(turn);
        if (by[3] < 1) {
            double[] q = Rotation.product(by, numbers(node.path("rotation"), 0, 0, 0, 1));
            DoubleStream.of(q).forEach(node.putArray("rotation")::add);
        }
    }

    private boolean isAnimated(int node) {
        for (JsonNode animation : json.path("animations")) {
            for (JsonNode channel : animation.path("channels")) {
                if (channel.path("target").path("node").asInt(-1) == node
                        && !channel.path("target").path("path").asText().equals("weights")) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether a map's rows are at right angles and of length 1, and nothing is mirrored; not so for NaN. */
    private static boolean isRotation(Affine map) {
        double[] m = map.m();
        for (int i = 0; i < 9; i++) {
            int row = i / 3 * 4;
            int other = i % 3 * 4;
            double product = m[row] * m[other] + m[row + 1] * m[other + 1] + m[row + 2] * m[other + 2];
            if (!(Math.abs(product - (row == other ? 1 : 0)) < ModelCopy.SAME)) {
                return false;
            }
        }
        return map.determinant() > 0;
    }

    private static double[] numbers(JsonNode array, double... otherwise) {
        for (int i = 0; i < array.size(); i++) {
            otherwise[i] = array.get(i).asDouble();
        }
        return otherwise;
    }

    /*---- Materials ----*/

    private void paint(int number, Rgb reflectance) {
        ObjectNode material = number < 0 ? ofPrimitivesWithoutMaterial()
                : (ObjectNode) json.get("materials").get(number);
        boolean isGlossy = material.path("extensions").path(GLOSSY).isObject();
        ObjectNode base = isGlossy ? (ObjectNode) material.get("extensions").get(GLOSSY)
                : material.withObjectProperty("pbrMetallicRoughness");
        String key = isGlossy ? "diffuseFactor" : "baseColorFactor";
        double alpha = numbers(base.path(key), 1, 1, 1, 1)[3];
        GltfLists.put(base.putArray(key), reflectance).add(alpha);
    }

    /** Adds a material like the default one, and gives it to all primitives that have none. */
    private ObjectNode ofPrimitivesWithoutMaterial() {
        ArrayNode materials = json.withArrayProperty("materials");
        for (JsonNode mesh : json.path("meshes")) {
            for (JsonNode primitive : mesh.path("primitives")) {
                if (!primitive.hasNonNull("material")) {
                    ((ObjectNode) primitive).put("material", materials.size());
                }
            }
        }
        ObjectNode material = materials.addObject().put("name", "default");
        material.putObject("pbrMetallicRoughness").put("metallicFactor", 0).put("roughnessFactor", 1);
        return material;
    }

    /*---- The file ----*/

    private byte[] bytes(byte[] source) throws IOException {
        ObjectMapper mapper = new ObjectMapper();
        ByteBuffer from = ByteBuffer.wrap(source).order(ByteOrder.LITTLE_ENDIAN);
        if (source.length < Glb.HEAD + Glb.CHUNK_HEAD || from.getInt(0) != Glb.MAGIC) {
            return mapper.writerWithDefaultPrettyPrinter().writeValueAsBytes(json);
        }
        byte[] text = mapper.writeValueAsBytes(json);
        int padded = Glb.padded(text.length);
        int rest = Glb.HEAD + Glb.CHUNK_HEAD + from.getInt(Glb.HEAD);
        int length = Glb.HEAD + Glb.CHUNK_HEAD + padded + from.getInt(8) - rest;
        ByteBuffer copy = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
        copy.put(source, 0, 8).putInt(length).putInt(padded).put(source, Glb.HEAD + 4, 4).put(text);
        while (copy.position() < Glb.HEAD + Glb.CHUNK_HEAD + padded) {
            copy.put((byte) ' ');
        }
        return copy.put(source, rest, from.getInt(8) - rest).array();
    }
}
