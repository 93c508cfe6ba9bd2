package radiosity.cli.render;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import radiosity.cli.options.ErrorReport;
import radiosity.cli.options.Failure;
import radiosity.cli.options.FileOptions;
import radiosity.cli.options.RendererOptions;
import radiosity.cli.options.TimeLimit;
import radiosity.cli.terminal.StopRequest;
import radiosity.gltf.GltfModel;
import radiosity.input.SceneReader;
import radiosity.output.file.AtomicFile;
import radiosity.output.gltf.SceneFile;
import radiosity.output.grid.Grid;
import radiosity.output.image.FalseColour;
import radiosity.output.image.Snapshot;
import radiosity.output.lightmap.Lightmap;
import radiosity.output.model.LightmapModel;
import radiosity.output.model.SceneModel;
import radiosity.output.points.Points;
import radiosity.scene.Camera;
import radiosity.scene.ImageMap;
import radiosity.scene.ImageSource;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.settings.RadiositySettings;
import radiosity.solution.Certificate;
import radiosity.solution.Solution;
import radiosity.util.TooLargeException;

/** Checks the input and output files that the command line names, and writes the outputs. */
public final class OutputFiles {

    private final RendererOptions options;
    private final List<String> arguments;
    private final FileChecks checks = new FileChecks();
    /** Camera of all snapshots of a render; null before the first one. */
    private Camera snapshotCamera;

    /** @param arguments the command line, which is stored in the scene file */
    public OutputFiles(RendererOptions options, List<String> arguments) {
        this.options = options;
        this.arguments = arguments;
    }

    /**
     * These files for the result of a time limit; the scene file keeps a command line that reproduces the result.
     *
     * @param same options that take the place of the time limit
     */
    OutputFiles reproducedBy(List<String> same) {
        return new OutputFiles(options, TimeLimit.reproducing(arguments, same));
    }

    /**
     * Checks all files of the command line before the scene is read.
     *
     * @throws Failure where an input cannot be read, or an output cannot be written or would overwrite another file
     */
    public void check() throws IOException {
        checks.input(options.input());
        if (options.file.points != null) {
            checks.input(options.file.points.in());
            Points.check(options.file.points.in());
        }
        options.scene.luminaires.values().forEach(checks::input);
        Stream.ofNullable(options.host.key).forEach(checks::input);
        checks.output(options.output());
        // after the scene file, which alone may replace these files
        Stream.ofNullable(options.file.resume).map(FileOptions.Resume::file).forEach(checks::input);
        Stream.ofNullable(options.file.change).forEach(checks::input);
        checks.reserve(Journal.of(options.output()), "the journal of " + options.output());
        if (options.picture.snapshotInterval != null) {
            checks.reserveSnapshots(options.output());
        }
        options.picture.pictures.forEach(checks::output);
        options.picture.falseColours.forEach(checks::output);
        if (options.file.points != null) {
            checks.output(options.file.points.out());
        }
        options.file.grids.forEach(grid -> checks.output(grid.out()));
        Stream.ofNullable(options.file.report).forEach(checks::output);
        if (options.file.lightmap != null) {
            checks.output(options.file.lightmap);
            checks.output(LightmapModel.beside(options.file.lightmap));
        }
    }

    /** Fails where an output would overwrite an image of the scene, or a grid has no points; called before any work. */
    public void check(Scene scene) {
        for (FileOptions.GridFile grid : options.file.grids) {
            try {
                Grid.check(scene, grid.where(), options.file.spacing);
            } catch (IllegalArgumentException e) {
                throw Failure.commandLine("--grid", e.getMessage());
            }
        }
        scene.surfaces().stream().flatMap(surface -> surface.textures().stream()).map(ImageMap::image)
                .filter(image -> image.content().isEmpty()).map(ImageSource::name).distinct().map(Path::of)
                .forEach(checks::partOfScene);
    }

    /**
     * Writes the scene file. The old file stays until the new one is complete; a scene file with textures is first
     * written without them.
     *
     * @param certificate empty while the calculation goes on, or where it was stopped
     */
    public void saveScene(Solution solution, RadiositySettings settings, Optional<Certificate> certificate)
            throws IOException {
        Map<String, Object> extras = new TreeMap<>();
        extras.put("commandLine", arguments);
        extras.put("settings", SavedCalculation.asJson(settings));
        certificate.ifPresent(c -> extras.put("certificate", c));
        saveScene(solution, extras, OptionalDouble.empty());
        if (options.textures != null) {
            saveScene(solution, extras, OptionalDouble.of(options.textures)); // an interruption leaves the first file
        }
    }

    private void saveScene(Solution solution, Map<String, Object> extras, OptionalDouble textures) throws IOException {
        write(options.output(), file -> SceneFile.write(file, solution, extras, solution.scene().camera(),
                options.picture.toneMapping(solution, Optional.empty()), textures));
    }

