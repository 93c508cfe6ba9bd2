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
import radiosity.scene.SceneFormatException;
import radiosity.settings.ReadOptions;

/** The buffers of a glTF file: in the file itself, in data URIs, and in files beside it. */
final class Buffers {

    /** All buffers together may take 1 / PART of the JVM's heap limit. */
    private static final int PART = 4;

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
        ByteBuffer buffer = buffer(view.at("buffer"));
        long offset = view.unchecked("byteOffset");
        long length = view.at("byteLength").unchecked();
        if (offset < 0 || length < 0 || offset > buffer.capacity() - length) {
            throw view.wrong("bytes of a buffer of " + buffer.capacity() + " bytes");
        }
        return buffer.slice((int) offset, (int) length).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** A copy of the bytes of a whole buffer. */
    byte[] all(int number) throws IOException {
        ByteBuffer bytes = buffers.containsKey(number) ? buffers.get(number)
                : load(file.root().at("buffers").at(number), number);
        byte[] all = new byte[bytes.capacity()];
        bytes.duplicate().clear().get(all);
        return all;
    }

    /** The bytes of a file beside the glTF file. */
    byte[] file(Path path) throws IOException {
        return InputFile.read(path, search.shown(path), options.maxBytes());
    }

    private ByteBuffer buffer(JsonCursor where) throws IOException {
        int number = where.integer();
        ByteBuffer known = buffers.get(number);
        if (known == null) {
            known = load(file.root().at("buffers").at(number), number);
            buffers.put(number, known);
        }
        return known;
    }

    private ByteBuffer load(JsonCursor buffer, int number) throws IOException {
        Optional<JsonCursor> uri = buffer.optional("uri");
        if (uri.isEmpty()) {
            return number == 0 && file.bytes().isPresent() ? file.bytes().get() : ByteBuffer.allocate(0);
        }
        if (isData(uri.get())) {
            return data(uri.get());
        }
        Optional<Path> path = found(uri.get());
        if (path.isEmpty()) {
            throw uri.get().wrong("a file beside it");
        }
        byte[] bytes = InputFile.read(path.get(), search.shown(path.get()), options.maxBytes());
        reserve(uri.get(), bytes.length);
        return ByteBuffer.wrap(bytes).asReadOnlyBuffer();
    }

    private void reserve(JsonCursor where, long bytes) throws SceneFormatException {
        total += bytes;
        if (total > Runtime.getRuntime().maxMemory() / PART) {
            throw where.wrong("buffers of at most " + Runtime.getRuntime().maxMemory() / PART + " bytes together");
        }
    }

    /** Whether a URI contains its data ("data:"). */
    static boolean isData(JsonCursor uri) throws SceneFormatException {
        return uri.text().regionMatches(true, 0, "data:", 0, 5);
    }

    /** The bytes of a JSON object that has a "bufferView" or a "uri". */
    byte[] file(JsonCursor of) throws IOException {
        Optional<JsonCursor> view = of.optional("bufferView");
        if (view.isEmpty()) {
            of.at("uri").text();
        }
        ByteBuffer content = view.isPresent() ? view(view.get()) : load(of, 1);
        byte[] bytes = new byte[content.remaining()];
        content.duplicate().get(bytes);
        return bytes;
    }

    /** The bytes that a data URI contains. */
    ByteBuffer data(JsonCursor uri) throws SceneFormatException {
        String text = uri.text();
        int comma = text.indexOf(',');
        if (comma < 0 || !text.substring(0, comma).endsWith(";base64")) {
            throw uri.wrong("data in base64");
        }
        reserve(uri, text.length());
        try {
            return ByteBuffer.wrap(Base64.getMimeDecoder().decode(text.substring(comma + 1).getBytes(
                    StandardCharsets.ISO_8859_1))).asReadOnlyBuffer();
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
