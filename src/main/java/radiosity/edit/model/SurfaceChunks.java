package radiosity.edit.model;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import radiosity.scene.Rgb;

/** Paints a surface of a LightWave object (LWO2); all other bytes stay the same. */
final class SurfaceChunks {

    private static final int HEAD = 8;
    private static final int SUB_HEAD = 6;
    private static final int COLOUR = 12;
    private static final int DIFFUSE = 4;

    private SurfaceChunks() { }

    /**
     * Returns the object with another colour of a surface, and with its diffuse level set to 1; neither is animated.
     *
     * @param object not modified
     * @param name   name of the surface; an object without this surface is returned unchanged
     * @param colour colour as the file holds it
     * @throws IllegalArgumentException where the object is not of format LWO2
     */
    static byte[] painted(byte[] object, String name, Rgb colour) {
        if (object.length < HEAD + 4 || !id(object, 0).equals("FORM") || !id(object, HEAD).equals("LWO2")) {
            throw new IllegalArgumentException("expected an object of LWO2 to paint, got another format");
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(object, 0, HEAD + 4);
        int at = HEAD + 4;
        while (at + HEAD <= object.length) {
            long size = ByteBuffer.wrap(object, at + 4, 4).getInt() & 0xffffffffL;
            int end = (int) Math.min(object.length, at + HEAD + size + (size & 1));
            int from = at + HEAD;
            if (id(object, at).equals("SURF") && text(object, from, end).equals(name)) {
                int data = skipText(object, skipText(object, from, end), end);
                byte[] surface = painted(object, data, (int) Math.min(end, from + size), colour);
                int length = data - from + surface.length;
                out.write(object, at, 4);
                out.writeBytes(ByteBuffer.allocate(4).putInt(length).array());
                out.write(object, from, data - from);
                out.writeBytes(surface);
                if ((length & 1) == 1) {
                    out.write(0);
                }
            } else {
                out.write(object, at, end - at);
            }
            at = end;
        }
        out.write(object, at, object.length - at);
        byte[] whole = out.toByteArray();
        int form = ByteBuffer.wrap(object, 4, 4).getInt();
        ByteBuffer.wrap(whole).putInt(4, form + whole.length - object.length);
        return whole;
    }

    /** Returns a surface's subchunks, which lie between two bytes of an object, painted; appends the missing ones. */
    private static byte[] painted(byte[] object, int from, int to, Rgb colour) {
        byte[] values = Arrays.copyOfRange(object, from, to);
        boolean hasColour = false;
        boolean hasDiffuse = false;
        int at = 0;
        while (at + SUB_HEAD <= values.length) {
            int size = ByteBuffer.wrap(values, at + 4, 2).getShort() & 0xffff;
            if (id(values, at).equals("COLR") && size >= COLOUR) {
                put(colour(colour), values, at + SUB_HEAD, size);
                hasColour = true;
            } else if (id(values, at).equals("DIFF") && size >= DIFFUSE) {
                put(ByteBuffer.allocate(DIFFUSE).putFloat(1).array(), values, at + SUB_HEAD, size);
                hasDiffuse = true;
            }
            at += SUB_HEAD + size + (size & 1);
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(values);
        if (!hasColour) {
            add(out, "COLR", colour(colour));
        }
        if (!hasDiffuse) {
            add(out, "DIFF", ByteBuffer.allocate(DIFFUSE).putFloat(1).array());
        }
        return out.toByteArray();
    }

    /** Replaces the data of a subchunk by a value and the index 0, which stands for no envelope. */
    private static void put(byte[] value, byte[] values, int from, int size) {
        Arrays.fill(values, from, from + size, (byte) 0);
        System.arraycopy(value, 0, values, from, value.length);
    }

    private static byte[] colour(Rgb colour) {
        return ByteBuffer.allocate(COLOUR).putFloat((float) colour.r()).putFloat((float) colour.g())
                .putFloat((float) colour.b()).array();
    }

    /** Appends a subchunk with a value and without an envelope. */
    private static void add(ByteArrayOutputStream out, String id, byte[] value) {
        out.writeBytes(id.getBytes(StandardCharsets.ISO_8859_1));
        out.writeBytes(ByteBuffer.allocate(2).putShort((short) (value.length + 2)).array());
        out.writeBytes(value);
        out.writeBytes(new byte[2]);
    }

    private static String id(byte[] bytes, int at) {
        return new String(bytes, at, 4, StandardCharsets.ISO_8859_1);
    }

    private static String text(byte[] bytes, int from, int end) {
        int to = from;
        while (to < end && bytes[to] != 0) {
            to++;
        }
        return new String(bytes, from, to - from, StandardCharsets.ISO_8859_1);
    }

    /** Returns the position after a text, its terminating zero, and the zero that pads it to an even length. */
    private static int skipText(byte[] bytes, int from, int end) {
        int length = text(bytes, from, end).length() + 1;
        return Math.min(end, from + length + (length & 1));
    }
}
