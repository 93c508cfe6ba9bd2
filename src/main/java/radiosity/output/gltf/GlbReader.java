package radiosity.output.gltf;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import radiosity.gltf.Glb;
import radiosity.gltf.JsonCursor;
import radiosity.input.file.FileSniffer;
import radiosity.scene.SceneFormatException;
import radiosity.solution.SavedState;

/** Reads the container of a glTF binary. Lengths are checked before memory is taken for the content. */
final class GlbReader implements Closeable {

    private static final ObjectMapper JSON = new ObjectMapper();

    final String name;
    final JsonNode json;
    private final FileChannel channel;
    /** Position of the first array in the file and length of all arrays, bytes. */
    private final long binStart;
    private final long binLength;

    GlbReader(Path file) throws IOException {
        name = file.toString();
        channel = FileChannel.open(file, StandardOpenOption.READ);
        try {
            ByteBuffer header = header();
            int jsonLength = (int) chunk(header, 12, Glb.JSON, "JSON");
            json = parse(read(20, jsonLength));
            long next = 20L + jsonLength;
            boolean hasBin = next < channel.size();
            binStart = next + 8;
            binLength = hasBin ? chunk(read(next, 8), next, Glb.BIN, "BIN") : 0;
        } catch (IOException | RuntimeException e) {
            channel.close();
            throw e;
        }
    }

    private ByteBuffer header() throws IOException {
        long size = channel.size();
        if (size < 20) {
            throw wrong("", "a scene file", size + " bytes");
        }
        ByteBuffer header = read(0, 20);
        if (header.getInt(0) != Glb.MAGIC) {
            throw wrong("", "a scene file that RadiosityRenderer wrote", FileSniffer.describe(start(), name));
        }
        if (header.getInt(4) != Glb.VERSION) {
            throw wrong("byte 4", "glTF version 2", Integer.toUnsignedString(header.getInt(4)));
        }
        long length = Integer.toUnsignedLong(header.getInt(8));
        if (length != size) {
            throw wrong("", length + " bytes as its header says", size + " bytes");
        }
        return header.position(12).slice().order(ByteOrder.LITTLE_ENDIAN);
    }

    private byte[] start() throws IOException {
        return read(0, (int) Math.min(FileSniffer.START, channel.size())).array();
    }

    /**
     * Checks the head of a chunk and returns the length of its content in bytes.
     *
     * @param head first 8 bytes of the chunk
     * @param at   position of the chunk in the file, bytes
     * @param type the only one that is allowed
     */
    private long chunk(ByteBuffer head, long at, int type, String what) throws IOException {
        long length = Integer.toUnsignedLong(head.getInt(0));
        long rest = channel.size() - at - 8;
        if (head.getInt(4) != type || length > rest || type == Glb.JSON && length > Integer.MAX_VALUE) {
            throw wrong("byte " + at, "a chunk " + what + " of at most " + rest + " bytes",
                    "type " + Integer.toHexString(head.getInt(4)) + " of " + length + " bytes");
        }
        return length;
    }

    private JsonNode parse(ByteBuffer text) throws SceneFormatException {
        try {
            return JSON.readTree(text.array());
        } catch (JsonProcessingException e) {
            throw wrong("chunk JSON", "JSON", JsonCursor.reason(e));
        } catch (IOException e) {
            throw wrong("chunk JSON", "JSON", String.valueOf(e.getMessage()));
        }
    }

    /** Reads bytes of the file from position {@code at} on, little endian. */
    private ByteBuffer read(long at, int length) throws IOException {
        if (at + length > channel.size()) {
            throw wrong("byte " + at, length + " bytes", channel.size() - at + " bytes");
        }
        ByteBuffer buffer = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
        while (buffer.hasRemaining()) {
            if (channel.read(buffer, at + buffer.position()) < 0) {
                throw wrong("", "the file that was opened", "a shorter one");
            }
        }
        return buffer.flip();
    }

    /** Reads a buffer view that fits into one array, little endian. */
    ByteBuffer view(int index) throws IOException {
        Range range = range(index);
        if (range.length > Integer.MAX_VALUE - 8) {
            throw wrong("bufferView " + index, "at most " + (Integer.MAX_VALUE - 8) + " bytes", range.length
                    + " bytes");
        }
        return read(range.start, (int) range.length);
    }

    /** Reads a state from a buffer view of any length, in pieces; for one thread at a time. */
    SavedState state(int index) throws IOException {
        Range range = range(index);
        return SavedState.read(Channels.newInputStream(channel.position(range.start)), range.length);
    }

    /**
     * Position of a buffer view.
     *
     * @param start  bytes from the beginning of the file
     * @param length bytes, all of them in the file
     */
    private record Range(long start, long length) { }

    private Range range(int index) throws IOException {
        JsonCursor view = new JsonCursor(name, json).at("bufferViews").at(index);
        long offset = view.unchecked("byteOffset");
        long length = view.at("byteLength").unchecked();
        if (offset < 0 || length < 0 || offset > binLength - length) {
            throw wrong("bufferView " + index, "bytes below " + binLength, length + " bytes from " + offset);
        }
        return new Range(binStart + offset, length);
    }

    SceneFormatException wrong(String place, String expected, String got) {
        return new SceneFormatException(name, place, expected, got);
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
