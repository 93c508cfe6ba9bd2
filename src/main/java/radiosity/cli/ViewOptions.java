package radiosity.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import radiosity.output.ToneMapping;
import radiosity.viewer.ViewSettings;

/** The command line of {@link ViewSceneFile} (appendix C.5 of the paper). */
@Command(name = "ViewSceneFile", sortOptions = false, versionProvider = Version.class,
        customSynopsis = "ViewSceneFile [parameters] <Scene file>",
        description = "%nShows a scene file in a window in which the user walks with the arrow and Page Up/Down keys;"
                + " H shows all keys. The picture follows the file when a render replaces it.%n",
        footer = {"", "Exit codes: 0 closed; 1 no display; 2 wrong command line; 3 a file cannot be read or written."})
final class ViewOptions {

    private static final int USUAL_WIDTH = 800;

    @Parameters(arity = "0..*", paramLabel = "<file>", hidden = true)
    List<Path> files = List.of();

    @Option(names = {"-wf", "--wireframe"}, description = "Use wireframes.")
    boolean wireframe;

    @Option(names = {"-ut", "--use-textures"},
            description = "Use textures. Only if the scene was rendered with -ut.")
    boolean textures;

    @Option(names = {"-lw", "--lightwave"}, description = "View a LightWave file, not lit.")
    boolean lightWave;

    @Option(names = "--screenshot", paramLabel = "<file.png>",
            description = "Write a picture of the window and close it.")
    Path screenshot;

    @Option(names = "--size", paramLabel = "<WxH>", converter = PictureSize.Parser.class,
            description = "Size of the picture in pixels. Default: " + USUAL_WIDTH + " wide, as high as the scene's"
                    + " camera has it.")
    PictureSize size;

    @Option(names = "--exposure", paramLabel = "<stops>", converter = PictureOptions.Stops.class,
            description = "How much brighter than chosen from the scene, in stops; each doubles. Default: 0.")
    double exposure;

    @Option(names = "--tone-mapping", paramLabel = "<curve>", converter = PictureOptions.CurveParser.class,
            description = "From radiosity to screen: linear, reinhard (default) or filmic.")
    ToneMapping.Operator curve = ToneMapping.Operator.REINHARD;

    @Option(names = "--web", description = "Serve a page for a browser on this machine instead of a window, until the"
            + " program is ended.")
    boolean web;

    @Option(names = "--port", paramLabel = "<n>", converter = PortParser.class,
            description = "Where to serve it, 0 for any free port. Default: 8080.")
    int port = 8080;

    @Mixin(name = "How to read the LightWave scene (-lw)")
    final SceneOptions scene = new SceneOptions();

    @Option(names = "--debug", description = "Print where in the program an error came from.")
    boolean debug;

    @Option(names = "--help", usageHelp = true, description = "Print this help and exit.")
    boolean help;

    @Option(names = "--version", versionHelp = true, description = "Print the version and exit.")
    boolean version;

    /** Reads a port. */
    static final class PortParser extends Values.Value<Integer> {
        @Override
        String expected() {
            return "a port from 0 to 65535";
        }

        @Override
        Integer parse(String text) {
            return Values.whole(text, 0, 65535);
        }
    }

    /** Fails where the command line asks for what cannot be meant, or is not there. */
    void check() {
        if (files.size() != 1) {
            String got = files.stream().map(Path::toString).collect(Collectors.joining(" "));
            throw Failure.commandLine("file", "expected one " + (lightWave ? "LightWave" : "scene") + " file, got "
                    + (got.isEmpty() ? "none" : got));
        }
        if (web && (lightWave || wireframe || textures || screenshot != null)) {
            throw Failure.commandLine("--web", "expected without -lw, -wf, -ut and --screenshot, got one of them");
        }
        if (textures && lightWave) {
            throw Failure.commandLine("-ut", "expected without -lw, got both");
        }
        if (screenshot != null && !screenshot.toString().toLowerCase(Locale.ROOT).endsWith(".png")) {
            throw Failure.commandLine("--screenshot", "expected a name that ends in .png, got " + screenshot);
        }
    }

    Path file() {
        return files.get(0);
    }

    ViewSettings settings() {
        Optional<ToneMapping> unlit = lightWave
                ? Optional.of(new ToneMapping(ToneMapping.Operator.LINEAR, Math.pow(2, exposure))) : Optional.empty();
        return new ViewSettings(file().getFileName() + " (H: keys)", wireframe, textures, unlit, curve, exposure,
                size == null ? USUAL_WIDTH : size.width(), size == null ? 0 : size.height(),
                lightWave ? Optional.empty() : Optional.of(file()), Optional.ofNullable(screenshot));
    }
}
