package radiosity.output.model;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import java.util.HashMap;
import java.util.Map;
import radiosity.gltf.Glb;
import radiosity.gltf.GltfLists;
import radiosity.gltf.GltfModel;
import radiosity.util.ArraySize;

/**
 * Copies arrays of vertices byte by byte and repeats some vertices. The model's reader has already checked the arrays.
 */
final class VertexCopier {

    private final GltfModel model;
    /** Accessors of copies that were made already. */
    private final Map<Copy, Integer> copies = new HashMap<>();

    /** @param rows of the accessor; two buffers are equal if their numbers are */
    private record Copy(int accessor, IntBuffer rows) { }

    VertexCopier(GltfModel model) {
        this.model = model;
    }

    /**
     * Copies an accessor, unless the same copy exists, and returns the number of the copy.
     *
     * @param rows element of the accessor that each element of the copy repeats; kept, so the caller must not
     *             modify the array
     */
    int copy(int accessor, int[] rows) {
        return copies.computeIfAbsent(new Copy(accessor, IntBuffer.wrap(rows)), c -> made(accessor, rows));
    }

    private int made(int number, int[] rows) {
        JsonNode accessor = list("accessors").get(number);
        int size = GltfLists.elementSize(accessor.get("type").asText(), accessor.get("componentType").asInt());
        byte[] all = elements(accessor, size);
        int step = Glb.padded(size);
        byte[] copied = new byte[ArraySize.of("vertices of a model with a lightmap", step, rows.length)];
        for (int i = 0; i < rows.length; i++) {
            System.arraycopy(all, size * rows[i], copied, step * i, size);
        }
        int view = model.add(copied);
        ObjectNode of = (ObjectNode) list("bufferViews").get(view);
        of.put("target", GltfLists.VERTICES);
        if (step != size) {
            of.put("byteStride", step);
        }
        ObjectNode copy = accessor.deepCopy();
        copy.remove("sparse");
        copy.remove("byteOffset");
        copy.put("bufferView", view).put("count", rows.length);
        list("accessors").add(copy);
        return list("accessors").size() - 1;
    }

    private ArrayNode list(String name) {
        return model.json().withArrayProperty(name);
    }

    /** All elements of an accessor, each of {@code size} bytes, without gaps. */
    private byte[] elements(JsonNode accessor, int size) {
        int count = accessor.get("count").asInt();
        byte[] all = new byte[ArraySize.of("vertices of a model", size, count)];
        if (accessor.hasNonNull("bufferView")) {
            JsonNode view = list("bufferViews").get(accessor.get("bufferView").asInt());
            ByteBuffer from = view(view, accessor.path("byteOffset").asLong());
            int stride = view.path("byteStride").asInt();
            int step = stride > 0 ? stride : size;
            for (int i = 0; i < count; i++) {
                from.get(i * step, all, size * i, size);
            }
        }
        if (accessor.hasNonNull("sparse")) {
            replace(all, accessor.get("sparse"), size);
        }
        return all;
    }

    private void replace(byte[] all, JsonNode sparse, int size) {
        JsonNode indices = sparse.get("indices");
        JsonNode values = sparse.get("values");
        ByteBuffer which = view(list("bufferViews").get(indices.get("bufferView").asInt()),
                indices.path("byteOffset").asLong());
        ByteBuffer by = view(list("bufferViews").get(values.get("bufferView").asInt()),
                values.path("byteOffset").asLong());
        int width = GltfLists.componentSize(indices.get("componentType").asInt());
        for (int i = 0; i < sparse.get("count").asInt(); i++) {
            int at = width == 1 ? which.get(i) & 0xFF : width == 2 ? which.getShort(2 * i) & 0xFFFF
                    : which.getInt(4 * i);
            by.get(i * size, all, size * at, size);
        }
    }

    /** The bytes of the model from an offset in a buffer view on, little endian. */
    private ByteBuffer view(JsonNode view, long offset) {
        long at = view.path("byteOffset").asLong() + offset;
        for (byte[] array : model.arrays()) {
            int padded = Glb.padded(array.length);
            if (at < padded) {
                return ByteBuffer.wrap(array, (int) at, array.length - (int) at).slice().order(ByteOrder.LITTLE_ENDIAN);
            }
            at -= padded;
        }
        throw new IllegalArgumentException("buffer view: expected bytes that there are, got " + view);
    }
}
