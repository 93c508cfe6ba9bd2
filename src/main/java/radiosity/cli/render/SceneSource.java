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

/** Finds the model from which a scene file was rendered, by the command line that the scene file keeps. */
public final class SceneSource {

    private SceneSource() { }

    /**
     * Reads the calculation of a scene file, and its model with the options of the render.
     *
     * @param file     the scene file
     * @param model    path of the model; empty: as the command line names it, or with that name beside the scene file
     * @param warnings receives a line for each kind of thing that was left out
     * @throws SceneFormatException where the scene file does not keep its command line or calculation
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
        if (options.files.size() != 2 || options.file.frames != null) {
            throw new SceneFormatException(file.toString(), "", "a scene file of one render",
                    options.file.frames != null ? "a frame of an animation" : "another");
        }
        Path found = model.orElseGet(() -> near(options.input(), file));
        Scene scene = options.daylight.around(SceneReader.read(found, options.readOptions(), warnings));
        return new EditSource(found, options.readOptions(), SurfaceMaps.read(scene, options.scene.srgb, warnings),
                file, saved.state(), saved.settings(), (Map<?, ?>) extras.get("settings"), commandLine);
    }

    private static Path near(Path written, Path file) {
        Path beside = file.resolveSibling(written.getFileName());
        return !Files.exists(written) && Files.exists(beside) ? beside : written;
    }
}
