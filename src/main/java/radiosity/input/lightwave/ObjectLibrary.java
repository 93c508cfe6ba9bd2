package radiosity.input.lightwave;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSearch;
import radiosity.input.file.InputFile;
import radiosity.input.file.WorkBudget;
import radiosity.input.lightwave.lwo.Layer;
import radiosity.input.lightwave.lwo.ObjectFile;
import radiosity.input.lightwave.lwo.ObjectModel;
import radiosity.input.lightwave.lws.SceneItem;
import radiosity.scene.SceneFormatException;
import radiosity.settings.ReadOptions;

/** The objects of a scene: each file is read once, and each of its layers is cut into triangles once. */
final class ObjectLibrary {

    private final FileSearch search;
    private final ReadOptions options;
    private final Diagnostics notes;
    private final WorkBudget work = new WorkBudget();
    private final Map<Path, Optional<ObjectModel>> objects = new HashMap<>();
    private final Map<Path, Diagnostics> notesOf = new LinkedHashMap<>();
    private final Map<PartKey, Optional<Part>> parts = new HashMap<>();

    /** A layer of a file, or the whole file if the layer is {@link SceneItem#WHOLE_FILE}. */
    private record PartKey(Path file, int layer) { }

    /**
     * What all instances of a layer or file share.
     *
     * @param name     name of the object's file, without its directory
     * @param geometry path of the file, followed by the layer's number where the layer is not the first
     */
    record Part(ObjectMesh mesh, String name, String geometry) { }

    ObjectLibrary(FileSearch search, ReadOptions options, Diagnostics notes) {
        this.search = search;
        this.options = options;
        this.notes = notes;
    }

    /** The mesh that a scene item loads; empty, with a note, if the file or layer is not found or cannot be read. */
    Optional<Part> part(SceneItem item) throws IOException {
        Optional<Path> file = search.object(item.file);
        if (file.isEmpty()) {
            notes.note(item.place(), "objects that are not found are left out", item.file);
            return Optional.empty();
        }
        PartKey key = new PartKey(file.get(), item.layer);
        Optional<Part> known = parts.get(key);
        if (known == null) {
            known = make(key, item);
            parts.put(key, known);
        }
        return known;
    }

    private Optional<Part> make(PartKey key, SceneItem item) throws IOException {
        String name = search.shown(key.file);
        Diagnostics objectNotes = notesOf.computeIfAbsent(key.file, f -> notes.about(name));
        Optional<ObjectModel> object = objects.get(key.file);
        if (object == null) {
            object = load(key.file, name, objectNotes);
            objects.put(key.file, object);
        }
        return object.flatMap(o -> cut(o, key.layer, item, name, objectNotes));
    }

    /** Reports the notes about all objects. */
    void flush() throws SceneFormatException {
        for (Diagnostics objectNotes : notesOf.values()) {
            objectNotes.flush();
        }
    }

    private Optional<Part> cut(ObjectModel object, int layer, SceneItem item, String name, Diagnostics objectNotes) {
        List<Layer> layers = layer == SceneItem.WHOLE_FILE ? object.layers : object.layers(layer);
        if (layers.isEmpty() && layer != SceneItem.WHOLE_FILE) {
            notes.note(item.place(), "layers that their object does not have are left out",
                    "layer " + (layer + 1) + " of " + name);
            return Optional.empty();
        }
        return Optional.of(new Part(ObjectMesh.of(object, layers, work, objectNotes),
                name.substring(name.lastIndexOf('/') + 1), layer > 0 ? name + ":" + (layer + 1) : name));
    }

    private Optional<ObjectModel> load(Path file, String name, Diagnostics objectNotes) throws IOException {
        try {
            ObjectModel object = ObjectFile.read(InputFile.read(file, name, options.maxBytes()), name, objectNotes);
            SurfaceImages.find(object, search, objectNotes);
            return Optional.of(object);
        } catch (SceneFormatException e) {
            if (options.strict()) {
                throw e;
            }
            notes.note("", "objects that cannot be read are left out", e.getMessage());
            return Optional.empty();
        }
    }
}
