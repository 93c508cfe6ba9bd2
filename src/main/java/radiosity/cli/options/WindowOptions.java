package radiosity.cli.options;

import java.nio.file.Path;
import picocli.CommandLine.Option;
import radiosity.output.image.ToneMapping;

/** Options for what {@code ViewSceneFile} shows, and where (appendix C.5 of the paper). */
public final class WindowOptions {

    static final int USUAL_WIDTH = 800;
    private static final int USUAL_PORT = 8080;

    @Option(names = {"-wf", "--wireframe"}, description = "Use wireframes.")
    boolean wireframe;

    @Option(names = {"-ut", "--use-textures"},
            description = "Use textures. Only if the scene was rendered with -ut.")
    public boolean textures;

    @Option(names = {"-lw", "--lightwave"}, description = "View a LightWave, glTF or OBJ file, not lit.")
    public boolean lightWave;

    @Option(names = "--source", paramLabel = "<file>",
            description = "What the scene file was made from, for editing (M). Default: what its command line says,"
                    + " from here or beside the scene file.")
    public Path source;

    @Option(names = "--screenshot", paramLabel = "<file.png>",
            description = "Write a picture of the window and close it.")
    public Path screenshot;

    @Option(names = "--size", paramLabel = "<WxH>", converter = PictureSize.Parser.class,
            description = "Size of the picture in pixels. Default: " + USUAL_WIDTH + " wide, as high as the scene's"
                    + " camera has it.")
    PictureSize size;

    @Option(names = "--exposure", paramLabel = "<stops>", converter = PictureOptions.Stops.class,
            description = "How much brighter than chosen from the scene, in stops; each doubles. Default: 0.")
    public double exposure;

    @Option(names = "--tone-mapping", paramLabel = "<curve>", converter = PictureOptions.CurveParser.class,
            description = "From radiosity to screen: linear, reinhard (default) or filmic.")
    public ToneMapping.Operator curve = ToneMapping.Operator.REINHARD;

    @Option(names = "--web", description = "Serve a page for a browser on this machine instead of a window, until the"
            + " program is ended.")
    public boolean web;

    @Option(names = "--port", paramLabel = "<n>", converter = Values.AnyPort.class,
            description = "Where to serve it, 0 for any free port. Default: " + USUAL_PORT + ".")
    Integer port;

    /** Port on which to serve the page; 0 for any free port. */
    public int port() {
        return port == null ? USUAL_PORT : port;
    }
}
