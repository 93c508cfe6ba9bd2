package radiosity.util;

import java.util.stream.IntStream;
import java.util.stream.Stream;
import radiosity.scene.Vec3;

/** The smallest axis-aligned box around some points. The box around no points is empty, at the origin. */
public record Aabb(Vec3 low, Vec3 high) {

    /** @param points x, y, z, 3 per point; not modified */
    public static Aabb of(double[] points) {
        return of(IntStream.range(0, points.length / 3)
                .mapToObj(i -> new Vec3(points[3 * i], points[3 * i + 1], points[3 * i + 2])));
    }

    /** The box around the points of a stream, which is read to its end. */
    public static Aabb of(Stream<Vec3> points) {
        return points.map(p -> new Aabb(p, p)).reduce(Aabb::with).orElse(new Aabb(Vec3.ZERO, Vec3.ZERO));
    }

    private static Vec3 lower(Vec3 p, Vec3 q) {
        return new Vec3(Math.min(p.x(), q.x()), Math.min(p.y(), q.y()), Math.min(p.z(), q.z()));
    }

    private static Vec3 higher(Vec3 p, Vec3 q) {
        return new Vec3(Math.max(p.x(), q.x()), Math.max(p.y(), q.y()), Math.max(p.z(), q.z()));
    }

    /** The smallest box around two boxes. */
    public Aabb with(Aabb other) {
        return new Aabb(lower(low, other.low), higher(high, other.high));
    }

    public Vec3 centre() {
        return low.times(0.5).plus(high.times(0.5));
    }

    /** Lengths along x, y and z. */
    public Vec3 extent() {
        return high.minus(low);
    }

    /** @param i bit 0 for high x, bit 1 for high y, bit 2 for high z */
    public Vec3 corner(int i) {
        return new Vec3((i & 1) == 0 ? low.x() : high.x(), (i & 2) == 0 ? low.y() : high.y(),
                (i & 4) == 0 ? low.z() : high.z());
    }

    public double diagonal() {
        return extent().length();
    }
}
