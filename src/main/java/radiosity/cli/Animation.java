package radiosity.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import radiosity.cli.options.CommandLineParser;
import radiosity.cli.options.ErrorReport;
import radiosity.cli.options.ExitCode;
import radiosity.cli.options.Failure;
import radiosity.cli.options.RendererOptions;
import radiosity.cli.render.Journal;
import radiosity.cli.terminal.StopRequest;
import radiosity.output.gltf.SceneFile;

/**
 * Renders the frames of a LightWave scene ({@code --frames}), each as a change of the solution of the frame before.
 *
 * <p>The same command, given again, renders only the frames that are not done. A frame is done if its scene file has a
 * certificate, keeps the same command line, and is not older than the input scene.
 */
final class Animation {

    private final List<String> arguments;
    private final StopRequest stop;
    private final Renderer renderer;

    /** Renders one frame. */
    interface Renderer {
        void render(RendererOptions frame) throws IOException;
    }

    Animation(List<String> arguments, StopRequest stop, Renderer renderer) {
        this.arguments = arguments;
        this.stop = stop;
        this.renderer = renderer;
    }

    /**
     * Renders the frames that are not done, in their order, while no stop is requested.
     *
     * @throws Failure after the last frame, where frames missed the accuracy that {@code --accuracy} asks for
     */
    void render(RendererOptions options) throws IOException {
        int[] frames = options.file.frames.all();
        List<Exception> inexact = new ArrayList<>();
        Path before = options.file.change;
        int there = 0;
        for (int i = 0; i < frames.length && !stop.everMade(); i++) {
            RendererOptions frame = new RendererOptions();
            new CommandLineParser(frame).parse(arguments.toArray(String[]::new));
            frame.toFrame(frames[i], before);
            before = frame.output();
            if (isThere(frame)) {
                there++;
            } else {
                System.err.println("frame " + frames[i] + " (" + (i + 1) + " of " + frames.length + ")");
                stop.begin();
                try {
                    renderer.render(frame);
                } catch (Failure e) {
                    if (e.exitCode() != ExitCode.NOT_ACCURATE) {
                        throw e;
                    }
                    System.err.println(ErrorReport.line(e));
                    inexact.add(e);
                }
            }
        }
        if (there > 0) {
            System.err.println(there + " of " + frames.length + " frames were there, newer than " + options.input()
                    + "; delete their files to render them anew, as after a change of an object's file");
        }
        if (!inexact.isEmpty()) {
            throw Failure.notAccurate(inexact.size() + " of " + frames.length + " frames are less exact than"
                    + " --accuracy asked for");
        }
    }

    private boolean isThere(RendererOptions frame) throws IOException {
        if (!Files.isRegularFile(frame.output()) || Files.exists(Journal.of(frame.output()))
                || !frame.otherOutputs().stream().allMatch(Files::isRegularFile)
                || Files.getLastModifiedTime(frame.output()).compareTo(Files.getLastModifiedTime(frame.input())) < 0) {
            return false;
        }
        try (SceneFile file = SceneFile.open(frame.output())) {
            return arguments.equals(file.extras().get("commandLine")) && file.extras().containsKey("certificate");
        }
    }
}
