package radiosity.output.gltf;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.EnergyLedger;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;

/** Solutions made by hand, element by element. */
public final class Handmade {

    static final EnergyLedger LEDGER = new EnergyLedger(new double[] {1, 2, 3}, new double[] {4, 5, 6},
            new double[] {3, 4, 5}, new double[] {.5, .6, .7}, new double[] {.1, -.2, .3});

    private final List<Surface> surfaces = new ArrayList<>();
    private final DoubleStream.Builder points = DoubleStream.builder();
    private final IntStream.Builder triangles = IntStream.builder();
    private final IntStream.Builder surfaceOf = IntStream.builder();
    private final DoubleStream.Builder positions = DoubleStream.builder();
    private final DoubleStream.Builder irradiance = DoubleStream.builder();
    private final IntStream.Builder corners = IntStream.builder();
    private final IntStream.Builder faceOf = IntStream.builder();
    private int pointCount;
    private int triangleCount;
    private int vertexCount;
    public byte[] state = {};
    String name = "by hand";

    public int surface(Surface surface) {
        surfaces.add(surface);
        return surfaces.size() - 1;
    }

    public int surface(String surfaceName, Rgb exitance, Rgb reflectance, boolean twoSided) {
        return surface(new Surface(surfaceName, exitance, reflectance, twoSided));
    }

    public int surface(String surfaceName, double reflectance) {
        return surface(surfaceName, Rgb.BLACK, Rgb.grey(reflectance), false);
    }

    /** An original triangle, visible from where a, b, c go round counter-clockwise; returns its number. */
    public int triangle(int surface, Vec3 a, Vec3 b, Vec3 c) {
        for (Vec3 p : List.of(a, b, c)) {
            points.add(p.x()).add(p.y()).add(p.z());
            triangles.add(pointCount++);
        }
        surfaceOf.add(surface);
        return triangleCount++;
    }

    public int vertex(Vec3 p, Rgb h) {
        positions.add(p.x()).add(p.y()).add(p.z());
        irradiance.add(h.r()).add(h.g()).add(h.b());
        return vertexCount++;
    }

    public void element(int face, int a, int b, int c) {
        corners.add(a).add(b).add(c);
        faceOf.add(face);
    }

    /** A parallelogram of 2 nu nv elements, visible from the side to which u x v points. */
    public Handmade grid(int surface, Vec3 at, Vec3 u, Vec3 v, int nu, int nv, Function<Vec3, Rgb> h) {
        int t = triangle(surface, at, at.plus(u), at.plus(u).plus(v));
        triangle(surface, at, at.plus(u).plus(v), at.plus(v));
        int[][] id = new int[nu + 1][nv + 1];
        for (int i = 0; i <= nu; i++) {
            for (int j = 0; j <= nv; j++) {
                Vec3 p = at.plus(u.times((double) i / nu)).plus(v.times((double) j / nv));
                id[i][j] = vertex(p, h.apply(p));
            }
        }
        for (int i = 0; i < nu; i++) {
            for (int j = 0; j < nv; j++) {
                element(2 * t, id[i][j], id[i + 1][j], id[i + 1][j + 1]);
                element(2 * t + 2, id[i][j], id[i + 1][j + 1], id[i][j + 1]);
            }
        }
        return this;
    }

    /** Six walls seen from inside, each its own surface, each divided differently. */
    public static Handmade room(Vec3 low, double size, Function<Vec3, Rgb> h) {
        Handmade room = new Handmade();
        Vec3 x = new Vec3(size, 0, 0);
        Vec3 y = new Vec3(0, size, 0);
        Vec3 z = new Vec3(0, 0, size);
        Rgb white = Rgb.grey(.7);
        room.grid(room.surface("floor", Rgb.BLACK, white, false), low, z, x, 1, 2, h);
        room.grid(room.surface("ceiling", Rgb.BLACK, white, false), low.plus(y), x, z, 3, 4, h);
        room.grid(room.surface("left", Rgb.BLACK, new Rgb(.6, .1, .1), false), low, y, z, 5, 3, h);
        room.grid(room.surface("right", Rgb.BLACK, new Rgb(.1, .6, .1), false), low.plus(x), z, y, 7, 2, h);
        room.grid(room.surface("back", Rgb.BLACK, white, false), low, x, y, 4, 6, h);
        room.grid(room.surface("front", Rgb.BLACK, white, false), low.plus(z), y, x, 8, 1, h);
        return room;
    }

    public Solution solution() {
        return solution(null);
    }

    public Solution solution(Camera camera) {
        Scene scene = new Scene(name, points.build().toArray(), triangles.build().toArray(),
                surfaceOf.build().toArray(), surfaces, List.of(), Optional.ofNullable(camera));
        return new Solution(scene, 3, positions.build().toArray(), irradiance.build().toArray(),
                corners.build().toArray(), faceOf.build().toArray(), 7, 5, .25, LEDGER,
                SavedState.of(List.of(state)));
    }

    /** Irradiance that differs everywhere and in every channel, W/m². */
    static Rgb light(Vec3 p) {
        return new Rgb(1 + Math.abs(p.x()), 2 + p.y() / 3, 1e-3 * (3 + p.z()));
    }

    /** A room of side 2 with a lamp under its ceiling, in that light. */
    public static Handmade litRoom(Vec3 low) {
        Handmade room = Handmade.room(low, 2, Handmade::light);
        room.grid(room.surface("lamp", new Rgb(100, 90, 80), Rgb.grey(.1), false), low.plus(new Vec3(.5, 1.9, .5)),
                new Vec3(1, 0, 0), new Vec3(0, 0, 1), 2, 2, Handmade::light);
        return room;
    }
}
