package radiosity.input.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import radiosity.scene.SceneFormatException;

/** Reads a regular file into memory in one go, if the file is not too large. */
public final class InputFile {

    /** Factor by which the data read from a file may be larger than the file; limits the size to a part of the heap. */
    private static final int GROWTH = 16;

    private InputFile() {
    }

    /**
     * @param name     of the file as the user knows it
     * @param maxBytes largest size of a file, bytes
     * @throws SceneFormatException where there is no regular file, or the file is too large
     */
    public static byte[] read(Path file, String name, long maxBytes) throws IOException {
        check(file, name);
        try (InputStream in = Files.newInputStream(file)) {
            long most = Math.min(maxBytes, Runtime.getRuntime().maxMemory() / GROWTH);
            byte[] bytes = in.readNBytes((int) Math.min(Integer.MAX_VALUE - 8, most + 1));
            if (bytes.length > most) {
                long size = Files.size(file);
                String why = most == maxBytes ? "" : " (a sixteenth of the memory"
                        + (size > maxBytes ? "" : "; " + MemoryAdvice.forBytes(GROWTH * size)) + ")";
                throw new SceneFormatException(name, "", "at most " + most + " bytes" + why, size + " bytes");
            }
            return bytes;
        }
    }

    /**
     * Checks that a regular file exists.
     *
     * @throws SceneFormatException where there is nothing, a directory or a device
     */
    public static void check(Path file, String name) throws SceneFormatException {
        if (!Files.exists(file)) {
            throw new SceneFormatException(name, "", "a file", "nothing of that name");
        }
        if (!Files.isRegularFile(file)) {
            throw new SceneFormatException(name, "", "a file", "a directory or a device");
        }
    }
}
