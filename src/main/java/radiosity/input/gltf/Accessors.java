package radiosity.input.gltf;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import radiosity.gltf.GltfLists;
import radiosity.gltf.JsonCursor;
import radiosity.input.file.MemoryAdvice;
import radiosity.scene.SceneFormatException;

/** The accessors of a glTF file as arrays of numbers, whatever their component type, stride, or sparseness. */
final class Accessors {

    private static final Map<String, Integer> COMPONENTS = Map.of("SCALAR", 1, "VEC2", 2, "VEC3", 3, "VEC4", 4,
            "MAT4", 16);

    private final JsonCursor root;
    private final Buffers buffers;
    private final Map<Integer, float[]> read = new HashMap<>();
    private long total;

    Accessors(JsonCursor root, Buffers buffers) {
        this.root = root;
        this.buffers = buffers;
    }

    /** Number of elements of an accessor, found without reading the elements. */
    int count(JsonCursor where) throws SceneFormatException {
        return root.at("accessors").at(where.integer()).at("count").integer();
    }

    /** Whether an accessor has elements other than zeros. */
    boolean hasData(JsonCursor where) throws SceneFormatException {
        JsonCursor accessor = root.at("accessors").at(where.integer());
        return accessor.optional("bufferView").isPresent() || accessor.optional("sparse").isPresent();
    }

    /** Type of an accessor's elements, "VEC3" for example. */
    String type(JsonCursor where) throws SceneFormatException {
        return root.at("accessors").at(where.integer()).at("type").text();
    }

    /**
     * The components of an accessor's elements as floats; normalised integers are divided by their largest value.
     *
     * @param where the JSON value that holds the accessor's index
     * @param types the permitted types of elements, "VEC3" for example
     * @return cached, not to be modified
     */
    float[] floats(JsonCursor where, String... types) throws IOException {
        JsonCursor accessor = root.at("accessors").at(where.integer());
        String type = accessor.at("type").text();
        if (!List.of(types).contains(type)) {
            throw accessor.at("type").wrong(String.join(" or ", types));
        }
        float[] known = read.get(where.integer());
        if (known == null) {
            known = read(accessor, COMPONENTS.get(type));
            read.put(where.integer(), known);
        }
        return known;
    }

    /** Counts numbers of 4 bytes before memory for them is allocated; returns their number. */
    private int counted(JsonCursor accessor, long numbers) throws SceneFormatException {
        total += 4 * numbers;
        if (total > Buffers.MOST_BYTES) {
            throw accessor.wrong("arrays of at most " + Buffers.MOST_BYTES + " bytes together (a quarter of the"
                    + " memory; " + MemoryAdvice.forBytes(4 * total) + ")");
        }
        return (int) numbers;
    }

    private float[] read(JsonCursor accessor, int components) throws IOException {
        long length = counted(accessor, (long) accessor.at("count").integer() * components);
        int type = accessor.at("componentType").integer();
        boolean normalised = accessor.isOn("normalized");
        Optional<JsonCursor> view = accessor.optional("bufferView");
        float[] values = new float[0];
        if (view.isPresent()) {
            long offset = accessor.unchecked("byteOffset");
            long stride = root.at("bufferViews").at(view.get().integer()).unchecked("byteStride");
            values = values(accessor, new Elements(buffers.view(view.get()), offset, stride, type, components,
                    normalised), (int) (length / components));
        } else {
            values = new float[(int) length];
        }
        Optional<JsonCursor> sparse = accessor.optional("sparse");
        if (sparse.isPresent()) {
            replace(values, sparse.get(), type, components, normalised);
        }
        return values;
    }

    /**
     * Where the elements of an array lie, and their type.
     *
     * @param stride bytes from one element to the next; 0 where the elements are adjacent
     */
    private record Elements(ByteBuffer bytes, long offset, long stride, int type, int components,
                            boolean normalised) { }

    private static float[] values(JsonCursor where, Elements of, int count) throws SceneFormatException {
        int size = size(where, of.type);
        long step = of.stride == 0 ? (long) size * of.components : of.stride;
        if (of.offset < 0 || of.offset > of.bytes.capacity() || step < (long) size * of.components
                || count > 1 && step > of.bytes.capacity()
                || count > 0 && of.offset + step * (count - 1L) + (long) size * of.components > of.bytes.capacity()) {
            throw where.wrong("elements within " + of.bytes.capacity() + " bytes");
        }
        float[] values = new float[count * of.components];
        for (int i = 0; i < values.length; i++) {
            int at = (int) (of.offset + step * (i / of.components) + (long) size * (i % of.components));
            values[i] = value(of.bytes, at, of.type, of.normalised);
        }
        return values;
    }

