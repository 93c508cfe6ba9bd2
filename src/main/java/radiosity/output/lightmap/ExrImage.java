package radiosity.output.lightmap;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.Deflater;
import radiosity.output.image.Picture;

/**
 * Writes pictures as OpenEXR of three channels of half floats, in scanlines, compressed by ZIP (Industrial Light &amp;
 * Magic, OpenEXR File Layout).
 */
public final class ExrImage {

    private static final int MAGIC = 20000630;
    private static final int VERSION = 2;
    private static final int HALF = 1;
    private static final byte ZIP = 3;
    /** Number of rows in a block, which is compressed as a whole. */
    private static final int ROWS = 16;
    /** Channels of a picture in the file's order, which is alphabetical: blue, green, red. */
    private static final int[] CHANNELS = {2, 1, 0};
    /** The largest half float. */
    private static final float LARGEST = 65504;

    private ExrImage() {
    }

    /**
     * Encodes a picture as the bytes of an OpenEXR file.
     *
     * @param scale factor for every value; the products are clamped to [0, 65504]
     */
    public static byte[] of(Picture picture, double scale) {
        byte[] header = header(picture.width(), picture.height());
        List<byte[]> blocks = new ArrayList<>();
        for (int y = 0; y < picture.height(); y += ROWS) {
            blocks.add(block(picture, y, Math.min(ROWS, picture.height() - y), scale));
        }
        int length = blocks.stream().mapToInt(block -> 8 + block.length).sum();
        ByteBuffer file = buffer(header.length + 8 * blocks.size() + length).put(header);
        long at = header.length + 8L * blocks.size();
        for (byte[] block : blocks) {
            file.putLong(at);
            at += 8 + block.length;
        }
        for (int b = 0; b < blocks.size(); b++) {
            file.putInt(b * ROWS).putInt(blocks.get(b).length).put(blocks.get(b));
        }
        return file.array();
    }

    private static ByteBuffer buffer(int bytes) {
        return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static byte[] header(int width, int height) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(buffer(8).putInt(MAGIC).putInt(VERSION).array());
        ByteBuffer channels = buffer(3 * 18 + 1);
        for (String name : List.of("B", "G", "R")) {
            channels.put(text(name)).putInt(HALF).putInt(0).putInt(1).putInt(1);
        }
        attribute(out, "channels", "chlist", channels.array());
        attribute(out, "compression", "compression", new byte[] {ZIP});
        byte[] window = buffer(16).putInt(0).putInt(0).putInt(width - 1).putInt(height - 1).array();
        attribute(out, "dataWindow", "box2i", window);
        attribute(out, "displayWindow", "box2i", window);
        attribute(out, "lineOrder", "lineOrder", new byte[1]);
        attribute(out, "pixelAspectRatio", "float", buffer(4).putFloat(1).array());
        attribute(out, "screenWindowCenter", "v2f", new byte[8]);
        attribute(out, "screenWindowWidth", "float", buffer(4).putFloat(1).array());
        out.write(0);
        return out.toByteArray();
    }

    private static byte[] text(String text) {
        return (text + "\0").getBytes(StandardCharsets.US_ASCII);
    }

    private static void attribute(ByteArrayOutputStream out, String name, String type, byte[] value) {
        out.writeBytes(text(name));
        out.writeBytes(text(type));
        out.writeBytes(buffer(4).putInt(value.length).array());
        out.writeBytes(value);
    }

    /** Encodes the rows of a block, in each row one channel after the other; compressed where that is shorter. */
    private static byte[] block(Picture picture, int top, int rows, double scale) {
        ByteBuffer raw = buffer(rows * picture.width() * 6);
        for (int y = top; y < top + rows; y++) {
            for (int channel : CHANNELS) {
                for (int x = 0; x < picture.width(); x++) {
                    raw.putShort(half((float) (scale * picture.rgb()[3 * (y * picture.width() + x) + channel])));
                }
            }
        }
        byte[] compressed = compressed(reordered(raw.array()));
        return compressed.length < raw.capacity() ? compressed : raw.array();
    }

    /** Reorders bytes for compression: all lower bytes, then all upper bytes, each as the difference from the last. */
    private static byte[] reordered(byte[] raw) {
        byte[] bytes = new byte[raw.length];
        int half = (raw.length + 1) / 2;
        for (int i = 0; i < raw.length; i++) {
            bytes[i % 2 == 0 ? i / 2 : half + i / 2] = raw[i];
        }
        for (int i = bytes.length - 1; i > 0; i--) {
            bytes[i] = (byte) (bytes[i] - bytes[i - 1] + 128);
        }
        return bytes;
    }

    private static byte[] compressed(byte[] bytes) {
        Deflater deflater = new Deflater();
        deflater.setInput(bytes);
        deflater.finish();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        byte[] piece = new byte[1 << 14];
        while (!deflater.finished()) {
            out.write(piece, 0, deflater.deflate(piece));
        }
        deflater.end();
        return out.toByteArray();
    }

    /** The half float (IEEE 754 binary16) nearest to a number that is first clamped to [0, {@value #LARGEST}]. */
    static short half(float value) {
        float x = Math.max(0, Math.min(LARGEST, value));
        int bits = Float.floatToIntBits(x);
        int exponent = (bits >> 23) - 112;
        if (exponent <= 0) {
            return (short) Math.rint(x * 0x1p24f);
        }
        return (short) ((exponent << 10) + (bits >> 13 & 0x3FF) + roundsUp(bits));
    }

    /** 1 if the bits cut off are more than half of the last digit kept, or half of an odd last digit; else 0. */
    private static int roundsUp(int bits) {
        int rest = bits & 0x1FFF;
        return rest > 0x1000 || rest == 0x1000 && (bits & 0x2000) != 0 ? 1 : 0;
    }
}
