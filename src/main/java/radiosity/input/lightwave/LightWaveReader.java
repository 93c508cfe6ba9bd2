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
     * Reads a file and the objects it names.
     *
     * @param file     a scene (.lws), or an object (.lwo), which makes a scene of itself at the origin
     * @param options  how
     * @param warnings gets one line for each kind of thing that was left out or mended, with file and place
     * @return at least one triangle
     * @throws SceneFormatException if the content cannot be used, or under {@code strict} at the first warning
     * @throws IOException          if a file cannot be read
     */
    public static Scene read(Path file, ReadOptions options, Consumer<String> warnings) throws IOException {
        return SceneAssembly.read(file, options, warnings).scene();
    }

    /**
     * Where an object of a scene is described.
     *
     * @param line    number of the first of its lines, from 1
     * @param written the path of its file as the scene has it; empty for a null object
     * @param file    what was found there
     */
    public record Origin(int line, String written, Optional<Path> file) { }

    /** Where the objects of a scene are described: 1 per node of its hierarchy. */
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
