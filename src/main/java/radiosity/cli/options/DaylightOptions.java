package radiosity.cli.options;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Stack;
import picocli.CommandLine.IParameterConsumer;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import radiosity.scene.Light;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;

/** Options for the sky and the sun around a scene. */
public final class DaylightOptions {

    private static final double USUAL_SKY = 10_000;

    @Option(names = "--sky", paramLabel = "<sky[=lx]>", converter = SkyParser.class,
            description = "A sky around the scene: cie-overcast, cie-clear (with --sun) or uniform; with the"
                    + " illuminance of a level place in the open, 10000 lx without. Up is y.")
    Map.Entry<Light.Kind, Double> sky;

    @Option(names = "--sun", paramLabel = "<x,y,z> <lx>", arity = "2", hideParamSyntax = true,
            parameterConsumer = SunConsumer.class,
            description = "The sun: the direction towards it, and the illuminance of a place that faces it.")
    Light sun;

    /** Whether a sky or a sun is asked for, whose light is photometric. */
    boolean isWanted() {
        return sky != null || sun != null;
    }

    /** The scene with the sky and the sun of the options, then photometric; the scene itself without sky and sun. */
    public Scene around(Scene scene) {
        if (!isWanted()) {
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
                        + (sun == null ? "no sun" : "a sun on it"));
            }
            all.add(Light.sky(sky.getKey(), sky.getValue(), up, towards));
        }
        return scene.with(scene.surfaces(), all).with(scene.units().withPhotometric(true));
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
            String[] two = Arguments.two(arguments, option, TWO);
            double[] x = Arrays.stream(two[0].split(",", -1)).mapToDouble(Values::decimal).toArray();
            double lux = Values.decimal(two[1]);
            Vec3 towards = x.length == 3 ? new Vec3(x[0], x[1], x[2]) : Vec3.ZERO;
            if (!towards.isFinite() || !(towards.length() > 0) || !(lux > 0)) {
                throw Arguments.wrong(option, "expected " + TWO + ", got " + String.join(" ", two));
            }
            if (towards.y() < 0) {
                throw Arguments.wrong(option, "expected a sun above the horizon (y is up), got one at " + two[0]);
            }
            option.setValue(Light.sun(towards, lux));
        }
    }
}
