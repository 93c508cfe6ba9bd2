package radiosity.testkit;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.function.UnaryOperator;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/** The same scene elsewhere, in another size, turned, in another order or with other lamps. */
public final class Moves {

    private Moves() { }

    public static Scene scaled(Scene scene, double factor) {
        return points(scene, p -> p.times(factor));
    }

    public static Scene moved(Scene scene, Vec3 by) {
        return points(scene, p -> p.plus(by));
    }

    /** @param angle radians, around the diagonal (1, 1, 1) */
    public static Scene turned(Scene scene, double angle) {
        Vec3 axis = new Vec3(1, 1, 1).unit();
        return points(scene, p -> turned(p, axis, angle));
    }

    /** O. Rodrigues' formula. */
    static Vec3 turned(Vec3 p, Vec3 axis, double angle) {
        return p.times(Math.cos(angle)).plus(axis.cross(p).times(Math.sin(angle)))
                .plus(axis.times(axis.dot(p) * (1 - Math.cos(angle))));
    }

    private static Scene points(Scene scene, UnaryOperator<Vec3> move) {
        double[] points = scene.points().clone();
        for (int i = 0; i < points.length; i += 3) {
            Vec3 p = move.apply(new Vec3(points[i], points[i + 1], points[i + 2]));
            points[i] = p.x();
            points[i + 1] = p.y();
            points[i + 2] = p.z();
        }
        return new Scene(scene.name(), points, scene.corners(), scene.surfaceOf(), scene.surfaces(), scene.lights(),
                scene.camera());
    }

    /** Every surface as {@code change} makes it. */
    public static Scene painted(Scene scene, UnaryOperator<Surface> change) {
        return new Scene(scene.name(), scene.points(), scene.corners(), scene.surfaceOf(),
                scene.surfaces().stream().map(change).toList(), scene.lights(), scene.camera());
    }

    /** All lamps brighter by a factor. */
    public static Scene brighter(Scene scene, double factor) {
        return painted(scene, s -> with(s, s.exitance().times(factor), s.reflectance()));
    }

    /** The same surface with another exitance (W/m²) and reflectance. */
    public static Surface with(Surface surface, Rgb exitance, Rgb reflectance) {
        return new Surface(surface.name(), exitance, reflectance, surface.twoSided());
    }

    /** Triangles in another order, each beginning at another corner, and surfaces in reverse order. */
    public static Scene reordered(Scene scene, long seed) {
        Random random = new Random(seed);
        int n = scene.triangles();
        List<Integer> order = order(n, random);
        int[] corners = new int[3 * n];
        int[] surfaceOf = new int[n];
        for (int i = 0; i < n; i++) {
            int t = order.get(i);
            int first = random.nextInt(3);
            for (int k = 0; k < 3; k++) {
                corners[3 * i + k] = scene.corners()[3 * t + (first + k) % 3];
            }
            surfaceOf[i] = scene.surfaces().size() - 1 - scene.surfaceOf()[t];
        }
        List<Surface> surfaces = new ArrayList<>(scene.surfaces());
        Collections.reverse(surfaces);
        return new Scene(scene.name(), scene.points(), corners, surfaceOf, surfaces, scene.lights(), scene.camera());
    }

    private static List<Integer> order(int n, Random random) {
        List<Integer> order = new ArrayList<>();
        for (int i = 0; i < n; i++) {
            order.add(i);
        }
        Collections.shuffle(order, random);
        return order;
    }
}
