package radiosity.cli;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.BindException;
import java.util.Optional;
import radiosity.cli.options.CommandRun;
import radiosity.cli.options.Failure;
import radiosity.cli.options.ViewOptions;
import radiosity.cli.render.FileChecks;
import radiosity.cli.render.SceneSource;
import radiosity.cli.render.Warnings;
import radiosity.input.SceneReader;
import radiosity.output.gltf.LitScene;
import radiosity.output.image.SurfaceMaps;
import radiosity.viewer.DisplayException;
import radiosity.viewer.Walkthrough;
import radiosity.viewer.web.WebPage;

/** The program that displays a scene file and lets the user walk through it (appendix C.4 of the paper). */
public final class ViewSceneFile {

    private final ViewOptions options;
    private final Warnings warnings;

    private ViewSceneFile(ViewOptions options) {
        this.options = options;
        warnings = new Warnings(System.err::println, options.scene.strict);
    }

    public static void main(String[] arguments) {
        int exitCode = run(arguments);
        // at the end of the process JogAmp prints a list of the display connections that Java 3D leaves open
        System.setErr(new PrintStream(OutputStream.nullOutputStream()));
        System.exit(exitCode);
    }

    /**
     * Runs the program without ending the process.
     *
     * @return the exit code
     */
    public static int run(String... arguments) {
        ViewOptions options = new ViewOptions();
        return CommandRun.of(options, options.common, () -> {
            options.check();
            new ViewSceneFile(options).view();
        }, arguments);
    }

    private void view() throws IOException {
        FileChecks checks = new FileChecks();
        checks.input(options.file());
        if (options.window.source != null) {
            checks.input(options.window.source);
        }
        if (options.window.screenshot != null) {
            checks.output(options.window.screenshot);
        }
        if (options.window.web) {
            serve();
            return;
        }
        LitScene scene = scene();
        if (options.window.textures && scene.textures().isEmpty()) {
            throw Failure.file(options.file(), "expected textures (RadiosityRenderer -ut <n>), got none", null);
        }
        try {
            Walkthrough.show(scene, options.settings(() -> SceneSource.read(options.file(),
                    Optional.ofNullable(options.window.source), warnings::print)));
        } catch (DisplayException e) {
            throw Failure.failed(e.getMessage(), e);
        }
    }

    /** Serves the web page until the process is ended, for example by Ctrl-C. */
    private void serve() throws IOException {
        try (WebPage page = new WebPage(options.file(), options.window.curve, options.window.exposure,
                options.window.port())) {
            System.out.println(page.address());
            Thread.sleep(Long.MAX_VALUE);
        } catch (BindException e) {
            throw Failure.failed("--port: expected a free port, got " + options.window.port() + ", which is in use", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private LitScene scene() throws IOException {
        return options.window.lightWave ? LitScene.unlit(SurfaceMaps.read(
                SceneReader.read(options.file(), options.scene.readOptions(), warnings::print), options.scene.srgb,
                        warnings::accept))
                : LitScene.read(options.file());
    }
}
