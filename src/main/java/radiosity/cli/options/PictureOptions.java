package radiosity.cli.options;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import picocli.CommandLine.Option;
import radiosity.output.image.DefaultCamera;
import radiosity.output.image.Snapshot;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Camera;
import radiosity.solution.Solution;

/** Options for pictures that are drawn without a display. */
public final class PictureOptions {

    private static final int USUAL_WIDTH = 800;

    @Option(names = {"-sn", "--snapshot-interval"}, paramLabel = "<n>", converter = Values.AtLeastOne.class,
            description = "Snapshot: a JPEG picture <output>-<iteration>.jpg every n:th iteration.")
    public Integer snapshotInterval;

    @Option(names = "--picture", paramLabel = "<file>",
            description = "Picture of the solution, .png, .jpg or (unclamped radiosities) .hdr. Repeatable.")
    public List<Path> pictures = new ArrayList<>();

    @Option(names = "--false-colour", paramLabel = "<file.png>",
            description = "Picture of illuminance in colours, with a legend and lines of equal illuminance."
                    + " Repeatable.")
    public List<Path> falseColours = new ArrayList<>();

    @Option(names = "--size", paramLabel = "<WxH>", converter = PictureSize.Parser.class,
            description = "Size of pictures in pixels. Default: " + USUAL_WIDTH + " wide, as high as the scene's"
                    + " camera has it.")
    public PictureSize size;

    @Option(names = "--exposure", paramLabel = "<stops>", converter = Stops.class,
            description = "How much brighter than chosen from the solution, in stops; each doubles. Default: 0.")
    double exposure;

    @Option(names = "--tone-mapping", paramLabel = "<curve>", converter = CurveParser.class,
            description = "From radiosity to screen: linear, reinhard (default) or filmic.")
    ToneMapping.Operator curve = ToneMapping.Operator.REINHARD;

    @Option(names = "--final-gather", paramLabel = "<n>", converter = GatherRays.class,
            description = "In pictures, find the light that arrives by n rays per pixel, so that no mesh shows: 64 for"
                    + " a look, 1024 for a smooth picture.")
    Integer finalGather;

    /** Parses a number of rays. */
    static final class GatherRays extends Values.Whole {
        GatherRays() {
            super("a whole number from 1 to " + Snapshot.Drawing.MOST_GATHERED, 1, Snapshot.Drawing.MOST_GATHERED);
        }
    }

    /** Number of rays per pixel that gather light; 0 where light is interpolated in the mesh. */
    public int gathered() {
        return finalGather == null ? 0 : finalGather;
    }

    /** Parses {@code linear}, {@code reinhard} and {@code filmic}. */
    static final class CurveParser extends Values.Choice<ToneMapping.Operator> {
        CurveParser() {
            super(ToneMapping.Operator.class);
        }
    }

    /** Parses a number of stops. */
    static final class Stops extends Values.Decimal {
        Stops() {
            super("a number from -100 to 100", x -> Math.abs(x) <= 100);
        }
    }

    /** The scene's camera, or one chosen for the solution; {@code --size}, where given, defines its aspect ratio. */
    public Camera camera(Solution solution) {
        Camera camera = DefaultCamera.of(solution);
        return size == null ? camera : new Camera(camera.position(), camera.forward(), camera.up(),
                camera.verticalHalfAngle(), (double) size.width() / size.height());
    }

    /** Whether any option asks for a picture. */
    public boolean isWanted() {
        return !pictures.isEmpty() || !falseColours.isEmpty() || snapshotInterval != null;
    }

    /** Width of the pictures, pixels. */
    public int width() {
        return size == null ? USUAL_WIDTH : size.width();
    }

    /** The exposure of what is before a camera, or of all surfaces where there is none. */
    public ToneMapping toneMapping(Solution solution, Optional<Camera> camera) {
        return ToneMapping.automatic(curve, solution, camera, exposure);
    }

    /** Fails where a picture's name has the extension of no known format, or an option needs a picture and has none. */
    void check() {
        Failure.needs("--size", "--picture, --false-colour or -sn", size != null && !isWanted());
        Failure.needs("--final-gather", "--picture or -sn",
                finalGather != null && pictures.isEmpty() && snapshotInterval == null);
        for (Path picture : falseColours) {
            if (!picture.toString().toLowerCase(Locale.ROOT).endsWith(".png")) {
                throw Failure.commandLine("--false-colour", "expected a name that ends in .png, got " + picture);
            }
        }
        for (Path picture : pictures) {
            if (!picture.toString().toLowerCase(Locale.ROOT).matches(".*\\.(png|jpg|jpeg|hdr)")) {
                throw Failure.commandLine("--picture", "expected a name that ends in .png, .jpg or .hdr, got "
                        + picture);
            }
        }
    }
}
