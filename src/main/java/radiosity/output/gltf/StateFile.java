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
 * The file beside a scene file that holds the state if both together are longer than a glTF binary can be.
 *
 * <p>Its name is made of the name of the scene file, the first digits of the state's SHA-256 and {@code .state}. A new
 * state therefore never overwrites the state that the present scene file names: a scene file and its state belong
 * together even if the program ends between writing one and the other.
 */
final class StateFile {

    private static final int DIGITS = 16;
    /** Matches the part of the name that follows the scene file's name. */
    private static final String END = "\\.[0-9a-f]{" + DIGITS + "}\\.state";

    private StateFile() { }

    /**
     * Writes a state, before the scene file that will name it.
     *
     * @return name of the state file, which is to be written into the scene file
     */
    static String write(Path scene, SavedState state) throws IOException {
        Path target = AtomicFile.target(scene);
        String name = target.getFileName() + "." + state.sha256().substring(0, DIGITS) + ".state";
        AtomicFile.write(target.resolveSibling(name), channel -> state.writeTo(Channels.newOutputStream(channel)));
        return name;
    }

    /**
     * Deletes the state files of earlier versions of a scene file.
     *
     * @param kept name of the state file that stays, or an empty text if the scene file itself holds its state
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
        return file.startsWith(scene) && file.substring(scene.length()).matches(END);
    }

    /**
     * Reads the state of a scene file.
     *
     * @param name   of the state file as {@link #write} returned it
     * @param length of the state, bytes
     * @throws SceneFormatException if the name is not that of a state file, or the file is missing or has another
     *         length
     */
    static SavedState read(Path scene, String name, long length) throws IOException {
        if (!name.matches("[^/\\\\]+" + END)) {
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
