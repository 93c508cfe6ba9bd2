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
