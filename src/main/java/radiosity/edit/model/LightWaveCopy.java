package radiosity.edit.model;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.input.lightwave.lws.SceneParser;
import radiosity.scene.Affine;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Srgb;
import radiosity.scene.Surface;
import radiosity.settings.ReadOptions;

/**
 * The files of a copy of a LightWave scene in which edited objects are moved and edited surfaces are painted; an object
 * file with a painted surface is copied, too. All other bytes stay the same.
 */
final class LightWaveCopy {

    private final Path source;
    private final ReadOptions options;
    private final Scene before;
    private final Scene edited;
    private final Path target;
    private final List<LightWaveReader.Origin> origins;
    /** Contents of the files to be written, in this order: copies of objects, then the scene. */
    private final Map<Path, byte[]> files = new LinkedHashMap<>();

    private LightWaveCopy(Path source, ReadOptions options, Scene before, Scene edited, Path target)
            throws IOException {
        this.source = source;
        this.options = options;
        this.before = before;
        this.edited = edited;
        this.target = target;
        origins = LightWaveReader.origins(source, options);
    }

    /** Whether a file is a LightWave scene; a LightWave object is none. */
    static boolean isScene(Path source) throws IOException {
        return SceneParser.isScene(Files.readAllBytes(source));
    }

    /**
     * Returns the contents of the copy's files: copies of objects, then the scene.
     *
     * @param target the copy of the scene, in the directory of the source; copied objects are named after it
     * @throws IllegalArgumentException where LightWave's files cannot express the edits
     */
    static Map<Path, byte[]> of(Path source, ReadOptions options, Scene before, Scene edited, Path target)
            throws IOException {
        return new LightWaveCopy(source, options, before, edited, target).files();
    }

    private Map<Path, byte[]> files() throws IOException {
        MotionLines lines = new MotionLines(Files.readString(source, StandardCharsets.ISO_8859_1));
        for (int n = 0; n < origins.size(); n++) {
            move(n, lines);
        }
        paint(lines);
        files.put(target, lines.text().getBytes(StandardCharsets.ISO_8859_1));
        return files;
    }

    /** Changes the motion of an object whose position in its parent's space has changed. */
    private void move(int node, MotionLines lines) {
        Affine was = before.hierarchy().nodes().get(node).placement();
        Affine is = edited.hierarchy().nodes().get(node).placement();
        if (Arrays.equals(was.m(), is.m())) {
            return;
        }
        double[] m = is.times(was.inverse()).m();
        double turn = StrictMath.atan2(m[2], m[0]);
        double[] turned = {StrictMath.cos(turn), 0, StrictMath.sin(turn), 0, 1, 0, -StrictMath.sin(turn), 0,
            StrictMath.cos(turn)};
        for (int i = 0; i < turned.length; i++) {
            if (!(Math.abs(m[i / 3 * 4 + i % 3] - turned[i]) < ModelCopy.SAME)) {
                throw new IllegalArgumentException(edited.hierarchy().nodes().get(node).name()
                        + ": expected a turn about its parent's vertical axis, got another");
            }
        }
        double heading = Math.abs(turn) < ModelCopy.SAME ? 0 : -turn;
        double[] at = heading == 0 ? new double[3] : lines.position(origins.get(node).line());
        at[2] = 0 - at[2];
        double[] by = new double[3];
        for (int k = 0; k < 3; k++) {
            by[k] = heading == 0 ? m[4 * k + 3]
                    : m[4 * k] * at[0] + m[4 * k + 1] * at[1] + m[4 * k + 2] * at[2] + m[4 * k + 3] - at[k];
        }
        by[2] = 0 - by[2];
        lines.add(origins.get(node).line(), by, heading);
    }

    private void paint(MotionLines lines) throws IOException {
        Map<Path, byte[]> painted = new LinkedHashMap<>();
        for (int s = 0; s < before.surfaces().size(); s++) {
            Surface was = before.surfaces().get(s);
            Surface is = edited.surfaces().get(s);
            if (was.reflectance().equals(is.reflectance())) {
                continue;
            }
            if (is.emits()) {
                throw new IllegalArgumentException(is.name() + ": expected a surface that emits nothing to paint, got"
                        + " a lamp, whose light has its colour");
            }
            Rgb rho = is.reflectance();
            Rgb colour = !options.srgb() ? rho
                    : new Rgb(Srgb.code(rho.r()), Srgb.code(rho.g()), Srgb.code(rho.b()));
            for (Path file : files(s)) {
                byte[] object = painted.containsKey(file) ? painted.get(file) : Files.readAllBytes(file);
                String inFile = is.name().startsWith(file.getFileName() + ":")
                        ? is.name().substring(file.getFileName().toString().length() + 1) : is.name();
                painted.put(file, SurfaceChunks.painted(object, inFile, colour));
            }
        }
        String suffix = "-" + stem(target.getFileName().toString());
        painted.forEach((file, bytes) -> {
            String name = file.getFileName().toString();
            files.put(file.resolveSibling(stem(name) + suffix + ".lwo"), bytes);
            for (LightWaveReader.Origin origin : origins) {
                if (origin.file().isPresent() && origin.file().get().equals(file)) {
                    lines.file(origin.line(), origin.written(), stem(origin.written()) + suffix + ".lwo");
                }
            }
        });
    }

    private static String stem(String name) {
        return name.replaceFirst("\\.[A-Za-z0-9]{1,4}$", "");
    }

    /** Returns the files of the objects that have a surface. */
    private TreeSet<Path> files(int surface) {
        TreeSet<Path> found = new TreeSet<>();
        for (int t = 0; t < before.triangles(); t++) {
            if (before.surfaceOf()[t] == surface) {
                origins.get(before.hierarchy().of(t)).file().ifPresent(found::add);
            }
        }
        return found;
    }
}
