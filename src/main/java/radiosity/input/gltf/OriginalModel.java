package radiosity.input.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import radiosity.gltf.GltfLists;
import radiosity.gltf.GltfModel;
import radiosity.gltf.JsonCursor;
import radiosity.scene.Affine;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;

/** Makes a model of a glTF file with embedded buffers and images, and finds which of its triangles are in the scene. */
final class OriginalModel {

    private static final List<String> COMPRESSED = List.of("EXT_meshopt_compression", "KHR_meshopt_compression");
    private static final byte[] PNG = {(byte) 0x89, 'P', 'N', 'G'};
    private static final byte[] JPEG = {(byte) 0xFF, (byte) 0xD8, (byte) 0xFF};

    private final JsonCursor root;
    private final Buffers buffers;
    private final Meshes meshes;
    private final Accessors accessors;
    /** The first triangle of the scene that has not been matched with a triangle of the file. */
    private int next;

    OriginalModel(JsonCursor root, Buffers buffers, Meshes meshes) {
        this.root = root;
        this.buffers = buffers;
        this.meshes = meshes;
        accessors = new Accessors(root, buffers);
    }

    /** @param standing all placed meshes, in the order of their triangles in the scene */
    GltfModel of(List<GltfReader.Standing> standing, Scene scene) throws IOException {
        List<GltfModel.Place> places = new ArrayList<>();
        for (GltfReader.Standing mesh : standing) {
            for (Meshes.Part part : meshes.parts(mesh.mesh(), mesh.shape())) {
                boolean reversed = mesh.world().determinant() < 0;
                places.add(new GltfModel.Place(mesh.node(), part.primitive(), mesh.instance(), part.vertices(),
                        met(part, mesh.world(), reversed, scene), reversed));
            }
        }
        checkLists();
        for (GltfReader.Standing mesh : standing) {
            for (JsonCursor primitive : root.at("meshes").at(mesh.mesh()).list("primitives")) {
                checkVertices(primitive);
            }
        }
        ObjectNode json = root.node().deepCopy();
        GltfModel model = new GltfModel(json, places);
        joinBuffers(model);
        embedImages(model);
        return model;
    }

    /** The scene's triangle for each triangle of a part; -1 for triangles without area, which the scene left out. */
    private int[] met(Meshes.Part part, Affine world, boolean reversed, Scene scene) {
        int[] triangles = new int[part.vertices().length / 3];
        for (int t = 0; t < triangles.length; t++) {
            triangles[t] = next < scene.triangles() && isSame(part, t, world, reversed, scene) ? next++ : -1;
        }
        return triangles;
    }

    private boolean isSame(Meshes.Part part, int t, Affine world, boolean reversed, Scene scene) {
        float[] points = part.triangles().points();
        for (int k = 0; k < 3; k++) {
            int from = 3 * part.triangles().corners()[3 * t + k];
            int to = 3 * scene.corners()[3 * next + (reversed ? (3 - k) % 3 : k)];
            for (int a = 0; a < 3; a++) {
                if (world.point(a, points[from], points[from + 1], points[from + 2]) != scene.points()[to + a]) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Checks what a writer changes and the reader has not looked at. */
    private void checkLists() throws IOException {
        for (JsonCursor material : root.list("materials")) {
            require(material.node().isObject(), material, "an object");
        }
        for (JsonCursor animation : root.list("animations")) {
            require(animation.node().path("channels").isArray(), animation, "an animation with a list of channels");
        }
        for (String names : List.of("extensionsUsed", "extensionsRequired")) {
            Optional<JsonCursor> list = root.optional(names);
            require(list.isEmpty() || list.get().node().isArray(), root, names + " to be a list");
            for (JsonCursor name : root.list(names)) {
                require(name.node().isTextual(), name, "a name");
            }
        }
    }

    /** Checks that each array of a primitive's vertices has all of them, as vertices are copied with all arrays. */
    private void checkVertices(JsonCursor primitive) throws IOException {
        int count = root.at("accessors").at(primitive.at("attributes").at("POSITION").integer()).at("count").integer();
        checkVertices(primitive.at("attributes"), count);
        for (JsonCursor target : primitive.list("targets")) {
            checkVertices(target, count);
        }
    }

    private void checkVertices(JsonCursor attributes, int count) throws IOException {
        require(attributes.node().isObject(), attributes, "an object");
        for (Map.Entry<String, JsonNode> attribute : attributes.node().properties()) {
            JsonCursor accessor = root.at("accessors").at(attributes.at(attribute.getKey()).integer());
            require(accessor.at("count").integer() == count, accessor, "an element for each of " + count + " vertices");
            long size = GltfLists.elementSize(accessor.at("type").text(), accessor.at("componentType").integer());
            require(size > 0, accessor, "a type and a componentType of glTF");
            Optional<JsonCursor> number = accessor.optional("bufferView");
            if (number.isPresent() && count > 0) {
                int step = root.at("bufferViews").at(number.get().integer()).index("byteStride");
                requireWithin(accessor, number.get(), (step > 0 ? step : size) * (count - 1) + size);
            }
            Optional<JsonCursor> sparse = accessor.optional("sparse");
            if (sparse.isPresent()) {
                JsonCursor values = sparse.get().at("values");
                requireWithin(values, values.at("bufferView"), size * accessors.replaced(sparse.get(), count).length);
            }
        }
    }

    /** Checks that a number of bytes of a buffer view follow the offset that a JSON value has. */
    private void requireWithin(JsonCursor where, JsonCursor view, long bytes) throws IOException {
        long offset = where.unchecked("byteOffset");
        require(offset >= 0 && offset <= buffers.view(view).capacity() - bytes, where,
                "elements within their bufferView");
    }

    private static void require(boolean holds, JsonCursor where, String expected) throws SceneFormatException {
        if (!holds) {
            throw where.wrong(expected);
        }
    }

    private void joinBuffers(GltfModel model) throws IOException {
        int count = root.optional("buffers").map(JsonCursor::size).orElse(0);
        long[] begin = new long[count];
        for (int b = 0; b < count; b++) {
            begin[b] = model.append(buffers.all(b));
        }
        for (JsonNode view : model.json().path("bufferViews")) {
            long offset = view.path("byteOffset").asLong() + begin[view.path("buffer").asInt()];
            ((ObjectNode) view).put("buffer", 0).put("byteOffset", offset);
            if (view.path("extensions").isObject()) { // the bytes without compression are there
                ((ObjectNode) view.get("extensions")).remove(COMPRESSED);
            }
        }
        model.json().remove("buffers");
    }

    private void embedImages(GltfModel model) throws IOException {
        int count = root.optional("images").map(JsonCursor::size).orElse(0);
        for (int i = 0; i < count; i++) {
            Optional<JsonCursor> uri = root.at("images").at(i).optional("uri");
            if (uri.isPresent()) {
                byte[] bytes = buffers.content(uri.get()).orElse(new byte[0]);
                boolean isPng = beginsWith(bytes, PNG);
                if (isPng || beginsWith(bytes, JPEG)) {
                    ObjectNode image = (ObjectNode) model.json().get("images").get(i);
                    image.remove("uri");
                    image.put("mimeType", isPng ? "image/png" : "image/jpeg").put("bufferView", model.add(bytes));
                }
            }
        }
    }

    private static boolean beginsWith(byte[] bytes, byte[] magic) {
        return bytes.length > magic.length && Arrays.equals(Arrays.copyOf(bytes, magic.length), magic);
    }
}
