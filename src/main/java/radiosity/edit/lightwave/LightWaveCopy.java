package radiosity.edit.lightwave;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.input.lightwave.lws.SceneParser;
import radiosity.output.file.AtomicFile;
import radiosity.scene.Affine;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Srgb;
import radiosity.scene.Surface;
import radiosity.settings.ReadOptions;

/**
 * Writes a copy of a LightWave scene in which edited objects are moved and edited surfaces are painted; an object file
 * with a painted surface is copied, too. All other bytes stay the same. The copy is read again and deleted where it is
 * not the edited scene, because an object's motion follows from more than its keys.
 */
public final class LightWaveCopy {

    /** Tolerance of rotations and reflectances, and of positions relative to the largest coordinate. */
    private static final double SAME = 1e-6;

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

    /**
     * Writes the copy.
     *
     * @param source  the original LightWave scene
     * @param options options with which the source was read and the copy is read again
     * @param before  scene read from the source
     * @param edited  the same triangles, with objects moved and surfaces painted
     * @param target  the copy: a file that does not exist, in the directory of the source; copied objects are named
     *                after it
     * @return all files written
     * @throws SceneFormatException where LightWave's files cannot express the edits; no file is left then
     */
    public static List<Path> write(Path source, ReadOptions options, Scene before, Scene edited, Path target)
            throws IOException {
        byte[] bytes = Files.readAllBytes(source);
        if (!SceneParser.isScene(bytes)) {
            throw new SceneFormatException(source.toString(), "", "a LightWave scene (.lws) to save a copy of",
                    "another format");
        }
        if (!target.toAbsolutePath().getParent().equals(source.toAbsolutePath().getParent())) {
            throw new SceneFormatException(target.toString(), "", "a copy beside " + source
                    + ", as its objects are found from there", "another directory");
        }
        try {
            return new LightWaveCopy(source, options, before, edited, target).write(bytes);
        } catch (IllegalArgumentException e) {
            throw new SceneFormatException(source.toString(), "", "edits that LightWave's files can say",
                    e.getMessage());
        }
    }

    private List<Path> write(byte[] scene) throws IOException {
        MotionLines lines = new MotionLines(new String(scene, StandardCharsets.ISO_8859_1));
        for (int n = 0; n < origins.size(); n++) {
            move(n, lines);
        }
        paint(lines);
        files.put(target, lines.text().getBytes(StandardCharsets.ISO_8859_1));
        List<Path> written = new ArrayList<>();
        boolean isKept = false;
        try {
            for (Map.Entry<Path, byte[]> file : files.entrySet()) {
                if (Files.exists(file.getKey())) {
                    throw new IllegalArgumentException("expected a free name, got " + file.getKey());
                }
                AtomicFile.write(file.getKey(), file.getValue());
                written.add(file.getKey());
            }
            check(LightWaveReader.read(target, options, line -> { }));
            isKept = true;
        } finally {
            for (Path file : isKept ? List.<Path>of() : written) {
                Files.deleteIfExists(file);
            }
        }
        return List.copyOf(files.keySet());
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
            if (!(Math.abs(m[i / 3 * 4 + i % 3] - turned[i]) < SAME)) {
                throw new IllegalArgumentException(edited.hierarchy().nodes().get(node).name()
                        + ": expected a turn about its parent's vertical axis, got another");
            }
        }
        double heading = Math.abs(turn) < SAME ? 0 : -turn;
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

    private void check(Scene read) {
        boolean isSame = read.triangles() == edited.triangles()
                && read.surfaces().size() == edited.surfaces().size();
        double most = 0;
        for (double x : edited.points()) {
            most = Math.max(most, Math.abs(x));
        }
        for (int i = 0; i < 3 * read.triangles() && isSame; i++) {
            isSame = read.corner(i / 3, i % 3).minus(edited.corner(i / 3, i % 3)).length() <= SAME * most;
        }
        for (int s = 0; s < read.surfaces().size() && isSame; s++) {
            Surface a = read.surfaces().get(s);
            Surface b = edited.surfaces().get(s);
            for (int c = 0; c < 3; c++) {
                isSame &= Math.abs(a.reflectance().channel(c) - b.reflectance().channel(c)) < SAME
                        && a.exitance().channel(c) == b.exitance().channel(c);
            }
        }
        if (!isSame) {
            throw new IllegalArgumentException("what was moved or painted follows from more than keys and colours");
        }
    }
}
