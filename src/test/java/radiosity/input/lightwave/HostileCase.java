package radiosity.input.lightwave;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

/**
 * A broken or malicious input and what must come of it.
 *
 * @param name      of the case
 * @param files     by their paths in a folder of their own
 * @param main      the one to be read
 * @param triangles of the scene; {@link #ERROR} if there must be none
 * @param says      what the error or one of the warnings contains; empty if there is nothing to be said
 */
public record HostileCase(String name, Map<String, byte[]> files, String main, int triangles, String says) {

    static final int ERROR = -1;
    /** A scene or an error: it is enough that it is one of them. */
    static final int EITHER = -2;

    static HostileCase object(String name, byte[] object, int triangles, String says) {
        return new HostileCase(name, Map.of("thing.lwo", object), "thing.lwo", triangles, says);
    }

    /** A scene beside a square of two triangles, room.lwo. */
    static HostileCase scene(String name, String text, int triangles, String says) {
        return new HostileCase(name, Map.of("room.lwo", Objects.square(), "a.lws", Iff.text(text)), "a.lws", triangles,
                says);
    }

    /** Writes the files into a folder and returns the one to be read. */
    public Path write(Path folder) throws IOException {
        for (Map.Entry<String, byte[]> file : files.entrySet()) {
            Path path = folder.resolve(file.getKey());
            Files.createDirectories(path.getParent());
            Files.write(path, file.getValue());
        }
        return folder.resolve(main);
    }

    @Override
    public String toString() {
        return name;
    }
}
