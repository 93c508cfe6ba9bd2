package radiosity.output.gltf;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.Channels;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import radiosity.output.file.AtomicFile;
import radiosity.scene.SceneFormatException;
import radiosity.solution.SavedState;

/**
 * The file beside a scene file that holds the state where both together are larger than a glTF binary can be.
 *
 * <p>Its name is that of the scene file, the first digits of the state's SHA-256 and {@code .state}: a new state never
 * overwrites the one that the present scene file names, so that a scene file and its state belong together whatever
 * ends the program between writing the one and the other.
 */
final class StateFile {

    private static final int DIGITS = 16;

    private StateFile() { }

    /**
     * Writes the state of a scene file that is written next.
     *
     * @return the file's name, which the scene file keeps
     */
    static String write(Path scene, SavedState state) throws IOException {
        Path target = AtomicFile.target(scene);
        String name = target.getFileName() + "." + state.sha256().substring(0, DIGITS) + ".state";
        AtomicFile.write(target.resolveSibling(name), channel -> state.writeTo(Channels.newOutputStream(channel)));
        return name;
    }

    /**
     * Deletes the state files of what the scene file was before.
     *
     * @param kept name of the file that stays, or an empty text where the scene file has its state inside
     */
    static void deleteOthers(Path scene, String kept) throws IOException {
        Path target = AtomicFile.target(scene);
        String name = target.getFileName().toString();
        try (DirectoryStream<Path> files = Files.newDirectoryStream(target.getParent(),
                file -> isState(file.getFileName().toString(), name))) {
            for (Path file : files) {
                if (!file.getFileName().toString().equals(kept)) {
                    Files.deleteIfExists(file);
                }
            }
        }
    }

    private static boolean isState(String file, String scene) {
        return file.startsWith(scene + ".")
                && file.substring(scene.length()).matches("\\.[0-9a-f]{" + DIGITS + "}\\.state");
    }

    /**
     * Reads the state of a scene file.
     *
     * @param name   as {@link #write} gave it
     * @param length of the state in bytes
     * @throws SceneFormatException where the file is missing or has another length
     */
    static SavedState read(Path scene, String name, long length) throws IOException {
        if (!name.matches("[^/\\\\]+\\.[0-9a-f]{" + DIGITS + "}\\.state")) {
            throw new SceneFormatException(scene.toString(), "state", "the name of a state file", name);
        }
        Path file = scene.toRealPath().resolveSibling(name);
        try {
            if (Files.size(file) != length) {
                throw new SceneFormatException(file.toString(), "", "the " + length + " bytes of state of " + scene,
                        Files.size(file) + " bytes");
            }
            try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
                return SavedState.read(in, length);
            }
        } catch (NoSuchFileException e) {
            throw new SceneFormatException(scene.toString(), "state", "the file " + name + " beside it", "none");
        }
    }
}
