package radiosity.cli.options;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Option;
import radiosity.settings.ReadOptions;

/** How to read the scene. */
public final class SceneOptions {

    @Option(names = "--frame", paramLabel = "<n>", converter = Values.AnyNumber.class,
            description = "LightWave: frame at which motions are taken. Default: the scene's first.")
    Double frame;

    @Option(names = "--content", paramLabel = "<dir>",
            description = "Directory in which files that the scene names are searched besides its own. Repeatable.")
    public List<Path> content = new ArrayList<>();

    @Option(names = "--map", paramLabel = "<prefix=dir>",
            description = "Directory in which paths that begin with the prefix lie. Repeatable.")
    public Map<String, Path> map = new LinkedHashMap<>();

    @Option(names = "--emission", paramLabel = "<property>", converter = EmissionParser.class,
            description = "LightWave: what makes a surface emit, luminosity (default), or specular as in the paper.")
    ReadOptions.Emission emission = ReadOptions.Emission.LUMINOSITY;

    @Option(names = "--lights", paramLabel = "<use>", converter = LightsParser.class,
            description = "The scene's lights: auto (LightWave: where no surface emits, glTF: always; default), ignore"
                    + " or emitters (always).")
    ReadOptions.Lights lights = ReadOptions.Lights.AUTO;

    @Option(names = "--srgb",
            description = "Colours of LightWave and OBJ are sRGB and made linear. Default: as written.")
    public boolean srgb;

    @Option(names = "--strict", description = "Every warning about the scene is an error (exit code 3).")
    public boolean strict;

    /** Reads {@code luminosity} and {@code specular}. */
    static final class EmissionParser extends Values.Choice<ReadOptions.Emission> {
        EmissionParser() {
            super(ReadOptions.Emission.class);
        }
    }

    /** Reads {@code auto}, {@code ignore} and {@code emitters}. */
    static final class LightsParser extends Values.Choice<ReadOptions.Lights> {
        LightsParser() {
            super(ReadOptions.Lights.class);
        }
    }

    /** Fails where a directory is none. */
    void check() {
        content.forEach(directory -> check("--content", directory));
        map.forEach((prefix, directory) -> check("--map " + prefix, directory));
    }

    private static void check(String option, Path directory) {
        if (!Files.isDirectory(directory)) {
            throw Failure.file(option, "expected a directory, got " + directory
                    + (Files.exists(directory) ? ", a file" : ", which is not there"), null);
        }
    }

    public ReadOptions lightWave() {
        ReadOptions options = ReadOptions.defaults().withEmission(emission).withContent(content).withMap(map)
                .withLights(lights).withSrgb(srgb).withStrict(strict);
        return frame == null ? options : options.withFrame(frame);
    }
}
