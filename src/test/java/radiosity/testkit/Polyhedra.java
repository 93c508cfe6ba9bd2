package radiosity.testkit;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/** Random closed polyhedra around the origin, of triangles seen from inside. A seed always gives the same one. */
public final class Polyhedra {

    private static final double GOLDEN = (1 + Math.sqrt(5)) / 2;

    private Polyhedra() { }

    /** Hulls for even seeds, stars for odd ones. */
    public static Scene random(long seed, Surface all) {
        return seed % 2 == 0 ? hull(seed, 8 + (int) (seed % 13), all) : star(seed, all);
    }

    /** The convex hull of random points on an ellipsoid: every three that have all others on one side. */
    static Scene hull(long seed, int count, Surface all) {
        Random random = new Random(seed);
        Vec3 axes = new Vec3(0.5 + random.nextDouble(), 0.5 + random.nextDouble(), 0.5 + random.nextDouble());
        List<Vec3> points = new ArrayList<>();
        while (points.size() < count) {
            Vec3 p = direction(random);
            points.add(new Vec3(p.x() * axes.x(), p.y() * axes.y(), p.z() * axes.z()));
        }
        return hull("hull " + seed, points, all);
    }

    private static Scene hull(String name, List<Vec3> points, Surface all) {
        SceneBuilder builder = new SceneBuilder();
        for (Vec3 a : points) {
            for (Vec3 b : points) {
                for (Vec3 c : points) {
                    if (isFace(points, a, b, c)) {
                        builder.polygon(all, a, b, c);
                    }
                }
            }
        }
        return builder.scene(name);
    }

    /** Whether a, b, c are in this order a face with all others before it; a comes first in the list. */
    private static boolean isFace(List<Vec3> points, Vec3 a, Vec3 b, Vec3 c) {
        int first = points.indexOf(a);
        if (points.indexOf(b) <= first || points.indexOf(c) <= first || b == c) {
            return false;
        }
        Vec3 normal = b.minus(a).cross(c.minus(a));
        return points.stream().allMatch(p -> p == a || p == b || p == c || normal.dot(p.minus(a)) > 0);
    }

    private static Vec3 direction(Random random) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
    }

    /** An icosahedron with every face cut in four and every point moved along its radius, to 0.6 to 1.4. */
    static Scene star(long seed, Surface all) {
        Random random = new Random(seed);
        Scene sphere = icosahedron(all);
        SceneBuilder finer = new SceneBuilder();
        for (int t = 0; t < sphere.triangles(); t++) {
            quarter(finer, all, sphere.corner(t, 0), sphere.corner(t, 1), sphere.corner(t, 2));
        }
        Scene round = finer.scene("star " + seed);
        double[] points = round.points();
        for (int i = 0; i < points.length; i += 3) {
            double radius = 0.6 + 0.8 * random.nextDouble();
            Vec3 p = new Vec3(points[i], points[i + 1], points[i + 2]).unit().times(radius);
            points[i] = p.x();
            points[i + 1] = p.y();
            points[i + 2] = p.z();
        }
        return round;
    }

    private static Scene icosahedron(Surface all) {
        List<Vec3> points = new ArrayList<>();
        for (int s = -1; s <= 1; s += 2) {
            for (int t = -1; t <= 1; t += 2) {
                points.add(new Vec3(0, s, t * GOLDEN));
                points.add(new Vec3(s, t * GOLDEN, 0));
                points.add(new Vec3(t * GOLDEN, 0, s));
            }
        }
        return hull("icosahedron", points, all);
    }

    private static void quarter(SceneBuilder builder, Surface all, Vec3 a, Vec3 b, Vec3 c) {
        Vec3 ab = a.plus(b).times(0.5);
        Vec3 bc = b.plus(c).times(0.5);
        Vec3 ca = c.plus(a).times(0.5);
        builder.polygon(all, a, ab, ca).polygon(all, ab, b, bc).polygon(all, ca, bc, c).polygon(all, ab, bc, ca);
    }
}
