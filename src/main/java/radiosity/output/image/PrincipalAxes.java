package radiosity.output.image;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.IntStream;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.Aabb;

/**
 * Three unit directions at right angles along which most of a scene's surface faces, right-handed.
 *
 * @param right the remaining direction, towards +X in a scene that stands upright
 * @param up    the direction of the three that is nearest to +Y
 * @param front the direction of the two others that is nearest to +Z
 */
record PrincipalAxes(Vec3 right, Vec3 up, Vec3 front) {

    private static final Vec3 X = new Vec3(1, 0, 0);
    private static final Vec3 Y = new Vec3(0, 1, 0);
    private static final Vec3 Z = new Vec3(0, 0, 1);
    static final PrincipalAxes WORLD = new PrincipalAxes(X, Y, Z);

    /** Unit normals count as one direction if their coordinates round to the same multiples of 1 over this. */
    private static final int CELLS = 16;
    /** Largest cosine between two directions that count as being at right angles. */
    private static final double RIGHT_ANGLE = 0.1;
    /** Axes whose cosines with the world's axes are larger than this are replaced by the world's axes. */
    private static final double SAME = 1 - 1e-9;

    /**
     * Twice the area of triangles that face in about one direction or away from it; the same area times their normals.
     */
    private static final class Direction {
        private Vec3 sum = Vec3.ZERO;
        private double weight;
    }

    /** The axes along which most area faces; the world's axes if the scene has no area. */
    static PrincipalAxes of(Scene scene) {
        Map<Vec3, Direction> directions = new LinkedHashMap<>();
        for (int t = 0; t < scene.triangles(); t++) {
            Vec3 cross = scene.cross(t);
            add(directions, cross);
            add(directions, cross.times(-1));
        }
        Vec3 first = largest(directions, Vec3.ZERO);
        if (first == null) {
            return WORLD;
        }
        Vec3 second = largest(directions, first);
        if (second == null) {
            second = Math.abs(first.y()) < Math.abs(first.x()) || Math.abs(first.y()) < Math.abs(first.z()) ? Y : Z;
        }
        second = second.minus(first.times(first.dot(second))).unit();
        return ordered(new Vec3[] {first, second, first.cross(second)});
    }

    private static void add(Map<Vec3, Direction> directions, Vec3 cross) {
        double length = cross.length();
        if (!(length > 0)) {
            return;
        }
        Vec3 n = cross.times(CELLS / length);
        Vec3 cell = new Vec3(Math.rint(n.x()) + 0.0, Math.rint(n.y()) + 0.0, Math.rint(n.z()) + 0.0);
        Direction direction = directions.computeIfAbsent(cell, none -> new Direction());
        direction.sum = direction.sum.plus(cross);
        direction.weight += length;
    }

    /**
     * The direction of most area at right angles to another direction; null if there is none.
     *
     * @param other unit direction, or zero for any direction
     */
    private static Vec3 largest(Map<Vec3, Direction> directions, Vec3 other) {
        Vec3 largest = null;
        double most = 0;
        for (Direction direction : directions.values()) {
            Vec3 axis = direction.sum.unit();
            if (direction.weight > most && Math.abs(axis.dot(other)) < RIGHT_ANGLE) {
                largest = axis;
                most = direction.weight;
            }
        }
        return largest;
    }

    private static PrincipalAxes ordered(Vec3[] axes) {
        int u = 0;
        for (int a = 1; a < 3; a++) {
            u = Math.abs(axes[a].y()) > Math.abs(axes[u].y()) ? a : u;
        }
        int f = (u + 1) % 3;
        int g = (u + 2) % 3;
        f = Math.abs(axes[g].z()) > Math.abs(axes[f].z()) ? g : f;
        Vec3 up = axes[u].times(axes[u].y() < 0 ? -1 : 1);
        Vec3 front = axes[f].times(axes[f].z() < 0 ? -1 : 1);
        return up.y() > SAME && front.z() > SAME ? WORLD : new PrincipalAxes(up.cross(front), up, front);
    }

    /** The point or direction that has given coordinates along the axes. */
    Vec3 at(Vec3 c) {
        return right.times(c.x()).plus(up.times(c.y())).plus(front.times(c.z()));
    }

    /**
     * The smallest box along the axes round points; its corners are coordinates along the axes.
     *
     * @param points x, y, z, 3 per point; not modified
     */
    Aabb box(double[] points) {
        return Aabb.of(IntStream.range(0, points.length / 3)
                .mapToObj(i -> coordinates(new Vec3(points[3 * i], points[3 * i + 1], points[3 * i + 2]))));
    }

    /** Coordinates along the axes of a point or direction. */
    Vec3 coordinates(Vec3 v) {
        return new Vec3(v.dot(right), v.dot(up), v.dot(front));
    }

    /** The direction nearest to a vector: 0 for right, 2 for up, 4 for front, 1 more for the opposite direction. */
    int nearest(Vec3 v) {
        double[] c = {v.dot(right), v.dot(up), v.dot(front)};
        int a = 0;
        for (int i = 1; i < 3; i++) {
            a = Math.abs(c[i]) > Math.abs(c[a]) ? i : a;
        }
        return 2 * a + (c[a] < 0 ? 1 : 0);
    }
}
