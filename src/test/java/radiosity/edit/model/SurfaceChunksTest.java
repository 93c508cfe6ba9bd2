package radiosity.edit.model;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import radiosity.scene.Rgb;

class SurfaceChunksTest {

    private static byte[] chunk(String id, boolean isSub, byte[]... parts) {
        ByteArrayOutputStream data = new ByteArrayOutputStream();
        for (byte[] part : parts) {
            data.writeBytes(part);
        }
        ByteBuffer chunk = ByteBuffer.allocate((isSub ? 6 : 8) + data.size()).put(text(id));
        return (isSub ? chunk.putShort((short) data.size()) : chunk.putInt(data.size())).put(data.toByteArray())
                .array();
    }

    private static byte[] text(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }

    /** @param colourEnvelope, diffuseEnvelope indices of the envelopes, of 2 or 4 bytes */
    private static byte[] object(Rgb colour, double diffuse, byte[] colourEnvelope, byte[] diffuseEnvelope) {
        byte[] channels = ByteBuffer.allocate(12).putFloat((float) colour.r()).putFloat((float) colour.g())
                .putFloat((float) colour.b()).array();
        return chunk("FORM", false, text("LWO2"), chunk("SURF", false, text("wall\0\0\0"), new byte[1],
                chunk("COLR", true, channels, colourEnvelope),
                chunk("DIFF", true, ByteBuffer.allocate(4).putFloat((float) diffuse).array(), diffuseEnvelope)));
    }

    /** LightWave would show the envelope's colour and not the painted one. */
    @Test
    void paintedSurface_isNoLongerAnimated() {
        byte[] animated = object(new Rgb(.1, .2, .3), .5, new byte[] {0, 1}, new byte[] {-1, 0, 0, 2});
        assertArrayEquals(object(new Rgb(.6, .5, .4), 1, new byte[2], new byte[4]),
                SurfaceChunks.painted(animated, "wall", new Rgb(.6, .5, .4)));
    }
}
