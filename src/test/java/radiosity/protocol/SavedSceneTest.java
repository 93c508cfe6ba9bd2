package radiosity.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;
import java.util.zip.DeflaterOutputStream;
import org.junit.jupiter.api.Test;

/** The scene at the end of a state: what stands for it is not trusted. */
class SavedSceneTest {

    private int open;

    private InputStream open(byte[] state) {
        open++;
        return new ByteArrayInputStream(state) {
            @Override
            public void close() {
                open--;
            }
        };
    }

    /** A state that ends with a mark after a scene of some number of bytes, of which there are none. */
    private static byte[] state(int bytes, String mark) throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(new DeflaterOutputStream(packed))) {
            out.writeInt(bytes);
        }
        ByteArrayOutputStream state = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(state);
        out.write(packed.toByteArray());
        out.writeInt(packed.size());
        out.writeBytes(mark);
        return state.toByteArray();
    }

    @Test
    void negativeLength_isRefusedInPlainWords() throws IOException {
        byte[] state = state(-7, "SCN1");
        String message = assertThrows(IOException.class, () -> SavedScene.read(() -> open(state), state.length))
                .getMessage();
        assertEquals("saved scene: expected a number of bytes from 0 on, got -7", message);
    }

    @Test
    void streams_areClosed() throws IOException {
        byte[] other = state(0, "SCN2");
        assertEquals(Optional.empty(), SavedScene.read(() -> open(other), other.length));
        byte[] none = state(0, "SCN1");
        assertThrows(IOException.class, () -> SavedScene.read(() -> open(none), none.length));
        assertEquals(0, open);
    }
}
