package radiosity.torture;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** A scene file, read by other means than the program's: as a glTF binary of which every byte must be there. */
final class LightFile {

    private static final int MAGIC = 0x46546C67;

    final List<Mesh> meshes = new ArrayList<>();
    /** The asset's extras.radiosity. */
    final JsonNode radiosity;
    private final JsonNode json;
    private final ByteBuffer binary;

    /**
     * One side of a surface.
     *
     * @param indices     three per triangle
     * @param attributes  by name, three numbers per vertex
     * @param reflectance of the material, three channels
     * @param exitance    of the material, W/m2, three channels
     */
    record Mesh(String name, int[] indices, Map<String, float[]> attributes, double[] reflectance, double[] exitance) {

        /** Reflectance at a vertex: an image may vary it. */
        double reflectance(int vertex, int channel) {
            float[] varied = attributes.get("_REFLECTANCE");
            return varied == null ? reflectance[channel] : varied[3 * vertex + channel];
        }

        float[] positions() {
            return attributes.get("POSITION");
        }

        float[] radiosity() {
            return attributes.get("_RADIOSITY");
        }

        float[] irradiance() {
            return attributes.get("_IRRADIANCE");
        }
    }

    /** @throws IOException if it is not whole */
    static LightFile read(Path file) throws IOException {
        try {
            return new LightFile(Files.readAllBytes(file));
        } catch (BufferUnderflowException | IllegalArgumentException | IndexOutOfBoundsException
                 | NullPointerException e) {
            throw new IOException(file.getFileName() + " is no whole scene file: " + e, e);
        }
    }

    private LightFile(byte[] bytes) throws IOException {
        ByteBuffer all = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        if (all.getInt() != MAGIC || all.getInt() != 2 || all.getInt() != bytes.length) {
            throw new IllegalArgumentException("expected glTF 2 of " + bytes.length + " bytes");
        }
        byte[] text = new byte[all.getInt()];
        all.getInt();
        all.get(text);
        json = new ObjectMapper().readTree(text);
        int length = all.hasRemaining() ? all.getInt() : 0;
        if (length > 0) {
            all.getInt();
        }
        binary = all.slice().order(ByteOrder.LITTLE_ENDIAN);
        if (binary.remaining() != length) {
            throw new IllegalArgumentException("expected " + length + " bytes of arrays, got " + binary.remaining());
        }
        radiosity = json.at("/asset/extras/radiosity");
        JsonNode scene = json.get("scenes").get(json.path("scene").asInt());
        for (JsonNode root : scene.path("nodes")) {
            addNode(json.get("nodes").get(root.asInt()));
        }
    }

    private void addNode(JsonNode node) {
        if (node.has("mesh")) {
            JsonNode mesh = json.get("meshes").get(node.get("mesh").asInt());
            for (JsonNode primitive : mesh.get("primitives")) {
                addMesh(mesh.path("name").asText(), primitive);
            }
        }
        for (JsonNode child : node.path("children")) {
            addNode(json.get("nodes").get(child.asInt()));
        }
    }

    private void addMesh(String name, JsonNode primitive) {
        Map<String, float[]> attributes = new TreeMap<>();
        primitive.get("attributes").properties().forEach(attribute -> {
            JsonNode accessor = json.get("accessors").get(attribute.getValue().asInt());
            if (accessor.get("componentType").asInt() == 5126) {
                attributes.put(attribute.getKey(), floats(accessor));
            }
        });
        JsonNode accessor = json.get("accessors").get(primitive.get("indices").asInt());
        int[] indices = new int[accessor.get("count").asInt()];
        view(accessor).asIntBuffer().get(indices);
        JsonNode extras = json.get("materials").get(primitive.get("material").asInt()).get("extras");
        meshes.add(new Mesh(name, indices, attributes, channels(extras.get("reflectance")),
                channels(extras.get("exitance"))));
    }

    private static double[] channels(JsonNode list) {
        return new double[] {list.get(0).asDouble(), list.get(1).asDouble(), list.get(2).asDouble()};
    }

    private float[] floats(JsonNode accessor) {
        int components = accessor.get("type").asText().equals("VEC3") ? 3 : 4;
        float[] values = new float[components * accessor.get("count").asInt()];
        view(accessor).asFloatBuffer().get(values);
        return values;
    }

    private ByteBuffer view(JsonNode accessor) {
        JsonNode view = json.get("bufferViews").get(accessor.get("bufferView").asInt());
        int from = view.path("byteOffset").asInt() + accessor.path("byteOffset").asInt();
        return binary.duplicate().order(ByteOrder.LITTLE_ENDIAN).position(from)
                .limit(view.path("byteOffset").asInt() + view.get("byteLength").asInt()).slice()
                .order(ByteOrder.LITTLE_ENDIAN);
    }

    int shots() {
        return radiosity.get("shots").asInt();
    }

    /** The first number that is none, or null where all are. */
    String notFinite() {
        for (Mesh mesh : meshes) {
            for (Map.Entry<String, float[]> attribute : mesh.attributes.entrySet()) {
                float[] values = attribute.getValue();
                for (int i = 0; i < values.length; i++) {
                    if (!Float.isFinite(values[i])) {
                        return attribute.getKey() + "[" + i / 3 + "] of " + mesh.name + " is " + values[i];
                    }
                }
            }
        }
        return json.toString().matches("(?s).*\"(NaN|-?Infinity)\".*") ? "NaN or Infinity in its JSON" : null;
    }

    /** Where geometry, radiosity or irradiance (layers too) differ in a bit from another file's, or null. */
    String difference(LightFile other) {
        if (meshes.size() != other.meshes.size()) {
            return other.meshes.size() + " meshes instead of " + meshes.size();
        }
        for (int m = 0; m < meshes.size(); m++) {
            Mesh a = meshes.get(m);
            Mesh b = other.meshes.get(m);
            if (!a.name.equals(b.name) || !Arrays.equals(a.indices, b.indices)
                    || !a.attributes.keySet().equals(b.attributes.keySet())) {
                return "other elements in mesh " + a.name;
            }
            for (String attribute : a.attributes.keySet()) {
                String where = difference(a.attributes.get(attribute), b.attributes.get(attribute));
                if (where != null) {
                    return attribute + " of " + a.name + where;
                }
            }
        }
        return null;
    }

    private static String difference(float[] a, float[] b) {
        for (int i = 0; i < a.length; i++) {
            if (Float.floatToRawIntBits(a[i]) != Float.floatToRawIntBits(b[i])) {
                return "[" + i / 3 + "]: " + b[i] + " instead of " + a[i];
            }
        }
        return null;
    }
}
