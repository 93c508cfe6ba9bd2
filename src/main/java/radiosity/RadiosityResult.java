package radiosity;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import radiosity.output.gltf.SceneFile;
import radiosity.output.image.DefaultCamera;
import radiosity.output.image.Snapshot;
import radiosity.output.image.ToneMapping;
import radiosity.output.points.Points;
import radiosity.scene.Camera;
import radiosity.solution.Certificate;
import radiosity.solution.Progress;
import radiosity.solution.Solution;

/**
 * The result of a {@link Radiosity} calculation.
 *
 * @param solution    elements, vertices and the light at each vertex
 * @param certificate an estimate of the solution's error; empty where nothing was shot, no point is lit, or the
 *                    listener stopped the calculation after the last estimate
 * @param progress    state of the calculation when it ended
 */
public record RadiosityResult(Solution solution, Optional<Certificate> certificate, Progress progress) {

    /**
     * Writes the scene file, a glTF binary that any glTF viewer opens. An existing file is replaced as a whole or not
     * at all.
     *
     * @throws IOException where the file cannot be written; a {@link java.nio.channels.ClosedByInterruptException}
     *                     where the calling thread is interrupted
     */
    public void writeScene(Path file) throws IOException {
        Map<String, Object> extras = certificate.isPresent() ? Map.of("certificate", certificate.get()) : Map.of();
        SceneFile.write(file, solution, extras, solution.scene().camera(), ToneMapping.automatic(solution));
    }

    /**
     * Writes a picture in the format given by the end of the file's name: png and jpg tone-mapped, hdr in W/m².
     *
     * @param width width in pixels, at least 1; the height follows from the camera
     * @throws IllegalArgumentException where the width is below 1, or an array cannot hold the pixels
     * @throws IOException where the file cannot be written or its format is not known
     */
    public void writePicture(Path file, int width) throws IOException {
        writePicture(file, width, 0);
    }

    /**
     * Writes a picture for which light is gathered anew at every pixel (final gathering), so that no mesh shows.
     *
     * @param width    width in pixels, at least 1; the height follows from the camera
     * @param gathered rays per pixel for gathering, 256 for instance; 0: the light of the mesh is shown
     * @throws IllegalArgumentException where the width is below 1, or an array cannot hold the pixels
     * @throws IOException where the file cannot be written or its format is not known
     */
    public void writePicture(Path file, int width, int gathered) throws IOException {
        if (width < 1) {
            throw new IllegalArgumentException("picture: expected a width of at least 1, got " + width);
        }
        Camera camera = DefaultCamera.of(solution);
        Snapshot.write(file, solution, camera, width, ToneMapping.automatic(solution, camera),
                new Snapshot.Drawing(gathered, done -> true));
    }

    /** Gives the light at any points. Making the object takes time, so use one object for all points. */
    public Points points() {
        return new Points(solution);
    }
}
