package radiosity.output.gltf;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.util.List;
import radiosity.gltf.Glb;
import radiosity.solution.SavedState;

/** Writes the container of a glTF binary: a header, a chunk of JSON, a chunk of arrays (glTF 2.0, section 4). */
public final class GlbWriter {

    /** Largest length of a file, bytes: the container's lengths are unsigned 32-bit numbers. */
    static final long MOST = 0xFFFF_FFFFL;

    private final FileChannel channel;
    private final ByteBuffer buffer = ByteBuffer.allocate(1 << 16).order(ByteOrder.LITTLE_ENDIAN);

    private GlbWriter(FileChannel channel) {
        this.channel = channel;
    }

    /**
     * Length of a file, bytes.
     *
     * @param json bytes of JSON
     * @param bin  bytes of all arrays, each array padded to a multiple of 4
     */
    static long size(long json, long bin) {
        return Glb.HEAD + Glb.CHUNK_HEAD + Glb.padded(json) + (bin > 0 ? Glb.CHUNK_HEAD + bin : 0);
    }

    /** @throws IOException if a file is longer than the largest length, bytes */
    static void check(long size, long most) throws IOException {
        if (size > most) {
            throw new IOException("meshes and textures of " + size + " bytes, which are more than the " + most
                    + " of a glTF binary");
        }
    }

    /**
     * Writes a file.
     *
     * @param json   UTF-8
     * @param arrays float[], int[], short[], byte[] or {@link SavedState}; each begins at a multiple of 4 bytes; not
     *               modified
     * @throws IOException if the file would be longer than {@link #MOST} bytes, before anything is written
     */
    public static void write(FileChannel channel, byte[] json, List<Object> arrays) throws IOException {
        long bin = arrays.stream().mapToLong(a -> Glb.padded(bytes(a))).sum();
        long total = size(json.length, bin);
        check(total, MOST);
        GlbWriter writer = new GlbWriter(channel);
        writer.ints(Glb.MAGIC, Glb.VERSION, (int) total, Glb.padded(json.length), Glb.JSON);
        writer.array(json, (byte) ' ');
        if (bin > 0) {
            writer.ints((int) bin, Glb.BIN);
            for (Object array : arrays) {
                writer.array(array, (byte) 0);
            }
        }
        writer.flush();
    }

    /** Length of an array in the file without padding, bytes. */
    static long bytes(Object array) {
        if (array instanceof float[] floats) {
            return 4L * floats.length;
        }
        if (array instanceof int[] ints) {
            return 4L * ints.length;
        }
        if (array instanceof SavedState state) {
            return state.length();
        }
        return array instanceof short[] shorts ? 2L * shorts.length : ((byte[]) array).length;
    }

    private void ints(int... values) throws IOException {
        for (int value : values) {
            room(4).putInt(value);
        }
    }

    private void array(Object array, byte padding) throws IOException {
        if (array instanceof float[] floats) {
            for (float value : floats) {
                room(4).putFloat(value);
            }
        } else if (array instanceof int[] ints) {
            ints(ints);
        } else if (array instanceof short[] shorts) {
            for (short value : shorts) {
                room(2).putShort(value);
            }
        } else {
            flush();
            OutputStream out = Channels.newOutputStream(channel);
            (array instanceof SavedState state ? state : SavedState.of(List.of((byte[]) array))).writeTo(out);
        }
        for (long rest = Glb.padded(bytes(array)) - bytes(array); rest > 0; rest--) {
            room(1).put(padding);
        }
    }

    private ByteBuffer room(int bytes) throws IOException {
        if (buffer.remaining() < bytes) {
            flush();
        }
        return buffer;
    }

    private void flush() throws IOException {
        buffer.flip();
        while (buffer.hasRemaining()) {
            channel.write(buffer);
        }
        buffer.clear();
    }
}
