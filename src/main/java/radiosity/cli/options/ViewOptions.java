package radiosity.cli.options;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import radiosity.edit.EditSource;
import radiosity.output.image.ToneMapping;
import radiosity.viewer.ViewSettings;

/** The command line of {@code ViewSceneFile} (appendix C.5 of the paper). */
@Command(name = "ViewSceneFile", sortOptions = false,
        customSynopsis = "ViewSceneFile [parameters] <Scene file>",
        description = "%nShows a scene file in a window in which the user walks with the arrow and Page Up/Down keys;"
                + " H shows all keys. The picture follows the file when a render replaces it.%n",
        footer = {"", "Exit codes: 0 closed; 1 no display; 2 wrong command line; 3 a file cannot be read or written."})
public final class ViewOptions {

    private static final String READING = "How to read the scene (-lw)";

    @Spec
    CommandSpec command;

    @Parameters(arity = "0..*", paramLabel = "<file>", hidden = true)
    List<Path> files = List.of();

    @Mixin(name = "What to show, and where")
    public final WindowOptions window = new WindowOptions();

    @Mixin(name = READING)
    public final SceneOptions scene = new SceneOptions();

    @Mixin(name = CommonOptions.GROUP)
    public final CommonOptions common = new CommonOptions();

    /** Fails where options contradict each other, an option lacks one that it needs, or there is not one file. */
    public void check() {
        if (files.size() != 1) {
            String got = files.stream().map(Path::toString).collect(Collectors.joining(" "));
            throw Failure.commandLine("file", "expected one " + (window.lightWave ? "LightWave, glTF or OBJ" : "scene")
                    + " file, got "
                    + (got.isEmpty() ? "none" : got));
        }
        Failure.needs("--port", "--web", window.port != null && !window.web);
        for (OptionSpec option : command.mixins().get(READING).options()) {
            Failure.needs(option.longestName(), "-lw",
                    !window.lightWave && command.commandLine().getParseResult().hasMatchedOption(option));
        }
        scene.check();
        if (window.web && (window.size != null || window.lightWave || window.wireframe || window.textures
                || window.screenshot != null)) {
            throw Failure.commandLine("--web",
                    "expected without -lw, -wf, -ut, --size and --screenshot, got one of them");
        }
        if (window.source != null && (window.web || window.lightWave)) {
            throw Failure.commandLine("--source", "expected without -lw and --web, got one of them");
        }
        Failure.excludes("-ut", "-lw", window.textures && window.lightWave);
        if (window.screenshot != null && !window.screenshot.toString().toLowerCase(Locale.ROOT).endsWith(".png")) {
            throw Failure.commandLine("--screenshot", "expected a name that ends in .png, got " + window.screenshot);
        }
    }

    public Path file() {
        return files.get(0);
    }

    /** @param editing reads, for editing, the model and the calculation from which the scene file was made */
    public ViewSettings settings(Callable<EditSource> editing) {
        WindowOptions w = window;
        Optional<ToneMapping> unlit = w.lightWave
                ? Optional.of(new ToneMapping(ToneMapping.Operator.LINEAR, StrictMath.pow(2, w.exposure)))
                : Optional.empty();
        return new ViewSettings(file().getFileName() + " (H: keys, P: panel)", w.wireframe, w.textures, unlit, w.curve,
                w.exposure, w.size == null ? WindowOptions.USUAL_WIDTH : w.size.width(),
                w.size == null ? 0 : w.size.height(), w.lightWave ? Optional.empty() : Optional.of(file()),
                w.lightWave ? Optional.empty() : Optional.of(editing), Optional.ofNullable(w.screenshot));
    }
}
