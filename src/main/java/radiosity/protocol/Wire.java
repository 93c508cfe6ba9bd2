package radiosity.protocol;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutput;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import radiosity.settings.RadiositySettings;

/** Encodes numbers, texts, shots and lists of byte arrays as bytes, and decodes and checks bytes that were received. */
public final class Wire {

    private static final int MOST_CHANNELS = 3 * RadiositySettings.MOST_LAMPS;

    private Wire() { }

    /** Writes a message; {@link #bytes(Writer)} lets it write to memory, which throws no exception of its own. */
    public interface Writer {
        void write(DataOutputStream out) throws IOException;
    }

    public static byte[] bytes(Writer writer) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (DataOutputStream out = new DataOutputStream(bytes)) {
            writer.write(out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    public static byte[] utf8(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    public static String utf8(byte[] bytes) {
        return new String(bytes, StandardCharsets.UTF_8);
    }

    public static DataInputStream input(byte[] bytes) {
        return new DataInputStream(new ByteArrayInputStream(bytes));
    }

    public static void write(List<Shot> shots, int channels, DataOutput out) throws IOException {
        out.writeInt(channels);
        out.writeInt(shots.size());
        for (Shot shot : shots) {
            shot.write(channels, out);
        }
    }

    /** @throws EOFException where fewer bytes are available; thrown before memory for the bytes is allocated */
    public static byte[] exactly(DataInputStream in, long count) throws IOException {
        if (count > in.available()) {
            throw new EOFException("message: expected " + count + " bytes, got " + in.available());
        }
        byte[] bytes = new byte[(int) count];
        in.readFully(bytes);
        return bytes;
    }

    /** Writes the number of bytes, then the bytes. */
    public static void write(DataOutputStream out, byte[] bytes) throws IOException {
        out.writeInt(bytes.length);
        out.write(bytes);
    }

    public static void write(DataOutputStream out, List<byte[]> all) throws IOException {
        for (byte[] bytes : all) {
            write(out, bytes);
        }
    }

    /** Reads a number of bytes, then the bytes, as {@link #write(DataOutputStream, byte[])} wrote them. */
    public static byte[] bytes(DataInputStream in) throws IOException {
        return exactly(in, count(in, 1));
    }

    /** Writes the number of values, then the values. */
    static void writeDoubles(DataOutputStream out, double[] values) throws IOException {
        out.writeInt(values.length);
        for (double value : values) {
            out.writeDouble(value);
        }
    }

    /** Reads a number of values, then the values, as {@link #writeDoubles} wrote them. */
    static double[] readDoubles(DataInputStream in) throws IOException {
        double[] values = new double[count(in, Double.BYTES)];
        for (int i = 0; i < values.length; i++) {
            values[i] = in.readDouble();
        }
        return values;
    }

    /** Writes the number of marks, then the marks. */
    static void writeMarks(DataOutputStream out, List<Mark> marks) throws IOException {
        out.writeInt(marks.size());
        for (Mark mark : marks) {
            out.writeInt(mark.face());
            out.writeLong(mark.path());
        }
    }

    /** Reads a number of marks, then the marks, as {@link #writeMarks} wrote them. */
    static List<Mark> readMarks(DataInputStream in) throws IOException {
        int count = count(in, Integer.BYTES + Long.BYTES);
        List<Mark> marks = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            marks.add(new Mark(in.readInt(), in.readLong()));
        }
        return marks;
    }

    /** Decodes a message that consists of byte arrays with the number of bytes in front of each. */
    public static List<byte[]> list(byte[] message) throws IOException {
        List<byte[]> all = new ArrayList<>();
        for (DataInputStream in = input(message); in.available() > 0;) {
            all.add(bytes(in));
        }
        return all;
    }

    /**
     * Reads the number of items that follow, and checks it before memory for the items is allocated.
     *
     * @param size least number of bytes of one item
     * @throws IOException where the number is negative, or the bytes available are too few for this number of items
     */
    public static int count(DataInputStream in, int size) throws IOException {
        int count = in.readInt();
        if (count < 0 || (long) count * size > in.available()) {
            throw new IOException("message: expected " + count + " times " + size + " bytes, got " + in.available());
        }
        return count;
    }

    /** Reads shots; fails where one has no radiosities. */
    public static List<Shot> shots(DataInputStream in) throws IOException {
        List<Shot> shots = trees(in);
        for (Shot shot : shots) {
            if (!shot.isWhole()) {
                throw new IOException("shot: expected radiosities, got none");
            }
        }
        return shots;
    }

    /** Reads shots with or without radiosities. */
    public static List<Shot> trees(DataInputStream in) throws IOException {
        int channels = in.readInt();
        if (channels < 0 || channels > MOST_CHANNELS) {
            throw new IOException("message: expected up to " + MOST_CHANNELS + " channels, got " + channels);
        }
        List<Shot> shots = new ArrayList<>();
        for (int n = count(in, Shot.LEAST_BYTES); n > 0; n--) {
            shots.add(Shot.read(in, channels));
        }
        return shots;
    }
}
