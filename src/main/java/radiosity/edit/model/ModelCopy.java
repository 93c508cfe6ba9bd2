package radiosity.edit.model;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import radiosity.input.SceneFormat;
import radiosity.input.SceneReader;
import radiosity.output.file.AtomicFile;
import radiosity.scene.Light;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Surface;
import radiosity.settings.ReadOptions;

/**
 * Writes a copy of a model in which edited objects are moved and edited surfaces are painted. The copy is read again
 * and deleted where it is not the edited scene, because where an object stands may follow from more than its own place.
 */
public final class ModelCopy {

    /** Tolerance of rotations and reflectances, and of positions relative to the largest coordinate. */
    static final double SAME = 1e-6;

    private ModelCopy() { }

    /**
     * Why no copy of a model can be written, whatever the edits; empty where it can.
     *
     * @throws IOException where the model cannot be read
     */
    public static Optional<SceneFormatException> obstacle(Path source) throws IOException {
        if (isGltf(source) || LightWaveCopy.isScene(source)) {
            return Optional.empty();
        }
        return Optional.of(new SceneFormatException(source.toString(), "",
                "a LightWave scene or a glTF file to save a copy of",
                SceneFormat.of(source).equals(Optional.of(SceneFormat.OBJ))
                ? "an OBJ file, which does not say where objects stand" : "another format"));
    }

    private static boolean isGltf(Path source) throws IOException {
        return SceneFormat.of(source).equals(Optional.of(SceneFormat.GLTF));
    }

    /**
     * Writes the copy.
     *
     * @param source  the original model
     * @param options options with which the source was read and the copy is read again
     * @param before  scene read from the source
     * @param edited  the same triangles, with objects moved and surfaces painted
     * @param target  the copy: a file that does not exist, in the directory of the source, from where both find further
     *                files; copied LightWave objects are named after it
     * @return all files written
     * @throws SceneFormatException where files of the source's format cannot express the edits; no file is left then
     */
    public static List<Path> write(Path source, ReadOptions options, Scene before, Scene edited, Path target)
            throws IOException {
        Optional<SceneFormatException> obstacle = obstacle(source);
        if (obstacle.isPresent()) {
            throw obstacle.get();
        }
        if (!target.toAbsolutePath().getParent().equals(source.toAbsolutePath().getParent())) {
            throw new SceneFormatException(target.toString(), "", "a copy beside " + source
                    + ", as its objects are found from there", "another directory");
        }
        try {
            Map<Path, byte[]> files = isGltf(source) ? Map.of(target, GltfCopy.of(source, options, before, edited))
                    : LightWaveCopy.of(source, options, before, edited, target);
            return write(files, target, options, edited);
        } catch (IllegalArgumentException e) {
            throw new SceneFormatException(source.toString(), "", "edits that its format can say", e.getMessage());
        }
    }

    private static List<Path> write(Map<Path, byte[]> files, Path target, ReadOptions options, Scene edited)
            throws IOException {
        List<Path> written = new ArrayList<>();
        boolean isKept = false;
        try {
            for (Map.Entry<Path, byte[]> file : files.entrySet()) {
                if (Files.exists(file.getKey())) {
                    throw new IllegalArgumentException("expected a free name, got " + file.getKey());
                }
                AtomicFile.write(file.getKey(), file.getValue());
                written.add(file.getKey());
            }
            check(SceneReader.read(target, options, line -> { }), edited);
            isKept = true;
        } finally {
            for (Path file : isKept ? List.<Path>of() : written) {
                Files.deleteIfExists(file);
            }
        }
        return List.copyOf(files.keySet());
    }

    private static void check(Scene read, Scene edited) {
        boolean isSame = read.triangles() == edited.triangles()
                && read.surfaces().size() == edited.surfaces().size()
                && Arrays.equals(read.vertexColours(), edited.vertexColours());
        double most = 0;
        for (double x : edited.points()) {
            most = Math.max(most, Math.abs(x));
        }
        for (int i = 0; i < 3 * read.triangles() && isSame; i++) {
            isSame = read.corner(i / 3, i % 3).minus(edited.corner(i / 3, i % 3)).length() <= SAME * most;
        }
        for (int s = 0; s < read.surfaces().size() && isSame; s++) {
            Surface a = read.surfaces().get(s);
            Surface b = edited.surfaces().get(s);
            for (int c = 0; c < 3; c++) {
                isSame &= Math.abs(a.reflectance().channel(c) - b.reflectance().channel(c)) < SAME
                        && a.exitance().channel(c) == b.exitance().channel(c);
            }
        }
        if (!isSame) {
            throw new IllegalArgumentException("what was moved or painted follows from more than a place and a colour");
        }
        if (!places(edited).containsAll(places(read))) {
            throw new IllegalArgumentException("a light without geometry is bound to what was moved");
        }
    }

    /** Names, positions and directions of lights; the edited scene may have daylight besides those of its model. */
    private static Set<List<Object>> places(Scene scene) {
        return scene.lights().stream().map((Light light) -> List.<Object>of(light.name(), light.position(),
                light.direction())).collect(Collectors.toSet());
    }
}
