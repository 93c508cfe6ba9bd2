package radiosity.testkit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import radiosity.scene.Hierarchy;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/** What a user does to a scene between two renders. */
public final class Edits {

    private Edits() { }

    /** Triangles of objects whose names begin so, and of what belongs to them. */
    public static IntPredicate object(Scene scene, String name) {
        Hierarchy hierarchy = scene.hierarchy();
        return t -> {
            for (int n = hierarchy.of(t); n >= 0; n = hierarchy.nodes().get(n).parent()) {
                if (hierarchy.nodes().get(n).name().startsWith(name)) {
                    return true;
                }
            }
            return false;
        };
    }

    /** Triangles of a surface. */
    public static IntPredicate surface(Scene scene, String name) {
        return t -> scene.surface(t).name().equals(name);
    }

    public static Scene moved(Scene scene, IntPredicate which, Vec3 by) {
        double[] points = Arrays.copyOf(scene.points(), 2 * scene.points().length);
        int count = scene.points().length / 3;
        for (int p = 0; p < count; p++) {
            for (int a = 0; a < 3; a++) {
                points[3 * (count + p) + a] = points[3 * p + a] + by.coordinate(a);
            }
        }
        int[] corners = scene.corners().clone();
        for (int i = 0; i < corners.length; i++) {
            corners[i] += which.test(i / 3) ? count : 0;
        }
        return new Scene(scene.name(), points, corners, scene.surfaceOf(), scene.surfaces(), scene.lights(),
                scene.camera(), scene.textureCoordinates(), scene.vertexColours(), scene.hierarchy(), scene.units());
    }

    /** Of scenes without texture coordinates and colours at vertices. */
    public static Scene without(Scene scene, IntPredicate which) {
        int[] kept = IntStream.range(0, scene.triangles()).filter(which.negate()).toArray();
        int[] corners = IntStream.of(kept).flatMap(t -> Arrays.stream(scene.corners(), 3 * t, 3 * t + 3)).toArray();
        int[] surfaceOf = IntStream.of(kept).map(t -> scene.surfaceOf()[t]).toArray();
        Hierarchy before = scene.hierarchy();
        Hierarchy hierarchy = before.nodes().isEmpty() ? before
                : new Hierarchy(before.nodes(), IntStream.of(kept).map(before::of).toArray());
        return new Scene(scene.name(), scene.points(), corners, surfaceOf, scene.surfaces(), scene.lights(),
                scene.camera(), new float[0], new float[0], hierarchy, scene.units());
    }

    /** Some triangles with a surface of their own that reflects something else. */
    public static Scene repainted(Scene scene, IntPredicate which, Rgb reflectance) {
        List<Surface> surfaces = new ArrayList<>(scene.surfaces());
        int[] surfaceOf = scene.surfaceOf().clone();
        for (int t = 0; t < surfaceOf.length; t++) {
            if (which.test(t)) {
                Surface s = scene.surface(t);
                if (surfaces.size() == scene.surfaces().size()) {
                    surfaces.add(new Surface("repainted " + s.name(), s.exitance(), reflectance, s.twoSided()));
                }
                surfaceOf[t] = surfaces.size() - 1;
            }
        }
        return new Scene(scene.name(), scene.points(), scene.corners(), surfaceOf, surfaces, scene.lights(),
                scene.camera(), scene.textureCoordinates(), scene.vertexColours(), scene.hierarchy(), scene.units());
    }

    public static Scene with(Scene scene, String surface, UnaryOperator<Surface> other) {
        List<Surface> surfaces = new ArrayList<>();
        for (Surface s : scene.surfaces()) {
            surfaces.add(s.name().equals(surface) ? other.apply(s) : s);
        }
        return scene.with(surfaces, scene.lights());
    }
}
