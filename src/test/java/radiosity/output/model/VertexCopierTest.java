package radiosity.output.model;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.gltf.GltfLists;
import radiosity.gltf.GltfModel;

class VertexCopierTest {

    /** 32 vertices at (i, i). */
    private static GltfModel model() {
        GltfModel model = new GltfModel(JsonNodeFactory.instance.objectNode(), new ArrayList<>(), List.of());
        float[] values = new float[64];
        for (int i = 0; i < values.length; i++) {
            values[i] = i / 2;
        }
        model.accessor(values, 2);
        return model;
    }

    /** Columns of 3 bytes take 4. */
    @Test
    void matrices_areCopiedWithWhatAlignsTheirColumns() {
        GltfModel model = new GltfModel(JsonNodeFactory.instance.objectNode(), new ArrayList<>(), List.of());
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
