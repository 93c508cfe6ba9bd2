package radiosity.input.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import radiosity.scene.SceneFormatException;

/** Reads a file into memory once, if it is one and not too large. */
public final class InputFile {

    /** What is read from a file may take this many times its size. */
    private static final int GROWTH = 16;

    private InputFile() {
    }

    /**
     * @param name     the file as the user knows it
     * @param maxBytes largest size that is read, bytes
     */
    public static byte[] read(Path file, String name, long maxBytes) throws IOException {
        check(file, name);
        try (InputStream in = Files.newInputStream(file)) {
            long most = Math.min(maxBytes, Runtime.getRuntime().maxMemory() / GROWTH);
            byte[] bytes = in.readNBytes((int) Math.min(Integer.MAX_VALUE - 8, most + 1));
            if (bytes.length > most) {
                String why = most < maxBytes ? " (a sixteenth of the memory)" : "";
                throw new SceneFormatException(name, "", "at most " + most + " bytes" + why, Files.size(file)
                        + " bytes");
            }
            return bytes;
        }
    }

    /**
     * Checks that there is a file.
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
