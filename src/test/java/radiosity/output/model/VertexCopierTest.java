package radiosity.output.model;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.gltf.GltfLists;
import radiosity.gltf.GltfModel;
import radiosity.util.TooLargeException;

class VertexCopierTest {

    /** 32 vertices at (i, i). */
    private static GltfModel model() {
        GltfModel model = new GltfModel(JsonNodeFactory.instance.objectNode(), List.of());
        float[] values = new float[64];
        for (int i = 0; i < values.length; i++) {
            values[i] = i / 2;
        }
        model.accessor(values, 2);
        return model;
    }

    /** 3 bytes take 4. */
    @Test
    void arrays_beginAtMultiplesOf4() {
        GltfModel model = new GltfModel(JsonNodeFactory.instance.objectNode(), List.of());
        assertEquals(0, model.append(new byte[3]));
        int view = model.add(new byte[5]);
        assertEquals(4, model.json().get("bufferViews").get(view).get("byteOffset").asInt());
        assertEquals(12, model.length());
    }

    /** Columns of 3 bytes take 4. */
    @Test
    void matrices_areCopiedWithWhatAlignsTheirColumns() {
        GltfModel model = new GltfModel(JsonNodeFactory.instance.objectNode(), List.of());
        byte[] bytes = new byte[24];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) i;
        }
        int view = model.add(bytes);
        int matrices = model.lists().accessor(view, GltfLists.VERTICES, 5121, 2, "MAT3");
        new VertexCopier(model).copy(matrices, new int[] {1, 0, 1});
        byte[] copied = model.arrays().get(1);
        assertEquals(36, copied.length);
        assertEquals(List.of(12, 23, 0, 11, 12, 23), List.of((int) copied[0], (int) copied[11], (int) copied[12],
                (int) copied[23], (int) copied[24], (int) copied[35]));
        assertEquals(0, GltfLists.elementSize("MAT5", 5126));
        assertEquals(64, GltfLists.elementSize("MAT4", 5126));
    }

    /** Of the vertices at (0, 0) to (31, 31), as the reader takes them. */
    @Test
    void stride0_isThatOfAdjacentElements() {
        GltfModel model = model();
        model.lists().get("bufferViews", 0).put("byteStride", 0);
        new VertexCopier(model).copy(0, new int[] {31, 2});
        ByteBuffer copied = ByteBuffer.wrap(model.arrays().get(1)).order(ByteOrder.LITTLE_ENDIAN);
        assertEquals(31, copied.getFloat(0));
        assertEquals(2, copied.getFloat(8));
    }

    /** 2^30 vertices of 16 bytes, which are 2^34 bytes and as an int 0. */
    @Test
    void moreBytesThanAnArrayHolds_areRefused() {
        GltfModel model = model();
        model.lists().list("accessors").addObject().put("componentType", GltfLists.FLOAT).put("count", 1 << 30)
                .put("type", "VEC4");
        String message = assertThrows(TooLargeException.class,
                () -> new VertexCopier(model).copy(1, new int[] {0})).getMessage();
        assertTrue(message.contains("got 17,179,869,184"), message);
    }

    @Test
    void equalRows_shareACopy() {
        VertexCopier copier = new VertexCopier(model());
        assertEquals(copier.copy(0, new int[] {0, 31}), copier.copy(0, new int[] {0, 31}));
    }

    @Test
    void rowsOfEqualHash_haveCopiesOfTheirOwn() {
        int[] rows = {0, 31};
        int[] others = {1, 0};
        assertEquals(Arrays.hashCode(rows), Arrays.hashCode(others));
        GltfModel model = model();
        VertexCopier copier = new VertexCopier(model);
        assertNotEquals(copier.copy(0, rows), copier.copy(0, others));
        float[] copied = new float[4];
        ByteBuffer.wrap(model.arrays().get(2)).order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer().get(copied);
        assertArrayEquals(new float[] {1, 1, 0, 0}, copied);
    }
}
