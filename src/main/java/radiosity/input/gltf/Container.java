package radiosity.input.gltf;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import radiosity.gltf.Glb;
import radiosity.gltf.JsonCursor;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.MemoryAdvice;
import radiosity.scene.SceneFormatException;

/**
 * The two parts of a glTF file: its JSON and, in a binary file, the bytes of its chunk BIN.
 *
 * @param root  the whole JSON
 * @param bytes the chunk BIN, little endian; empty where there is none
 */
record Container(JsonCursor root, Optional<ByteBuffer> bytes) {

    /** Heap bytes required per token of JSON; on average a value that was read takes less than an eighth of these. */
    private static final int BYTES_PER_VALUE = 1024;

    private static final JsonFactory FACTORY = JsonFactory.builder().streamReadConstraints(
            StreamReadConstraints.builder().maxStringLength(Integer.MAX_VALUE).maxNestingDepth(100).build()).build();

    /**
     * Splits a file into its parts.
     *
     * @param file the whole file; not copied
     * @throws SceneFormatException where the file is incomplete, not glTF 2.0, or a scene file of this program
     */
    static Container of(byte[] file, String name, Diagnostics notes) throws SceneFormatException {
        ByteBuffer all = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
        boolean binary = file.length >= 4 && all.getInt(0) == Glb.MAGIC;
        Container container = binary ? binary(all, name, notes)
                : new Container(new JsonCursor(name, parse(file, 0, file.length, notes)), Optional.empty());
        container.checkVersion();
        return container;
    }

    private static Container binary(ByteBuffer all, String name, Diagnostics notes) throws SceneFormatException {
        if (all.capacity() < Glb.HEAD + 8) {
            throw notes.error("", "a glTF binary", all.capacity() + " bytes");
        }
        if (all.getInt(4) != Glb.VERSION) {
            throw notes.error("byte 4", "glTF version 2", Integer.toUnsignedString(all.getInt(4)));
        }
        long length = Integer.toUnsignedLong(all.getInt(8));
        if (length > all.capacity()) {
            throw notes.error("byte 8", length + " bytes as the header says", all.capacity() + " bytes");
        }
        int json = chunk(all, Glb.HEAD, (int) length, notes);
        if (all.getInt(Glb.HEAD + 4) != Glb.JSON) {
            throw notes.error("byte " + Glb.HEAD, "a chunk JSON", "another one");
        }
        JsonCursor root = new JsonCursor(name, parse(all.array(), Glb.HEAD + 8, json, notes));
        int next = Glb.HEAD + 8 + json;
        if (next + 8 > length) {
            return new Container(root, Optional.empty());
        }
        int bytes = chunk(all, next, (int) length, notes);
        return new Container(root, all.getInt(next + 4) != Glb.BIN ? Optional.empty()
                : Optional.of(all.slice(next + 8, bytes).order(ByteOrder.LITTLE_ENDIAN)));
    }

    /** The length of a chunk's content, which is checked to end before {@code end}. */
    private static int chunk(ByteBuffer all, int at, int end, Diagnostics notes) throws SceneFormatException {
        long length = Integer.toUnsignedLong(all.getInt(at));
        if (length > end - at - 8L) {
            throw notes.error("byte " + at, "a chunk of at most " + (end - at - 8L) + " bytes", length + " bytes");
        }
        return (int) length;
    }

    /** Counts the tokens before the JSON is read, as the tree takes far more memory than the text. */
    private static JsonNode parse(byte[] file, int from, int length, Diagnostics notes) throws SceneFormatException {
        long most = Runtime.getRuntime().maxMemory() / BYTES_PER_VALUE;
        int start = length >= 3 && file[from] == (byte) 0xEF && file[from + 1] == (byte) 0xBB ? 3 : 0;
        try {
            long count = 0;
            try (JsonParser parser = FACTORY.createParser(file, from + start, length - start)) {
                while (parser.nextToken() != null) {
                    if (++count > most) {
                        throw notes.error("JSON", "at most " + most + " values (" + MemoryAdvice.forBytes(0) + ")",
                                "more");
                    }
                }
            }
            return new ObjectMapper(FACTORY).readTree(file, from + start, length - start);
        } catch (JsonProcessingException e) {
            String place = e.getLocation() == null ? "JSON" : "JSON, byte " + e.getLocation().getByteOffset();
            throw notes.error(place, "JSON", JsonCursor.reason(e));
        } catch (SceneFormatException e) {
            throw e;
        } catch (IOException e) {
            throw notes.error("JSON", "JSON", String.valueOf(e.getMessage()));
        }
    }

    private void checkVersion() throws SceneFormatException {
        JsonCursor asset = root.at("asset");
        if (!asset.at("version").text().startsWith("2.")) {
            throw asset.at("version").wrong("glTF version 2.0");
        }
        if (!asset.text("minVersion", "2.0").equals("2.0")) {
            throw asset.at("minVersion").wrong("glTF version 2.0");
        }
        if (asset.optional("extras").flatMap(extras -> extras.optional("radiosity")).isPresent()) {
            throw new SceneFormatException(root.file(), "", "a scene without light",
                    "a scene file of this program; give what it was made from");
        }
    }
}
