package radiosity.input.gltf;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;

/** Builds the text of small glTF files: arrays become accessors of one buffer in a data URI. */
final class Model {

    /** A square of side 1 from the origin, its corners counter-clockwise seen from +z. */
    static final float[] SQUARE = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

    private final ByteArrayOutputStream buffer = new ByteArrayOutputStream();
    private final List<String> views = new ArrayList<>();
    private final List<String> accessors = new ArrayList<>();

    /** Adds bytes; returns the number of their view. */
    int view(byte[] bytes, int stride) {
        views.add("{\"buffer\":0,\"byteOffset\":" + buffer.size() + ",\"byteLength\":" + bytes.length
                + (stride > 0 ? ",\"byteStride\":" + stride : "") + "}");
        buffer.writeBytes(bytes);
        buffer.writeBytes(new byte[3 & -bytes.length]);
        return views.size() - 1;
    }

    int view(float... values) {
        return view(bytes(values), 0);
    }

    static byte[] bytes(float... values) {
        ByteBuffer bytes = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.asFloatBuffer().put(values);
        return bytes.array();
    }

    static byte[] shorts(int... values) {
        ByteBuffer bytes = ByteBuffer.allocate(2 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int value : values) {
            bytes.putShort((short) value);
        }
        return bytes.array();
    }

    /** Adds an accessor; returns its number. */
    int accessor(String type, int componentType, int count, String more) {
        accessors.add("{\"type\":\"" + type + "\",\"componentType\":" + componentType + ",\"count\":" + count + more
                + "}");
        return accessors.size() - 1;
    }

    int floats(String type, float... values) {
        int components = type.equals("SCALAR") ? 1 : type.equals("MAT4") ? 16 : type.charAt(3) - '0';
        return accessor(type, 5126, values.length / components, ",\"bufferView\":" + view(values));
    }

    int indices(int... values) {
        return accessor("SCALAR", 5123, values.length, ",\"bufferView\":" + view(shorts(values), 0));
    }

    /** The file: everything else than its arrays stands in the parts, as JSON. */
    String text(String... parts) {
        return "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":" + buffer.size()
                + ",\"uri\":\"data:application/octet-stream;base64,"
                + Base64.getEncoder().encodeToString(buffer.toByteArray()) + "\"}],\"bufferViews\":["
                + String.join(",", views) + "],\"accessors\":[" + String.join(",", accessors) + "],"
                + String.join(",", parts).replace('\'', '"') + "}";
    }

    /** One node with one mesh of one primitive. */
    String one(String attributes, String primitive, String node, String materials) {
        return text("'scene':0,'scenes':[{'nodes':[0]}]", "'nodes':[{'name':'n','mesh':0" + node + "}]",
                "'meshes':[{'name':'m','primitives':[{'attributes':{" + attributes + "}" + primitive + "}]}]",
                "'materials':[" + materials + "]");
    }
}
