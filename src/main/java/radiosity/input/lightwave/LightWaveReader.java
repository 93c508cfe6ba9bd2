package radiosity.input.lightwave;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSearch;
import radiosity.input.lightwave.lwo.ObjectFile;
import radiosity.input.lightwave.lws.SceneItem;
import radiosity.input.lightwave.lws.SceneParser;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.settings.ReadOptions;

/** Reads a LightWave scene, or an object alone, into triangles, surfaces, lights and a camera. */
public final class LightWaveReader {

    private LightWaveReader() {
    }

    /** Whether a file begins as a LightWave scene or object does. */
    public static boolean recognises(byte[] start) {
        return SceneParser.isScene(start) || ObjectFile.isObject(start);
    }

    /**
     * Reads a file and the objects that it names.
     *
     * @param file     a scene (.lws), or an object (.lwo), which becomes a scene with the object at the origin
     * @param options  where objects and images are searched, which emission and lights are taken, limits
     * @param warnings receives one line, with file and place, for each kind of content that was left out or repaired
     * @return a scene of at least one triangle
     * @throws SceneFormatException if the content cannot be used, or under {@code strict} at the first warning
     * @throws IOException          if a file cannot be read
     */
    public static Scene read(Path file, ReadOptions options, Consumer<String> warnings) throws IOException {
        return SceneAssembly.read(file, options, warnings).scene();
    }

    /**
     * Where a scene file describes an object.
     *
     * @param line    number of the first line of the description, from 1
     * @param written path of the object's file as the scene file has it; empty for a null object
     * @param file    the file found for that path
     */
    public record Origin(int line, String written, Optional<Path> file) { }

    /** The descriptions of a scene's objects, 1 per node of the scene's hierarchy; empty for an object file. */
    public static List<Origin> origins(Path file, ReadOptions options) throws IOException {
        Diagnostics notes = new Diagnostics(String.valueOf(file.getFileName()), line -> { }, false);
        FileSearch search = SceneAssembly.search(file, options, notes);
        List<Origin> origins = new ArrayList<>();
        for (SceneItem object : SceneAssembly.read(file, options, line -> { }).objects()) {
            origins.add(object.isLoaded() ? new Origin(object.line(), object.file, search.object(object.file))
                    : new Origin(object.line(), "", Optional.empty()));
        }
        return origins;
    }
}
