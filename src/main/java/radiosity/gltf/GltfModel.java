package radiosity.gltf;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import radiosity.scene.Affine;

/** A glTF file in memory, and where the triangles of a scene stand in it. */
public final class GltfModel {

    private final ObjectNode json;
    private final List<byte[]> arrays = new ArrayList<>();
    private final List<Place> places;
    private long length;

    /**
     * @param json   without "buffers": all buffer views lie in one buffer, which consists of the model's arrays
     * @param places where all triangles of the scene stand; kept, the caller may add more
     */
    public GltfModel(ObjectNode json, List<Place> places) {
        this.json = json;
        this.places = places;
    }

    /**
     * A primitive of a mesh at a node.
     *
     * @param node      index in the file's list of nodes
     * @param primitive index in the node's mesh
     * @param instance  placement within the node, if the node has instances (EXT_mesh_gpu_instancing)
     * @param vertices  of the primitive, 3 per triangle
     * @param triangles index among the scene's triangles, 1 per triangle; -1 if the scene has none, as its area is 0
     * @param reversed  whether corners 1 and 2 are swapped in the scene
     */
    public record Place(int node, int primitive, Optional<Affine> instance, int[] vertices, int[] triangles,
                        boolean reversed) {

        /** The corner of the scene's triangle that corresponds to corner k (0, 1 or 2) of the primitive's triangle. */
        public int corner(int k) {
            return reversed ? (3 - k) % 3 : k;
        }
    }

    /** The file's JSON, which callers modify. */
    public ObjectNode json() {
        return json;
    }

    /** The bytes of the buffer, each array at a multiple of 4 bytes; none is to be modified. */
    public List<byte[]> arrays() {
        return Collections.unmodifiableList(arrays);
    }

    /** Where all triangles of the scene stand. */
    public List<Place> places() {
        return places;
    }

    /** Adds an array of bytes without a buffer view and returns the offset of its first byte in the buffer. */
    public long append(byte[] bytes) {
        long offset = length;
        arrays.add(bytes);
        length += Glb.padded(bytes.length);
        return offset;
    }

    /** Adds an array of bytes and returns the index of its buffer view. */
    public int add(byte[] bytes) {
        json.withArrayProperty("bufferViews").addObject().put("buffer", 0).put("byteOffset", append(bytes))
                .put("byteLength", bytes.length);
        return json.get("bufferViews").size() - 1;
    }

    /** Adds an array of bytes with an accessor of the whole array and returns the accessor's index. */
    public int accessor(byte[] bytes, int target, int componentType, int count, String type) {
        return lists().accessor(add(bytes), target, componentType, count, type);
    }

    /**
     * Adds floats with an accessor of all of them and returns the accessor's index.
     *
     * @param components number of floats per element, 2 to 4; the array is not modified
     */
    public int accessor(float[] values, int components) {
        ByteBuffer bytes = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.asFloatBuffer().put(values);
        return accessor(bytes.array(), GltfLists.VERTICES, GltfLists.FLOAT, values.length / components,
                "VEC" + components);
    }

    public GltfLists lists() {
        return new GltfLists(json);
    }

    /** Length of all arrays so far, each padded to a multiple of 4, bytes. */
    public long length() {
        return length;
    }
}