    /**
     * Writes the picture of {@code -sn}.
     *
     * @param goOn asked during the drawing; the picture is left out where the answer is false
     * @param user receives a message where the picture is left out
     */
    void saveSnapshot(Solution solution, BooleanSupplier goOn, Consumer<String> user) throws IOException {
        if (snapshotCamera == null) {
            snapshotCamera = options.picture.camera(solution);
        }
        savePicture(solution, () -> snapshotCamera, Path.of(options.output() + "-" + solution.shots() + ".jpg"),
                done -> goOn.getAsBoolean(), user);
    }

    /**
     * Writes all outputs but the scene file at the end of a render; each is attempted whatever becomes of the others.
     *
     * @param failures to which the failures of these outputs are added
     * @param user     shows the progress of pictures that take long; is closed
     * @param stop     a request ends the drawing of pictures; the unfinished ones are not written
     */
    public void saveRest(Solution solution, Summary summary, Failures failures, ConsoleSession user,
                         StopRequest stop) {
        stop.renew("leaving out the pictures that are not finished");
        boolean isLong = options.picture.gathered() > 0 || Snapshot.isTraced(solution);
        try (user) {
            if (isLong && !options.picture.pictures.isEmpty()) {
                user.begin();
            }
            List<Path> pictures = options.picture.pictures;
            for (int i = 0; i < pictures.size(); i++) {
                Path picture = pictures.get(i);
                double before = i;
                failures.tried(() -> savePicture(solution, () -> options.picture.camera(solution), picture, done -> {
                    user.part("drawing " + picture.getFileName(), done, (before + done) / pictures.size());
                    return !stop.made();
                }, user::message));
            }
        }
        for (Path picture : options.picture.falseColours) {
            failures.tried(() -> write(picture, file -> FalseColour.write(file, solution,
                    options.picture.camera(solution), options.picture.width(), options.calculation.threads)));
        }
        if (options.file.points != null) {
            failures.tried(() -> write(options.file.points.out(), out -> {
                long missed = new Points(solution).write(options.file.points.in(), out);
                if (missed > 0) {
                    user.message(options.file.points.in() + ": " + missed
                            + (missed == 1 ? " point lies on no surface, and has no light"
                            : " points lie on no surface, and have no light"));
                }
            }));
        }
        if (options.file.lightmap != null) {
            failures.tried(() -> write(options.file.lightmap, file -> saveLightmap(file, solution)));
        }
        for (FileOptions.GridFile grid : options.file.grids) {
            failures.tried(() -> saveGrid(solution, grid));
        }
        if (options.file.report != null) {
            failures.tried(() -> write(options.file.report, file -> AtomicFile.write(file,
                    new ObjectMapper().writerWithDefaultPrettyPrinter().writeValueAsBytes(summary.asJson()))));
        }
    }

    private void saveGrid(Solution solution, FileOptions.GridFile file) throws IOException {
        write(file.out(), out -> {
            Grid grid = Grid.of(solution, file.where(), options.file.spacing, options.calculation.threads);
            grid.write(out);
            System.out.println(SceneFormatException.escape(grid.summary()));
        });
    }

    private void savePicture(Solution solution, Supplier<Camera> camera, Path file,
                             Snapshot.Drawing.Progress progress, Consumer<String> user) throws IOException {
        try {
            Camera eye = camera.get();
            write(file, picture -> Snapshot.write(picture, solution, eye, options.picture.width(),
                    options.picture.toneMapping(solution, Optional.of(eye)),
                    new Snapshot.Drawing(options.picture.gathered(), options.calculation.threads, progress)));
        } catch (CancellationException e) {
            user.accept(file + ": left out, as it was not wanted any more");
        }
    }

    private void saveLightmap(Path file, Solution solution) throws IOException {
        OptionalDouble texels = Stream.ofNullable(options.file.lightmapTexels).mapToDouble(n -> n).findFirst();
        Optional<GltfModel> original = SceneReader.original(options.input(), options.readOptions(),
                solution.scene());
        GltfModel model = original.isPresent() ? original.get() : SceneModel.of(solution.scene());
        LightmapModel.write(file, model, Lightmap.of(solution, texels),
                options.picture.toneMapping(solution, Optional.of(options.picture.camera(solution))).exposure());
    }

    /** Writes one file. */
    private interface Content {
        void writeTo(Path file) throws IOException;
    }

    /** Writes a file; a failure names the file, which the messages of a full disk or a full memory do not. */
    private static void write(Path file, Content content) throws IOException {
        try {
            content.writeTo(file);
        } catch (SceneFormatException e) {
            throw e;
        } catch (OutOfMemoryError | TooLargeException e) {
            throw Failure.failed(file + ": expected to be written, got " + ErrorReport.line(e), e);
        } catch (IOException e) {
            throw Failure.file(file, "expected to be written, got " + ErrorReport.reason(e), e);
        }
    }
}
