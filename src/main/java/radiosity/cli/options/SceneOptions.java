package radiosity.cli.options;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.Stack;
import picocli.CommandLine.IParameterConsumer;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import radiosity.scene.Scene;
import radiosity.scene.Units;
import radiosity.settings.ReadOptions;

/** Options for reading the scene. */
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

    @Option(names = "--two-sided",
            description = "Surfaces of OBJ that do not emit have two sides. Default: the side from which corners run"
                    + " counter-clockwise.")
    boolean twoSided;

    @Option(names = "--up", paramLabel = "<axis>", converter = UpParser.class,
            description = "Axis of OBJ that points up: y (default) or z. With z, the place x,y,z of the file is x,z,-y"
                    + " in all options and results.")
    ReadOptions.Up up = ReadOptions.Up.Y;

    @Option(names = "--unit", paramLabel = "<unit>", converter = UnitParser.class,
            description = "Length of a unit of LightWave and OBJ: mm, cm, m, in or ft (glTF: metres). Flux is in W or"
                    + " lm where it is known.")
    Double unit;

    @Option(names = "--photometric",
            description = "What emits does so in lm/m2; results are in lx, cd/m2 and lm. So is glTF with lights.")
    boolean photometric;

    @Option(names = "--luminaire", paramLabel = "<name=file>", parameterConsumer = LuminaireConsumer.class,
            description = "A light of that name, or a new one at x,y,z that shines down, shines as an IES or EULUMDAT"
                    + " file says. Repeatable.")
    public Map<String, Path> luminaires = new LinkedHashMap<>();

    @Option(names = "--leave-out", paramLabel = "<name>",
            description = "Leave out the surface of that name, or the object with all below it: panes that keep"
                    + " daylight out, a wall in the way of the view. Repeatable.")
    Set<String> leftOut = new LinkedHashSet<>();

    @Option(names = "--strict", description = "Every warning about the scene is an error (exit code 3).")
    public boolean strict;

    /** Parses {@code <name=file>}, once for each name. */
    static final class LuminaireConsumer implements IParameterConsumer {
        @Override
        public void consumeParameters(Stack<String> arguments, ArgSpec option, CommandSpec command) {
            String text = Arguments.next(arguments, option, option.paramLabel());
            int equals = text.indexOf('=');
            if (equals <= 0 || equals == text.length() - 1) {
                throw Arguments.wrong(option, "expected " + option.paramLabel() + ", got " + text);
            }
            Map<String, Path> all = new LinkedHashMap<>(option.<Map<String, Path>>getValue());
            String name = text.substring(0, equals);
            if (all.put(name, Arguments.path(text.substring(equals + 1), option)) != null) {
                throw Arguments.wrong(option, "expected every name once, got " + name + " twice");
            }
            option.setValue(all);
        }
    }

    /** Parses a unit of length to its length in metres. */
    static final class UnitParser extends Values.Value<Double> {

        private static final Map<String, Double> UNITS = Map.of("mm", 1e-3, "cm", 1e-2, "m", 1.0, "in", 0.0254, "ft",
                0.3048);

        @Override
        String expected() {
            return "mm, cm, m, in or ft";
        }

        @Override
        public Double parse(String text) {
            return UNITS.get(text);
        }
    }

    /** Parses {@code luminosity} and {@code specular}. */
    static final class EmissionParser extends Values.Choice<ReadOptions.Emission> {
        EmissionParser() {
            super(ReadOptions.Emission.class);
        }
    }

    /** Parses {@code auto}, {@code ignore} and {@code emitters}. */
    static final class LightsParser extends Values.Choice<ReadOptions.Lights> {
        LightsParser() {
            super(ReadOptions.Lights.class);
        }
    }

    /** Parses {@code y} and {@code z}. */
    static final class UpParser extends Values.Choice<ReadOptions.Up> {
        UpParser() {
            super(ReadOptions.Up.class);
        }
    }

    /** Fails where {@code --content} or {@code --map} names no directory. */
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

    public ReadOptions readOptions() {
        ReadOptions options = ReadOptions.defaults().withEmission(emission).withContent(content).withMap(map)
                .withLights(lights).withSrgb(srgb).withTwoSided(twoSided).withUp(up).withStrict(strict)
                .withLuminaires(luminaires).withLeftOut(leftOut)
                .withUnits(new Units(unit == null ? Double.NaN : unit, photometric));
        return frame == null ? options : options.withFrame(frame);
    }

    /** Fails where {@code --unit} is given for a scene whose format defines the unit. */
    public void check(Scene scene) {
        if (unit != null && scene.units().metres() != unit) {
            throw Failure.commandLine("--unit", "expected with LightWave or OBJ, got it with " + scene.name()
                    + ", which is in metres");
        }
    }
}
