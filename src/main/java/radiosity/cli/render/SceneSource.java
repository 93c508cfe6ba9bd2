package radiosity.cli.render;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import radiosity.cli.options.CommandLineParser;
import radiosity.cli.options.RendererOptions;
import radiosity.edit.EditSource;
import radiosity.input.SceneReader;
import radiosity.output.gltf.SceneFile;
import radiosity.output.image.SurfaceMaps;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;

/** Finds what a scene file was made from, by the command line that it keeps. */
public final class SceneSource {

    private SceneSource() { }

    /**
     * Reads a scene file's calculation, and its model as the render did.
     *
     * @param model    where it is; without, where the command line says, from here or beside the scene file
     * @param warnings gets a line for what was left out
     * @throws SceneFormatException where the file does not say what it was made from
     */
    public static EditSource read(Path file, Optional<Path> model, Consumer<String> warnings) throws IOException {
        SavedCalculation saved = SavedCalculation.read(file);
        Map<String, Object> extras;
        try (SceneFile scene = SceneFile.open(file)) {
            extras = scene.extras();
        }
        if (!(extras.get("commandLine") instanceof List<?> words)) {
            throw new SceneFormatException(file.toString(), "", "a scene file that says what it was made from",
                    "one without its command line");
        }
        List<String> commandLine = words.stream().map(String::valueOf).toList();
        RendererOptions options = new RendererOptions();
        new CommandLineParser(options).parse(commandLine.toArray(String[]::new));
        if (options.files.size() != 2 || options.scene.frames != null) {
            throw new SceneFormatException(file.toString(), "", "a scene file of one render",
                    options.scene.frames != null ? "a frame of an animation" : "another");
        }
        Path found = model.orElseGet(() -> near(options.input(), file));
        Scene scene = options.scene.daylight(SceneReader.read(found, options.scene.lightWave(), warnings));
        return new EditSource(found, options.scene.lightWave(), SurfaceMaps.read(scene, options.scene.srgb, warnings),
                file, saved.state(), saved.settings(), (Map<?, ?>) extras.get("settings"), commandLine);
    }

    private static Path near(Path written, Path file) {
        Path beside = file.resolveSibling(written.getFileName());
        return !Files.exists(written) && Files.exists(beside) ? beside : written;
    }
}
