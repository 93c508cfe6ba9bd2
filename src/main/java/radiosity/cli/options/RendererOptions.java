package radiosity.cli.options;

import static java.util.stream.Collectors.joining;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import radiosity.rmi.HostAddress;
import radiosity.settings.ReadOptions;

/** The command line of {@code RadiosityRenderer} (appendix C.1 of the paper). */
@Command(name = "RadiosityRenderer", sortOptions = false,
        customSynopsis = "RadiosityRenderer [parameters] <LightWave Scene> <output Scene file>",
        description = "%nRenders a scene (LightWave, glTF or OBJ) by progressive radiosity and writes a scene file, a"
                + " glTF 2.0 binary that ViewSceneFile and every glTF viewer open.%n",
        footer = {"",
            "Press any key to stop after the current iteration and save.",
            "",
            "Exit codes: 0 done, also when stopped by a key; 1 failed; 2 wrong command line; 3 a file cannot be read"
                + " or written; 4 no host could be used; 5 less exact than --accuracy asked for; 130, 143 saved after"
                + " Ctrl-C, SIGTERM, or left to the journal (with --time: as saved last) after 9 s."})
public final class RendererOptions {

    @Parameters(arity = "0..*", paramLabel = "<files>", hidden = true)
    public List<Path> files = List.of();

    @Mixin(name = "How finely to calculate, and when to stop")
    public final CalculationOptions calculation = new CalculationOptions();

    @Mixin(name = "What to save, and from where to go on")
    public final FileOptions file = new FileOptions();

    @Mixin(name = "Pictures")
    public final PictureOptions picture = new PictureOptions();

    @Mixin(name = "How to read the scene")
    public final SceneOptions scene = new SceneOptions();

    @Mixin(name = "Daylight")
    public final DaylightOptions daylight = new DaylightOptions();

    @Mixin(name = "Distributed mode")
    public final HostOptions host = new HostOptions();

    @Option(names = {"-ut", "--use-textures"}, paramLabel = "<n>", converter = Values.Positive.class,
            description = "Use textures with n samples per world coordinate.")
    public Double textures;

    @Option(names = {"-q", "--quiet"}, description = "Quiet mode: no progress; warnings and the summary remain.")
    public boolean quiet;

    @Option(names = "--statistics", description = "With -h: print what is calculated where, a line per host now and "
            + "then and a table at the end.")
    public boolean statistics;

    @Mixin(name = CommonOptions.GROUP)
    public final CommonOptions common = new CommonOptions();

    /** Names of pictures, of scenes to read, and of other files that are no scene files. */
    private static final Pattern PICTURE = Pattern.compile("(?i).*\\.(png|jpe?g|hdr|exr|gif|bmp|tiff?|webp)");
    private static final Pattern MODEL = Pattern.compile("(?i).*\\.(lws|lwo|gltf|glb|obj)");
    private static final Pattern OTHER =
            Pattern.compile("(?i).*\\.(lws|lwo|obj|mtl|gltf|bin|ies|ldt|fbx|csv|txt|json|key)");

    @Spec
    CommandSpec command;

    /** How the scene is read: as photometric, too, where daylight is added, whose light is photometric. */
    public ReadOptions readOptions() {
        ReadOptions options = scene.readOptions();
        return daylight.isWanted() ? options.withUnits(options.units().withPhotometric(true)) : options;
    }

    /** Fails where options contradict each other, an option lacks one that it needs, or there are not two files. */
    public void check() {
        scene.check();
        file.check();
        calculation.check();
        Failure.needs("-key", "-h", host.key != null && host.hosts == null);
        Failure.needs("--statistics", "-h", statistics && host.hosts == null);
        if (file.report != null && MODEL.matcher(file.report.toString()).matches()) {
            throw Failure.commandLine("--report", "expected a file to write, such as a.json, got " + file.report);
        }
        if (calculation.time != null) {
            checkTime();
        }
        if (file.disableRendering) {
            checkDisabled();
        }
        picture.check();
        if (files.size() != 2 || files.stream().anyMatch(file -> file.toString().isEmpty())) {
            String got = files.stream().map(file -> file.toString().isEmpty() ? "\"\"" : file.toString())
                    .collect(joining(" "));
            throw Failure.commandLine("files", "expected a scene to read and a scene file to write, got "
                    + (got.isEmpty() ? "none" : got) + (host.hosts == null || files.size() == 2 ? ""
                    : "; hosts are " + host.hosts.stream().map(HostAddress::toString).collect(joining(", "))));
        }
        checkOutput(output().toString());
        if (file.frames != null) {
            checkFrames();
        }
    }

