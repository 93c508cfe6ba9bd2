package radiosity.benchmark;

import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import radiosity.mesh.face.Faces;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.testkit.RoomScenes;
import radiosity.visibility.RadiosityBounds;

/**
 * Rays per second and core in the closed Cornell box with its blocks: {@code scripts/bench RayBenchmark}.
 *
 * <p>Coherent: neighbouring receiving points take turns at 16 points of one patch. Incoherent: any two points of walls.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Fork(2)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class RayBenchmark {

    private static final int RAYS = 1 << 20;

    @Param({"coherent", "incoherent"})
    public String order;

    private RadiosityBounds bounds;
    private final float[] ends = new float[6 * RAYS];

    /** The same rays every time. */
    @Setup
    public void aim() {
        Scene scene = RoomScenes.closedCornell(RoomScenes.grey("wall", 0, 0.5));
        Faces faces = new Faces(scene);
        bounds = new RadiosityBounds(faces.occluders());
        Random random = new Random(1);
        boolean coherent = order.equals("coherent");
        int shooter = 0;
        for (int r = 0; r < RAYS; r++) {
            int receiver = coherent ? r / 16 % 1024 : random.nextInt(1 << 16);
            shooter = coherent ? r / (16 * 1024) : random.nextInt(1 << 16);
            put(6 * r, onWall(0, (receiver % 32 + 0.5) / 32, (receiver / 32 % 32 + 0.5) / 32, faces));
            double u = (shooter % 8 + random.nextDouble()) / 8;
            double v = (shooter / 8 % 8 + random.nextDouble()) / 8;
            put(6 * r + 3, onWall(coherent ? 1 + shooter / 64 % 5 : 1 + random.nextInt(5), u, v, faces));
        }
    }

    private static Vec3 onWall(int wall, double u, double v, Faces faces) {
        double x = 0.002 + 0.552 * u;
        double y = 0.002 + 0.552 * v;
        double[][] at = {{x, 0.001, y}, {x, 0.548, y}, {0.001, x, y}, {0.555, x, y}, {x, y, 0.001}, {x, y, 0.558}};
        double[] p = at[wall];
        return faces.unit(new Vec3(Math.min(p[0], 0.555), Math.min(p[1], 0.548), p[2]));
    }

    private void put(int at, Vec3 p) {
        ends[at] = (float) p.x();
        ends[at + 1] = (float) p.y();
        ends[at + 2] = (float) p.z();
    }

    /** Number of rays that are blocked. */
    @Benchmark
    @OperationsPerInvocation(RAYS)
    public int blocked() {
        int n = 0;
        for (int i = 0; i < ends.length; i += 6) {
            n += bounds.blocked(ends[i], ends[i + 1], ends[i + 2], ends[i + 3], ends[i + 4], ends[i + 5]) ? 1 : 0;
        }
        return n;
    }
}
