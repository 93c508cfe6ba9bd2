package radiosity.edit;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import radiosity.edit.model.ModelCopy;
import radiosity.output.gltf.SceneFile;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;

/**
 * Saves an edited scene under free names: {@code room-edit-1.scene} with its light beside the scene file, and {@code
 * room-edit-1.lws}, or with the extension of a glTF model, beside the original model; the new scene file names this
 * copy as its model.
 */
public final class EditFiles {

    private final EditSource source;
    private final Optional<String> obstacle;

    /** @throws IOException where the model cannot be read */
    public EditFiles(EditSource source) throws IOException {
        this.source = source;
        obstacle = ModelCopy.obstacle(source.model()).map(SceneFormatException::getMessage);
    }

    /** Why only scene files are saved, whatever the edits; empty where copies of the model are saved, too. */
    public Optional<String> obstacle() {
        return obstacle;
    }

    /**
     * Saves both files; only the scene file where files of the model's format cannot express the edits.
     *
     * @param edited light of the edited scene
     * @return line for the user: the files saved, and why the model was not saved
     * @throws IOException where the scene file or the copy cannot be written; no file is left then
     */
    public String save(LightFollower.Rest edited, ToneMapping toneMapping) throws IOException {
        int number = 1;
        while (Files.exists(scene(number)) || Files.exists(copy(number))) {
            number++;
        }
        Scene scene = edited.solution().scene();
        Map<String, Object> extras = new TreeMap<>();
        extras.put("settings", source.kept());
        edited.certificate().ifPresent(certificate -> extras.put("certificate", certificate));
        String copied;
        List<Path> copies = List.of();
        try {
            Path copy = copy(number);
            Path file = scene(number);
            copies = ModelCopy.write(source.model(), source.reading(), source.scene(), scene, copy);
            extras.put("commandLine", source.commandLine().stream().map(word -> isName(word, source.model()) ? "" + copy
                    : isName(word, source.file()) ? "" + file : word).toList());
            copied = ", " + copy.getFileName();
        } catch (SceneFormatException e) {
            copied = "; " + e.getMessage();
        }
        boolean isWritten = false;
        try {
            SceneFile.write(scene(number), edited.solution(), extras, scene.camera(), toneMapping);
            isWritten = true;
        } finally {
            for (Path copy : isWritten ? List.<Path>of() : copies) {
                Files.deleteIfExists(copy);
            }
        }
        return "saved " + scene(number).getFileName() + copied;
    }

    private static boolean isName(String word, Path file) {
        return new File(word).getName().equals(String.valueOf(file.getFileName()));
    }

    private Path scene(int number) {
        return numbered(source.file(), number, ".scene");
    }

    private Path copy(int number) {
        String name = String.valueOf(source.model().getFileName());
        return numbered(source.model(), number, name.indexOf('.') < 0 ? "" : name.substring(name.lastIndexOf('.')));
    }

    private static Path numbered(Path file, int number, String suffix) {
        return file.resolveSibling(String.valueOf(file.getFileName()).replaceFirst("(-edit-\\d+)?\\.[A-Za-z0-9]+$", "")
                + "-edit-" + number + suffix);
    }
}
