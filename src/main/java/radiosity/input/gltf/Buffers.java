package radiosity.input.gltf;

import java.io.IOException;
import java.net.URLDecoder;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Base64;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import radiosity.gltf.JsonCursor;
import radiosity.input.file.FileSearch;
import radiosity.input.file.InputFile;
import radiosity.input.file.MemoryAdvice;
import radiosity.scene.SceneFormatException;
import radiosity.settings.ReadOptions;

/** The buffers of a glTF file: in the file itself, in data URIs, and in files beside it. */
final class Buffers {

    /** Most bytes of all buffers together, and of all arrays made of them: a quarter of the JVM's heap limit. */
    static final long MOST_BYTES = Runtime.getRuntime().maxMemory() / 4;

    private final Container file;
    private final FileSearch search;
    private final ReadOptions options;
    private final Map<Integer, ByteBuffer> buffers = new HashMap<>();
    private long total;

    Buffers(Container file, FileSearch search, ReadOptions options) {
        this.file = file;
        this.search = search;
        this.options = options;
    }

    /**
     * The bytes of a buffer view, little endian.
     *
     * @param where the JSON value that holds the view's index
     */
    ByteBuffer view(JsonCursor where) throws IOException {
        JsonCursor view = file.root().at("bufferViews").at(where.integer());
        int number = view.at("buffer").integer();
        ByteBuffer buffer = load(number);
        buffers.put(number, buffer);
        long offset = view.unchecked("byteOffset");
        long length = view.at("byteLength").unchecked();
        if (offset < 0 || length < 0 || offset > buffer.capacity() - length) {
            refuseCompressed(view, "EXT_meshopt_compression", "KHR_meshopt_compression");
            throw view.wrong("bytes of a buffer of " + buffer.capacity() + " bytes");
        }
        return buffer.slice((int) offset, (int) length).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** Refuses a value whose data stands in an extension that compresses it; a file may have the plain data, too. */
    static void refuseCompressed(JsonCursor value, String... extensions) throws SceneFormatException {
        for (String extension : extensions) {
            if (value.extension(extension).isPresent()) {
                throw new SceneFormatException(value.file(), "JSON " + value.path(),
                        "data without compression (export without it)", extension);
            }
        }
    }

    /** A copy of the bytes of a whole buffer. */
    byte[] all(int number) throws IOException {
        return copy(load(number));
    }

    private static byte[] copy(ByteBuffer bytes) {
        byte[] copy = new byte[bytes.capacity()];
        bytes.get(0, copy);
        return copy;
    }

    private ByteBuffer load(int number) throws IOException {
        if (buffers.containsKey(number)) {
            return buffers.get(number);
        }
        Optional<JsonCursor> uri = file.root().at("buffers").at(number).optional("uri");
        if (uri.isPresent()) {
            return ByteBuffer.wrap(required(uri.get()));
        }
        return number == 0 && file.bytes().isPresent() ? file.bytes().get() : ByteBuffer.allocate(0);
    }

    /** The bytes to which a URI refers, counted towards the limit once: those of data in {@link #data}. */
    private byte[] required(JsonCursor uri) throws IOException {
        byte[] bytes = content(uri).orElseThrow(() -> uri.wrong("a file beside it"));
        reserve(uri, isData(uri) ? 0 : bytes.length);
        return bytes;
    }

    private void reserve(JsonCursor where, long bytes) throws SceneFormatException {
        total += bytes;
        if (total > MOST_BYTES) {
            throw where.wrong("buffers of at most " + MOST_BYTES + " bytes together (a quarter of the memory; "
                    + MemoryAdvice.forBytes(4 * total) + ")");
        }
    }

    /** The bytes to which a URI refers; empty where it names a file that is not found. */
    Optional<byte[]> content(JsonCursor uri) throws IOException {
        if (isData(uri)) {
            return Optional.of(data(uri));
        }
        Optional<Path> path = found(uri);
        return path.isEmpty() ? Optional.empty()
                : Optional.of(InputFile.read(path.get(), search.shown(path.get()), options.maxBytes()));
    }

    /** Whether a URI contains its data ("data:"). */
    static boolean isData(JsonCursor uri) throws SceneFormatException {
        return uri.text().regionMatches(true, 0, "data:", 0, 5);
    }

    /** The bytes of a JSON object that has a "bufferView" or a "uri". */
    byte[] file(JsonCursor of) throws IOException {
        Optional<JsonCursor> view = of.optional("bufferView");
        return view.isPresent() ? copy(view(view.get())) : required(of.at("uri"));
    }

    /** The bytes that a data URI contains; its text counts towards the limit. */
    byte[] data(JsonCursor uri) throws SceneFormatException {
        String text = uri.text();
        int comma = text.indexOf(',');
        if (comma < 0 || !text.substring(0, comma).endsWith(";base64")) {
            throw uri.wrong("data in base64");
        }
        reserve(uri, text.length());
        try {
            return Base64.getMimeDecoder().decode(text.substring(comma + 1).getBytes(StandardCharsets.ISO_8859_1));
        } catch (IllegalArgumentException e) {
            throw uri.wrong("data in base64");
        }
    }

    /** The file beside the glTF file that a URI names; empty if it is not found. */
    Optional<Path> found(JsonCursor uri) throws SceneFormatException {
        String text = uri.text();
        try {
            Optional<Path> decoded = search.file(URLDecoder.decode(text.replace("+", "%2B"), StandardCharsets.UTF_8));
            return decoded.isPresent() ? decoded : search.file(text);
        } catch (IllegalArgumentException e) {
            return search.file(text);
        }
    }
}
