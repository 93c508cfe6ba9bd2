package radiosity.testkit;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.List;
import java.util.Random;
import radiosity.mesh.face.Faces;
import radiosity.scene.Scene;
import radiosity.visibility.RadiosityBounds;

/** What is saved by leaving out the boxes of the hierarchy that are not worth their test; for scripts/performance. */
public final class SparedBoxes {

    private static final int RAYS = 1 << 21;
    private static final int TURNS = 5;

    private int hits = -1;

    private SparedBoxes() { }

    /** A line for each scene: the same rays between any two points in it, with every box and without those. */
    public static void print(List<Scene> scenes) {
        System.out.println("| scene | triangles | Mray/s, every box | as it is | bytes, every box | as it is |");
        System.out.println("|---|---|---|---|---|---|");
        for (Scene scene : scenes) {
            float[] corners = new Faces(scene).occluders();
            RadiosityBounds every = new RadiosityBounds(corners, false);
            RadiosityBounds spared = new RadiosityBounds(corners);
            double[] best = new double[2];
            SparedBoxes rays = new SparedBoxes();
            for (int turn = 0; turn < TURNS; turn++) {
                best[0] = Math.max(best[0], rays.speed(every));
                best[1] = Math.max(best[1], rays.speed(spared));
            }
            System.out.printf("| %s | %d | %.1f | %.1f | %d | %d |%n", scene.name(), spared.size(), best[0], best[1],
                    every.bytes(), spared.bytes());
        }
    }

    /** Millions of rays per CPU-second of this thread; all turns must have the same hits. */
    private double speed(RadiosityBounds bounds) {
        float[] end = new float[6 * RAYS];
        Random random = new Random(1);
        for (int i = 0; i < end.length; i++) {
            end[i] = random.nextFloat() - 0.5f;
        }
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        long begin = threads.getCurrentThreadCpuTime();
        int blocked = 0;
        for (int i = 0; i < end.length; i += 6) {
            blocked += bounds.blocked(end[i], end[i + 1], end[i + 2], end[i + 3], end[i + 4], end[i + 5]) ? 1 : 0;
        }
        double seconds = (threads.getCurrentThreadCpuTime() - begin) * 1e-9;
        if (hits >= 0 && blocked != hits) {
            throw new IllegalStateException("hits: expected " + hits + ", got " + blocked);
        }
        hits = blocked;
        return RAYS / seconds * 1e-6;
    }
}
