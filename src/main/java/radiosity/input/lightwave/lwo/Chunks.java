package radiosity.input.lightwave.lwo;

import java.util.Set;
import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;

/**
 * Iterates over the chunks of a container: a name of 4 characters, size, content, and a pad byte after an odd size.
 *
 * <p>A size beyond the container's end is cut; a pad byte is taken as missing if a chunk name begins at its place.
 */
final class Chunks {

    private final ByteReader container;
    private final int sizeBytes;
    private final Diagnostics notes;
    private int offset;
    private String id = "";
    private ByteReader data;
    private boolean odd;

    /** @param sizeBytes bytes of a chunk's size: 4 in files and in LWO3, 2 inside the surfaces of older objects */
    Chunks(ByteReader container, int sizeBytes, Diagnostics notes) {
        this.container = container;
        this.sizeBytes = sizeBytes;
        this.notes = notes;
    }

    /** Moves to the next chunk; false at the end. */
    boolean next() {
        if (data != null) {
            skipPad();
        }
        if (container.left() < 4 + sizeBytes) {
            noteRest();
            return false;
        }
        offset = container.offset();
        id = container.id();
        if (!isName(id)) {
            notes.note("byte " + offset, "no chunk stands here, the rest of the container is left out");
            return false;
        }
        long size = sizeBytes == 4 ? container.u4() : container.u2();
        if (size > container.left()) {
            notes.note(place(), "the chunk is longer than what holds it and is cut",
                    size + " bytes, there are " + container.left());
        }
        data = container.window(size);
        odd = (size & 1) == 1;
        return true;
    }

    private void skipPad() {
        if (!odd || !container.has(1)) {
            return;
        }
        if (container.peek(0) != 0 && startsName()) {
            notes.note(place(), "the pad byte after an odd size is missing");
        } else {
            container.skip(1);
        }
    }

    private boolean startsName() {
        return container.has(4) && isName(container.copy().id());
    }

    private void noteRest() {
        if (container.left() > 1) {
            notes.note("byte " + container.offset(), "the file ends within the head of a chunk");
        }
        container.skip(container.left());
    }

    private static boolean isName(String id) {
        return id.chars().allMatch(c -> c >= ' ' && c < 0x7F);
    }

    /** Content of the first FORM of one of the given types in a container; an empty reader where there is none. */
    static ByteReader form(ByteReader container, Set<String> types, Diagnostics notes) {
        Chunks chunks = new Chunks(container, 4, notes);
        while (chunks.next()) {
            if (chunks.id.equals("FORM") && types.contains(chunks.data.id())) {
                return chunks.data;
            }
        }
        return new ByteReader(new byte[0]);
    }

    String id() {
        return id;
    }

    /** The content of the chunk; reading moves its position. */
    ByteReader data() {
        return data;
    }

    /** Byte offset and name of the chunk, for messages. */
    String place() {
        return "byte " + offset + ", chunk " + id;
    }
}
