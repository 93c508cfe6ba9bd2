package radiosity.cli;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import radiosity.output.Points;
import radiosity.output.SceneFile;
import radiosity.output.Snapshot;
import radiosity.scene.Camera;
import radiosity.scene.SceneFormatException;
import radiosity.world.Certificate;
import radiosity.world.RadiositySettings;
import radiosity.world.Solution;

/** What a render reads and writes, as the command line names it. */
final class OutputFiles {

    private final RendererOptions options;
    private final List<String> arguments;
    /** The same for all pictures of a render; null before the first. */
    private Camera camera;

    /** @param arguments of the command line, for the scene file */
    OutputFiles(RendererOptions options, List<String> arguments) {
        this.options = options;
        this.arguments = arguments;
    }

    /** The same for what a time limit led to: the scene file tells how it is made again. */
    OutputFiles accurate(String perCent) {
        return new OutputFiles(options, TimeLimit.reproducing(arguments, perCent));
    }

    /** Fails where something cannot be read or written, before any work. */
    void check() throws IOException {
        FileChecks checks = new FileChecks();
        checks.input(options.input());
        if (options.file.points != null) {
            checks.input(options.file.points.in());
            Points.check(options.file.points.in());
        }
        if (options.file.resume != null) {
            new FileChecks().input(options.file.resume.file());
        }
        checks.output(options.output());
        options.picture.pictures.forEach(checks::output);
        if (options.file.points != null) {
            checks.output(options.file.points.out());
        }
        if (options.file.report != null) {
            checks.output(options.file.report);
        }
    }

    /** The scene file: the old one stays until the new one is whole, and one without textures until they are. */
    void saveScene(Solution solution, RadiositySettings settings, Optional<Certificate> certificate)
            throws IOException {
        Map<String, Object> extras = new TreeMap<>();
        extras.put("commandLine", arguments);
        extras.put("settings", SavedCalculation.asJson(settings));
        certificate.ifPresent(c -> extras.put("certificate", c));
        saveScene(solution, extras, OptionalDouble.empty());
        if (options.textures != null) {
            saveScene(solution, extras, OptionalDouble.of(options.textures)); // whatever ends this leaves the first
        }
    }

    private void saveScene(Solution solution, Map<String, Object> extras, OptionalDouble textures) throws IOException {
        write(options.output(), file -> SceneFile.write(file, solution, extras, solution.scene().camera(),
                options.picture.toneMapping(solution), textures));
    }

    /** The picture of {@code -sn}. */
    void saveSnapshot(Solution solution) throws IOException {
        savePicture(solution, Path.of(options.output() + "-" + solution.shots() + ".jpg"));
    }

    /** Everything that is written once, at the end; what can be, where not all can. */
    void saveRest(Solution solution, Summary summary) throws IOException {
        List<Task> tasks = new ArrayList<>();
        options.picture.pictures.forEach(picture -> tasks.add(() -> savePicture(solution, picture)));
        if (options.file.points != null) {
            tasks.add(() -> write(options.file.points.out(),
                    out -> new Points(solution).write(options.file.points.in(), out)));
        }
        if (options.file.report != null) {
            tasks.add(() -> write(options.file.report, file -> new ObjectMapper().writerWithDefaultPrettyPrinter()
                    .writeValue(file.toFile(), summary.asJson())));
        }
        Task.runAll(tasks);
    }

    private void savePicture(Solution solution, Path file) throws IOException {
        if (camera == null) {
            camera = options.picture.camera(solution);
        }
        write(file, picture -> Snapshot.write(picture, solution, camera, options.picture.width(),
                options.picture.toneMapping(solution)));
    }

    /** One of several things to save. */
    private interface Task {

        void run() throws IOException;

        /** Runs all of them, then throws what the first that failed threw. */
        static void runAll(List<Task> tasks) throws IOException {
            for (int i = 0; i < tasks.size(); i++) {
                try {
                    tasks.get(i).run();
                } catch (Failure | IOException e) {
                    runAll(tasks.subList(i + 1, tasks.size()));
                    throw e;
                }
            }
        }
    }

    /** What writes one file. */
    private interface Content {
        void writeTo(Path file) throws IOException;
    }

    /** Names the file where writing it fails: a full disk's message does not. */
    private static void write(Path file, Content content) throws IOException {
        try {
            content.writeTo(file);
        } catch (SceneFormatException e) {
            throw e;
        } catch (IOException e) {
            throw Failure.file(file, "expected to be written, got " + FileChecks.reason(e), e);
        }
    }
}