    private static void checkOutput(String name) {
        if (PICTURE.matcher(name).matches()) {
            throw Failure.commandLine(name, "expected a scene file to write, such as a.scene, got the name of a"
                    + " picture; --picture " + name + " writes one besides");
        }
        if (OTHER.matcher(name).matches()) {
            throw Failure.commandLine(name, "expected a scene file to write, such as a.scene, got the name of another"
                    + " kind of file; the scene to read comes first");
        }
    }

    /** The scene file that {@code --info} describes; fails where the command line asks for anything else. */
    public Path described() {
        for (OptionSpec other : command.commandLine().getParseResult().matchedOptions()) {
            if (!other.longestName().equals("--info") && !other.longestName().equals("--debug")) {
                throw Failure.commandLine("--info", "expected alone, got " + other.shortestName() + ", too");
            }
        }
        if (!files.isEmpty()) {
            throw Failure.commandLine("--info", "expected one scene file and nothing else, got " + files.get(0)
                    + ", too");
        }
        return file.info;
    }

    /** Fails for options that have no effect without rendering. */
    private void checkDisabled() {
        Failure.excludes("-dr", "-si", file.saveInterval != null);
        Failure.excludes("-dr", "-sn", picture.snapshotInterval != null);
    }

    /** Fails for options that exclude a time limit, which chooses the accuracy and calculates several times. */
    private void checkTime() {
        Failure.excludes(TimeLimit.OPTION, "--accuracy", calculation.accuracy != null);
        Failure.excludes(TimeLimit.OPTION, "-dr", file.disableRendering);
        Failure.excludes(TimeLimit.OPTION, "-si", file.saveInterval != null);
        Failure.excludes(TimeLimit.OPTION, "-sn", picture.snapshotInterval != null);
        Failure.excludes(TimeLimit.OPTION, "-tf", file.resume != null);
        Failure.excludes(TimeLimit.OPTION, "--change", file.change != null);
    }

    /** Fails where an option excludes {@code --frames}, or the scene is no LightWave scene and so has no frames. */
    private void checkFrames() {
        Failure.excludes("--frames", "--frame", scene.frame != null);
        Failure.excludes("--frames", "-tf", file.resume != null);
        Failure.excludes("--frames", TimeLimit.OPTION, calculation.time != null);
        Failure.excludes("--frames", "-dr", file.disableRendering);
        Failure.excludes("--frames", "--grid", !file.grids.isEmpty());
        if (!input().toString().toLowerCase(Locale.ROOT).endsWith(".lws")) {
            throw Failure.commandLine("--frames", "expected a LightWave scene (.lws), got " + input());
        }
    }

    /**
     * Changes these options to those of one frame of {@code --frames}; the number of the frame is added to output
     * names.
     *
     * @param before scene file of the frame before, to go on from; null for none
     */
    public void toFrame(int frame, Path before) {
        scene.frame = (double) frame;
        file.change = before;
        files = List.of(input(), FrameRange.numbered(output(), frame));
        picture.pictures.replaceAll(name -> FrameRange.numbered(name, frame));
        picture.falseColours.replaceAll(name -> FrameRange.numbered(name, frame));
        file.lightmap = file.lightmap == null ? null : FrameRange.numbered(file.lightmap, frame);
        file.report = file.report == null ? null : FrameRange.numbered(file.report, frame);
        file.points = file.points == null ? null
                : new FileOptions.PointFiles(file.points.in(), FrameRange.numbered(file.points.out(), frame));
    }

    /** The files to write besides the scene file, but for grids. */
    public List<Path> otherOutputs() {
        List<Path> all = new ArrayList<>(picture.pictures);
        all.addAll(picture.falseColours);
        Stream.of(file.lightmap, file.report, file.points == null ? null : file.points.out()).filter(Objects::nonNull)
                .forEach(all::add);
        return all;
    }

    /** The scene to render. */
    public Path input() {
        return files.get(0);
    }

    /** The scene file to write. */
    public Path output() {
        return files.get(1);
    }
}
