package radiosity.cli.options;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Stack;
import picocli.CommandLine.IParameterConsumer;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import radiosity.scene.Light;
import radiosity.scene.Scene;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;

/** Options for reading the scene. */
public final class SceneOptions {

    private static final double USUAL_SKY = 10_000;

    @Option(names = "--frame", paramLabel = "<n>", converter = Values.AnyNumber.class,
            description = "LightWave: frame at which motions are taken. Default: the scene's first.")
    Double frame;

    @Option(names = "--frames", paramLabel = "<a-b[:n]>", converter = FrameRange.Parser.class,
            description = "LightWave: every n:th frame from a to b, each calculated from the one before (see --change);"
                    + " the names of all outputs get its number: out-0012.scene.")
    public FrameRange frames;

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

    @Option(names = "--sky", paramLabel = "<sky[=lx]>", converter = SkyParser.class,
            description = "A sky around the scene: cie-overcast, cie-clear (with --sun) or uniform; with the"
                    + " illuminance of a level place in the open, 10000 lx without. Up is y.")
    Map.Entry<Light.Kind, Double> sky;

    @Option(names = "--sun", paramLabel = "<x,y,z> <lx>", arity = "2", hideParamSyntax = true,
            parameterConsumer = SunConsumer.class,
            description = "The sun: the direction towards it, and the illuminance of a place that faces it.")
    Light sun;

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

    /** Parses {@code cie-overcast=5000}, a kind of sky and its illuminance in lx. */
    static final class SkyParser extends Values.Value<Map.Entry<Light.Kind, Double>> {

        private static final Map<String, Light.Kind> SKIES = Map.of("cie-overcast", Light.Kind.SKY_OVERCAST,
                "cie-clear", Light.Kind.SKY_CLEAR, "uniform", Light.Kind.SKY_UNIFORM);

        @Override
        String expected() {
            return "cie-overcast, cie-clear or uniform, each with =lx or without";
        }

        @Override
        public Map.Entry<Light.Kind, Double> parse(String text) {
            String[] words = text.split("=", 2);
            double lux = words.length == 1 ? USUAL_SKY : Values.decimal(words[1]);
            return SKIES.containsKey(words[0]) && lux > 0 ? Map.entry(SKIES.get(words[0]), lux) : null;
        }
    }

    /** Parses {@code <x,y,z> <lx>}. */
    static final class SunConsumer implements IParameterConsumer {

        private static final String TWO = "a direction x,y,z and an illuminance in lx, like 1,2,1 50000";

        @Override
        public void consumeParameters(Stack<String> arguments, ArgSpec option, CommandSpec command) {
            Arguments.once(option);
            String direction = Arguments.next(arguments, option, TWO);
            String lux = Arguments.next(arguments, option, TWO, direction);
            double[] x = Arrays.stream(direction.split(",", -1)).mapToDouble(Values::decimal).toArray();
            Vec3 towards = x.length == 3 ? new Vec3(x[0], x[1], x[2]) : Vec3.ZERO;
            if (!towards.isFinite() || !(towards.length() > 0) || !(Values.decimal(lux) > 0)) {
                throw Arguments.wrong(option, "expected " + TWO + ", got " + direction + " " + lux);
            }
            option.setValue(Light.sun(towards, Values.decimal(lux)));
        }
    }

    /** The scene with the sky and the sun of the options, then photometric; the scene itself without sky and sun. */
    public Scene daylight(Scene scene) {
        if (sky == null && sun == null) {
            return scene;
        }
        Vec3 up = new Vec3(0, 1, 0);
        List<Light> all = new ArrayList<>(scene.lights());
        if (sun != null) {
            all.add(sun);
        }
        if (sky != null) {
            Vec3 towards = sun == null ? Vec3.ZERO : sun.direction().times(-1);
            if (sky.getKey() == Light.Kind.SKY_CLEAR && !(towards.y() > 0)) {
                throw Failure.commandLine("--sky", "expected cie-clear with --sun, above the horizon (y > 0), got "
                        + (sun == null ? "no sun" : "a sun below it"));
            }
            all.add(Light.sky(sky.getKey(), sky.getValue(), up, towards));
        }
        return scene.with(scene.surfaces(), all).with(scene.units().withPhotometric(true));
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
                .withLights(lights).withSrgb(srgb).withStrict(strict).withLuminaires(luminaires)
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