    private static int size(JsonCursor where, int type) throws SceneFormatException {
        int size = GltfLists.componentSize(type);
        if (size == 0) {
            throw where.wrong("a componentType from 5120 to 5126");
        }
        return size;
    }

    private static float value(ByteBuffer bytes, int at, int type, boolean normalised) {
        return switch (type) {
            case 5120 -> normalised ? Math.max(bytes.get(at) / 127f, -1) : bytes.get(at);
            case 5121 -> (bytes.get(at) & 0xFF) / (normalised ? 255f : 1);
            case 5122 -> normalised ? Math.max(bytes.getShort(at) / 32767f, -1) : bytes.getShort(at);
            case 5123 -> (bytes.getShort(at) & 0xFFFF) / (normalised ? 65535f : 1);
            case 5125 -> Integer.toUnsignedLong(bytes.getInt(at));
            default -> bytes.getFloat(at);
        };
    }

    /** Overwrites the elements that a sparse accessor replaces. */
    private void replace(float[] values, JsonCursor sparse, int type, int components, boolean normalised)
            throws IOException {
        int[] replaced = replaced(sparse, values.length / components);
        JsonCursor by = sparse.at("values");
        float[] others = values(by, new Elements(buffers.view(by.at("bufferView")),
                by.unchecked("byteOffset"), 0, type, components, normalised), replaced.length);
        for (int i = 0; i < replaced.length; i++) {
            System.arraycopy(others, i * components, values, replaced[i] * components, components);
        }
    }

    /** Vertex indices of a primitive; -1 for values beyond the range of an int. */
    int[] indices(JsonCursor where) throws IOException {
        JsonCursor accessor = root.at("accessors").at(where.integer());
        Optional<JsonCursor> view = accessor.optional("bufferView");
        Optional<JsonCursor> sparse = accessor.optional("sparse");
        int type = accessor.at("componentType").integer();
        if (!accessor.at("type").text().equals("SCALAR")) {
            throw accessor.at("type").wrong("SCALAR");
        }
        int[] indices = view.isPresent() ? indices(accessor, type, buffers.view(view.get()),
                accessor.unchecked("byteOffset"), accessor.at("count").integer()) : zeros(accessor);
        if (sparse.isPresent()) {
            replace(indices, sparse.get(), type);
        }
        return indices;
    }

    /** The indices of an accessor without bytes of its own. */
    private int[] zeros(JsonCursor accessor) throws SceneFormatException {
        return new int[counted(accessor, accessor.at("count").integer())];
    }

    /** Overwrites the indices that a sparse accessor replaces. */
    private void replace(int[] values, JsonCursor sparse, int type) throws IOException {
        int[] replaced = replaced(sparse, values.length);
        JsonCursor by = sparse.at("values");
        int[] others = indices(by, type, buffers.view(by.at("bufferView")), by.unchecked("byteOffset"),
                replaced.length);
        for (int i = 0; i < replaced.length; i++) {
            values[replaced[i]] = others[i];
        }
    }

    /** The elements that a sparse accessor replaces, each below {@code elements}. */
    int[] replaced(JsonCursor sparse, int elements) throws IOException {
        int count = sparse.at("count").integer();
        if (count > elements) {
            throw sparse.wrong("no more elements than there are");
        }
        JsonCursor where = sparse.at("indices");
        int[] replaced = indices(where, where.at("componentType").integer(), buffers.view(where.at("bufferView")),
                where.unchecked("byteOffset"), count);
        for (int at : replaced) {
            if (at < 0 || at >= elements) {
                throw where.wrong("elements that there are");
            }
        }
        return replaced;
    }

    private static int[] indices(JsonCursor where, int type, ByteBuffer bytes, long offset, int count)
            throws SceneFormatException {
        int size = size(where, type);
        if (offset < 0 || offset > bytes.capacity() || offset + (long) size * count > bytes.capacity()) {
            throw where.wrong("indices within " + bytes.capacity() + " bytes");
        }
        if (type == 5126) {
            throw where.wrong("whole numbers");
        }
        int[] indices = new int[count];
        for (int i = 0; i < count; i++) {
            int at = (int) offset + size * i;
            indices[i] = size == 1 ? bytes.get(at) & 0xFF : size == 2 ? bytes.getShort(at) & 0xFFFF
                    : Math.max(-1, bytes.getInt(at));
        }
        return indices;
    }
}
