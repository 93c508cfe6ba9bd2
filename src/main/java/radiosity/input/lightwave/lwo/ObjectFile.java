package radiosity.input.lightwave.lwo;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSniffer;
import radiosity.scene.SceneFormatException;

/** Recognises an object file by its content and reads it with the reader of its format. */
public final class ObjectFile {

    static final List<String> FORMATS = List.of("LWOB", "LWLO", "LWO2", "LWO3");
    private static final int HEAD = 12;

    private ObjectFile() {
    }

    /** Whether the bytes begin as an object does. */
    public static boolean isObject(byte[] bytes) {
        return bytes.length >= HEAD && text(bytes, 0).equals("FORM") && FORMATS.contains(text(bytes, 8));
    }

    private static String text(byte[] bytes, int at) {
        return new String(bytes, at, 4, StandardCharsets.ISO_8859_1);
    }

    /**
     * Reads an object; every value of its surfaces is set afterwards, the luminous colour excepted.
     *
     * @param bytes the whole file
     * @param name  name of the file as the user knows it
     * @throws SceneFormatException if the bytes are not a LightWave object
     */
    public static ObjectModel read(byte[] bytes, String name, Diagnostics notes) throws SceneFormatException {
        if (!isObject(bytes)) {
            throw notes.error("", "a LightWave object", FileSniffer.describe(bytes));
        }
        ByteReader file = new ByteReader(bytes);
        file.skip(4);
        long size = file.u4();
        if (size != bytes.length - 8L && size != bytes.length - 9L) {
            notes.note("byte 4, chunk FORM", "the size of the file is not what it says, all of it is read",
                    size + " bytes, there are " + (bytes.length - 8));
        }
        ObjectModel object = new ObjectModel(name, file.id());
        if (object.isOld()) {
            new LwobReader(object, notes).read(file);
        } else {
            new Lwo2Reader(object, notes).read(file);
        }
        object.currentLayer();
        inherit(object, notes);
        object.surfaces.values().forEach(s -> s.complete(object.isOld()));
        return object;
    }

    /** Completes every surface from its source surface, whose own source is regarded first. */
    private static void inherit(ObjectModel object, Diagnostics notes) {
        Set<SurfaceValues> done = new HashSet<>();
        for (SurfaceValues surface : object.surfaces.values()) {
            Deque<SurfaceValues> chain = new ArrayDeque<>();
            SurfaceValues link = surface;
            while (link != null && done.add(link)) {
                chain.push(link);
                link = link.source.isEmpty() ? null : object.surfaces.get(link.source);
            }
            if (link != null && chain.contains(link)) {
                notes.note("", "surfaces take their values from one another in a circle", link.name);
            }
            chain.forEach(s -> inheritOne(object, s));
        }
    }

    private static void inheritOne(ObjectModel object, SurfaceValues surface) {
        SurfaceValues source = object.surfaces.get(surface.source);
        if (!surface.source.isEmpty() && source != null) {
            surface.inherit(source);
        }
    }
}
