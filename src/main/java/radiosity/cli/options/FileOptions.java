package radiosity.cli.options;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.Stack;
import picocli.CommandLine.IParameterConsumer;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;

/** Options for further files to read and write, and for when to write them. */
public final class FileOptions {

    @Option(names = {"-dr", "--disable-rendering"},
            description = "Disable rendering: save the scene file as it is before the first iteration.")
    public boolean disableRendering;

    @Option(names = {"-si", "--save-interval"}, paramLabel = "<n>", converter = Values.AtLeastOne.class,
            description = "Save the scene file at every n:th iteration.")
    public Integer saveInterval;

    @Option(names = {"-tf", "--from"}, paramLabel = "<f> [<n>]", arity = "1..2", hideParamSyntax = true,
            parameterConsumer = ResumeConsumer.class,
            description = "Go on from the radiosity values of scene file f, counting iterations from n: the number"
                    + " that the file was saved with, which is taken where n is not given.")
    public Resume resume;

    @Option(names = "--change", paramLabel = "<old.scene>",
            description = "Go on from the scene file of an earlier state of the scene: only light that the change of"
                    + " objects, materials and lamps takes away or brings is calculated. With --schedule predict.")
    public Path change;

    @Option(names = "--frames", paramLabel = "<a-b[:n]>", converter = FrameRange.Parser.class,
            description = "LightWave: every n:th frame from a to b, each calculated from the one before (see --change);"
                    + " the names of all outputs get its number: out-0012.scene.")
    public FrameRange frames;

    @Option(names = "--points", paramLabel = "<in.csv> <out.csv>", arity = "2", hideParamSyntax = true,
            parameterConsumer = PointsConsumer.class,
            description = "Write radiosity and irradiance at points: in.csv has x, y, z, nx, ny, nz per line.")
    public PointFiles points;

    @Option(names = "--lightmap", paramLabel = "<file.glb>",
            description = "Write the scene's own model with a lightmap (see docs/RECIPES.md), and the lightmap"
                    + " beside it as <file>-lightmap.exr.")
    public Path lightmap;

    @Option(names = "--lightmap-texels", paramLabel = "<n>", converter = Values.Positive.class,
            description = "Texels of the lightmap per scene unit. Chosen from the scene without it.")
    public Double lightmapTexels;

    @Option(names = "--grid", paramLabel = "<where> <out.csv>", arity = "2", hideParamSyntax = true,
            parameterConsumer = GridConsumer.class,
            description = "Write illuminance on a grid of points, with average, minimum, maximum and uniformity: on a"
                    + " surface, by its name, or on a plane like y=0.85 (-y=0.85: from below). Repeatable.")
    public List<GridFile> grids = new ArrayList<>();

    @Option(names = "--spacing", paramLabel = "<length>", converter = Values.Positive.class,
            description = "With --grid: about how far apart its points are, scene units.")
    public Double spacing;

    @Option(names = "--info", paramLabel = "<file>", description = "Print what a scene file holds, and exit.")
    public Path info;

    @Option(names = "--report", paramLabel = "<file>", description = "Write figures about the solution as JSON.")
    public Path report;

    /** Fails where the options for changes, lightmaps or grids contradict each other or need another option. */
    void check() {
        Failure.excludes("--change", "-tf", change != null && resume != null);
        Failure.needs("--grid", "--spacing", !grids.isEmpty() && spacing == null);
        Failure.needs("--spacing", "--grid", spacing != null && grids.isEmpty());
        if (lightmap != null && !lightmap.toString().toLowerCase(Locale.ROOT).endsWith(".glb")) {
            throw Failure.commandLine("--lightmap", "expected a name that ends in .glb, got " + lightmap);
        }
        Failure.needs("--lightmap-texels", "--lightmap", lightmapTexels != null && lightmap == null);
    }

    /**
     * Where to go on from ({@code -tf}).
     *
     * @param file  a scene file
     * @param shots number of shots with which the file was saved; empty where the user does not give it
     */
    public record Resume(Path file, OptionalInt shots) { }

    /**
     * Points at which to write the solution ({@code --points}).
     *
     * @param in  table to read, x, y, z, nx, ny, nz per line
     * @param out table to write
     */
    public record PointFiles(Path in, Path out) { }

    /**
     * Grid on which to write the illuminance ({@code --grid}).
     *
     * @param where name of a surface, or a plane such as y=0.85
     * @param out   table to write
     */
    public record GridFile(String where, Path out) { }

    /** Parses {@code <where> <out.csv>}. */
    static final class GridConsumer implements IParameterConsumer {

        private static final String TWO = "a surface or plane and a table to write";

        @Override
        public void consumeParameters(Stack<String> arguments, ArgSpec option, CommandSpec command) {
            String[] two = Arguments.two(arguments, option, TWO);
            if (two[1].startsWith("-") || Arguments.isModel(two[1])) {
                throw Arguments.wrong(option, "expected " + TWO + ", got " + String.join(" ", two));
            }
            List<GridFile> all = new ArrayList<>(option.<List<GridFile>>getValue());
            all.add(new GridFile(two[0], Arguments.path(two[1], option)));
            option.setValue(all);
        }
    }

    /** Parses {@code <f> [<n>]}. */
    static final class ResumeConsumer implements IParameterConsumer {
        @Override
        public void consumeParameters(Stack<String> arguments, ArgSpec option, CommandSpec command) {
            Arguments.once(option);
            String file = Arguments.next(arguments, option, "a scene file");
            boolean given = !arguments.isEmpty() && arguments.peek().matches("[-+]?\\d+(\\.\\d*)?");
            OptionalInt shots = given
                    ? OptionalInt.of(Arguments.convert(new Values.Count(), arguments.pop(), option))
                    : OptionalInt.empty();
            option.setValue(new Resume(Arguments.path(file, option), shots));
        }
    }

    /** Parses {@code <in.csv> <out.csv>}. */
    static final class PointsConsumer implements IParameterConsumer {

        private static final String TWO = "a table of points to read and one to write";

        @Override
        public void consumeParameters(Stack<String> arguments, ArgSpec option, CommandSpec command) {
            Arguments.once(option);
            String[] two = Arguments.two(arguments, option, TWO);
            for (String file : two) {
                if (file.startsWith("-") || Arguments.isModel(file)) {
                    throw Arguments.wrong(option, "expected " + TWO + ", got " + String.join(" ", two));
                }
            }
            option.setValue(new PointFiles(Arguments.path(two[0], option), Arguments.path(two[1], option)));
        }
    }
}
