package radiosity.input.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import radiosity.gltf.GltfModel;
import radiosity.gltf.JsonCursor;
import radiosity.scene.Affine;
import radiosity.scene.Scene;

/** Makes a model of a glTF file with embedded buffers and images, and finds which of its triangles are in the scene. */
final class OriginalModel {

    private static final byte[] PNG = {(byte) 0x89, 'P', 'N', 'G'};
    private static final byte[] JPEG = {(byte) 0xFF, (byte) 0xD8, (byte) 0xFF};

    private final JsonCursor root;
    private final Buffers buffers;
    private final Meshes meshes;
    /** The first triangle of the scene that has not been matched with a triangle of the file. */
    private int next;

    OriginalModel(JsonCursor root, Buffers buffers, Meshes meshes) {
        this.root = root;
        this.buffers = buffers;
        this.meshes = meshes;
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
        ObjectNode json = root.node().deepCopy();
        GltfModel model = new GltfModel(json, new ArrayList<>(), places);
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

    private void joinBuffers(GltfModel model) throws IOException {
        int count = root.optional("buffers").map(JsonCursor::size).orElse(0);
        long[] begin = new long[count];
        for (int b = 0; b < count; b++) {
            begin[b] = model.length();
            model.arrays().add(buffers.all(b));
        }
        for (JsonNode view : model.json().path("bufferViews")) {
            long offset = view.path("byteOffset").asLong() + begin[view.path("buffer").asInt()];
            ((ObjectNode) view).put("buffer", 0).put("byteOffset", offset);
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
