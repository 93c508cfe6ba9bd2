package radiosity.benchmark;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import radiosity.visibility.RadiosityBounds;

/**
 * Rays per CPU-second on files of shadow rays, beside Embree's single rays in the same run: {@code scripts/bench rays
 * <folder> [scene ...]}.
 *
 * <p>The folder is a built copy of {@code ../shared/peers}: rays/SCENE.tri, rays/SCENE_coh.bin, rays/SCENE_inc.bin and
 * scripts/raybench3. What they hold stands in its RAYS.md.
 */
public final class RayFiles {

    private static final List<String> SCENES = List.of("box38", "mesh10k", "mesh100k", "mesh1m");
    private static final int TURNS = 3;
    private static final int PASSES = 5;
    private static final Pattern SPEED = Pattern.compile("cpu-s med +([0-9.]+)");
    private static final Pattern HITS = Pattern.compile("hits (\\d+)");

    private final Path folder;
    private final String scene;
    /** Middle of the scene, and its size. */
    private final double[] middle = new double[3];
    private double size;
    private RadiosityBounds bounds;

    private RayFiles(Path folder, String scene) {
        this.folder = folder;
        this.scene = scene;
    }

    public static void main(String[] arguments) throws IOException, InterruptedException {
        Locale.setDefault(Locale.ROOT);
        List<String> scenes = List.of(arguments).subList(1, arguments.length);
        System.out.printf("%-13s %9s %9s %9s %6s %9s %9s%n", "rays", "triangles", "Mray/s", "Embree", "ratio", "hits",
                "of Embree");
        for (String scene : scenes.isEmpty() ? SCENES : scenes) {
            RayFiles files = new RayFiles(Path.of(arguments[0]), scene);
            files.build();
            files.compare("coh");
            files.compare("inc");
        }
    }

    private ByteBuffer read(String name) throws IOException {
        return ByteBuffer.wrap(Files.readAllBytes(folder.resolve("rays").resolve(name)))
                .order(ByteOrder.LITTLE_ENDIAN);
    }

    private void build() throws IOException {
        ByteBuffer in = read(scene + ".tri");
        double[] points = new double[3 * in.getInt()];
        float[] corners = new float[9 * in.getInt()];
        for (int i = 0; i < points.length; i++) {
            points[i] = in.getFloat();
        }
        for (int a = 0; a < 3; a++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = a; i < points.length; i += 3) {
                low = Math.min(low, points[i]);
                high = Math.max(high, points[i]);
            }
            middle[a] = (low + high) / 2;
            size = Math.max(size, high - low);
        }
        for (int i = 0; i < corners.length; i += 3) {
            int point = in.getInt();
            for (int a = 0; a < 3; a++) {
                corners[i + a] = unit(points[3 * point + a], a);
            }
        }
        bounds = new RadiosityBounds(corners);
    }

    private float unit(double x, int axis) {
        return (float) ((x - middle[axis]) / size);
    }

    /** Both programs take turns, so that what else the machine does meets both. */
    private void compare(String order) throws IOException, InterruptedException {
        float[] ends = ends(order);
        int rays = ends.length / 6;
        double ours = 0;
        double others = 0;
        int hits = blocked(ends);
        String answer = "";
        for (int turn = 0; turn < TURNS; turn++) {
            for (int pass = 0; pass < PASSES; pass++) {
                ours = Math.max(ours, rays / seconds(ends) * 1e-6);
            }
            answer = embree(order);
            others = Math.max(others, Double.parseDouble(found(SPEED, answer)));
        }
        System.out.printf("%-13s %9d %9.2f %9.2f %6.3f %9d %9s%n", scene + " " + order, bounds.size(), ours, others,
                ours / others, hits, found(HITS, answer));
    }

    private float[] ends(String order) throws IOException {
        FloatBuffer in = read(scene + "_" + order + ".bin").asFloatBuffer();
        float[] ends = new float[in.remaining() / 7 * 6];
        float[] ray = new float[7];
        for (int i = 0; i < ends.length; i += 6) {
            in.get(ray);
            for (int a = 0; a < 3; a++) {
                ends[i + a] = unit(ray[a], a);
                ends[i + 3 + a] = unit(ray[a] + (double) ray[3 + a] * ray[6], a);
            }
        }
        return ends;
    }

    private double seconds(float[] ends) {
        ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long start = thread.getCurrentThreadCpuTime();
        blocked(ends);
        return (thread.getCurrentThreadCpuTime() - start) * 1e-9;
    }

    private int blocked(float[] e) {
        int n = 0;
        for (int i = 0; i < e.length; i += 6) {
            n += bounds.blocked(e[i], e[i + 1], e[i + 2], e[i + 3], e[i + 4], e[i + 5]) ? 1 : 0;
        }
        return n;
    }

    /** One thread, one ray at a time, fast mode. */
    private String embree(String order) throws IOException, InterruptedException {
        Path rays = folder.resolve("rays");
        Process run = new ProcessBuilder(folder.resolve("scripts/raybench3").toString(),
                rays.resolve(scene + ".tri").toString(), rays.resolve(scene + "_" + order + ".bin").toString(),
                "1", "1", "0", order.equals("coh") ? "1" : "0", "3").start();
        String answer = new String(run.getInputStream().readAllBytes());
        run.waitFor();
        return answer;
    }

    private static String found(Pattern pattern, String answer) {
        Matcher matcher = pattern.matcher(answer);
        return matcher.find() ? matcher.group(1) : "NaN";
    }
}
