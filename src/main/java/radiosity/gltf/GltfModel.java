package radiosity.gltf;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;
import radiosity.scene.Affine;

/**
 * A glTF file in memory, and which triangles of a scene stand where in it.
 *
 * @param json   without "buffers": all buffer views lie in one, whose bytes are the arrays
 * @param arrays bytes, each of which begins at a multiple of 4; not to be modified, but more may be added
 * @param places of all triangles that the scene shows
 */
public record GltfModel(ObjectNode json, List<byte[]> arrays, List<Place> places) {

    /**
     * A primitive of a mesh where a node shows it.
     *
     * @param node      in the file's list
     * @param primitive of its mesh
     * @param instance  where it stands within the node, if the node has instances (EXT_mesh_gpu_instancing)
     * @param vertices  of the primitive, 3 per triangle
     * @param triangles of the scene, 1 per triangle; -1 where the scene has none, as it has no area
     * @param reversed  whether corners 1 and 2 are swapped in the scene
     */
    public record Place(int node, int primitive, Optional<Affine> instance, int[] vertices, int[] triangles,
                        boolean reversed) {

        /** The corner of the scene's triangle that corner k (0, 1 or 2) is. */
        public int corner(int k) {
            return reversed ? (3 - k) % 3 : k;
        }
    }

    /** Adds bytes; returns the number of their buffer view. */
    public int add(byte[] bytes) {
        json.withArrayProperty("bufferViews").addObject().put("buffer", 0).put("byteOffset", length())
                .put("byteLength", bytes.length);
        arrays.add(bytes);
        return json.get("bufferViews").size() - 1;
    }

    /** Adds bytes and an accessor of all of them; returns its number. */
    public int accessor(byte[] bytes, int target, int componentType, int count, String type) {
        return lists().accessor(add(bytes), target, componentType, count, type);
    }

    /** Adds floats and an accessor of all of them; returns its number. */
    public int accessor(float[] values, int components) {
        ByteBuffer bytes = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.asFloatBuffer().put(values);
        return accessor(bytes.array(), GltfLists.VERTICES, GltfLists.FLOAT, values.length / components,
                "VEC" + components);
    }

    public GltfLists lists() {
        return new GltfLists(json);
    }

    /** Bytes of all arrays so far, each padded to a multiple of 4. */
    public long length() {
        return arrays.stream().mapToLong(array -> array.length + 3 & ~3).sum();
    }
}
