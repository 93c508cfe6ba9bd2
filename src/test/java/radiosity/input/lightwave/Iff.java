package radiosity.input.lightwave;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/** Writes the bytes of objects, sound or not, for tests. */
final class Iff {

    private Iff() {
    }

    static byte[] join(byte[]... parts) {
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        for (byte[] part : parts) {
            all.writeBytes(part);
        }
        return all.toByteArray();
    }

    /** The file of an object of some type. */
    static byte[] form(String type, byte[]... chunks) {
        return chunk("FORM", text(type), join(chunks));
    }

    static byte[] chunk(String id, byte[]... parts) {
        byte[] content = join(parts);
        return join(text(id), u4(content.length), content, new byte[content.length & 1]);
    }

    /** A chunk with a size of 2 bytes, as surfaces hold them. */
    static byte[] sub(String id, byte[]... parts) {
        byte[] content = join(parts);
        return join(text(id), u2(content.length), content, new byte[content.length & 1]);
    }

    static byte[] text(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }

    static byte[] s0(String text) {
        return join(text(text), new byte[2 - (text.length() & 1)]);
    }

    static byte[] u1(int... values) {
        byte[] bytes = new byte[values.length];
        for (int i = 0; i < values.length; i++) {
            bytes[i] = (byte) values[i];
        }
        return bytes;
    }

    static byte[] u2(int... values) {
        ByteBuffer buffer = ByteBuffer.allocate(2 * values.length);
        for (int v : values) {
            buffer.putShort((short) v);
        }
        return buffer.array();
    }

    static byte[] u4(long... values) {
        ByteBuffer buffer = ByteBuffer.allocate(4 * values.length);
        for (long v : values) {
            buffer.putInt((int) v);
        }
        return buffer.array();
    }

    static byte[] f4(double... values) {
        ByteBuffer buffer = ByteBuffer.allocate(4 * values.length);
        for (double v : values) {
            buffer.putFloat((float) v);
        }
        return buffer.array();
    }

    static byte[] f8(double... values) {
        ByteBuffer buffer = ByteBuffer.allocate(8 * values.length);
        for (double v : values) {
            buffer.putDouble(v);
        }
        return buffer.array();
    }
}
