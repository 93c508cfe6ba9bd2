package radiosity.input.polygon;

import java.util.Arrays;
import radiosity.input.file.FloatList;

/**
 * The corners of one polygon without repetitions and spikes, and their projection along the axis nearest to the
 * polygon's normal. The object is used again for each polygon.
 *
 * <p>A spike a-b-a, which goes out and back at once, encloses nothing; a bridge to a hole goes back later and stays.
 */
final class PolygonRing {

    /** Twice an area, relative to the square of the polygon's extent, below which the area is only rounding. */
    private static final double NO_AREA = 1e-13;

    /** Corner indices; the ring is the {@link #size} entries from {@link #first} on. */
    private int[] corners = new int[16];
    private int first;
    private int size;
    private int last;

    /** Projected coordinates relative to the first corner, counter-clockwise, 1 per corner of the ring. */
    double[] x = new double[16];
    double[] y = new double[16];
    /** Twice the projected area, above 0. */
    double area;

    private final FloatList points;
    private final Polygons polygons;

    PolygonRing(FloatList points, Polygons polygons) {
        this.points = points;
        this.polygons = polygons;
    }

    int size() {
        return size;
    }

    /** Index of the i-th corner of the ring among all corners of all polygons. */
    int corner(int i) {
        return corners[first + i];
    }

    /** Takes a polygon, whose points must exist and be finite; false if the polygon encloses no area. */
    boolean take(int polygon) {
        collect(polygons.start(polygon), polygons.end(polygon));
        return size >= 3 && project();
    }

    private void collect(int start, int end) {
        if (corners.length < end - start) {
            corners = new int[2 * (end - start)];
        }
        first = 0;
        last = 0;
        for (int c = start; c < end; c++) {
            push(c);
        }
        while (last - first >= 2 && closesOnItself()) {
            continue;
        }
        size = last - first;
    }

    private void push(int corner) {
        if (last > first && same(corners[last - 1], corner)) {
            return;
        }
        if (last - first > 1 && same(corners[last - 2], corner)) {
            last--;
            return;
        }
        corners[last++] = corner;
    }

    /** Removes one repetition or spike where the end of the ring meets its beginning; false if there is none. */
    private boolean closesOnItself() {
        if (same(corners[first], corners[last - 1]) || same(corners[first], corners[last - 2])) {
            last--;
            return true;
        }
        if (same(corners[first + 1], corners[last - 1])) {
            first++;
            return true;
        }
        return false;
    }

    private boolean same(int corner, int other) {
        int p = 3 * polygons.point(corner);
        int q = 3 * polygons.point(other);
        return p == q || points.get(p) == points.get(q) && points.get(p + 1) == points.get(q + 1)
                && points.get(p + 2) == points.get(q + 2);
    }

    /** Coordinate k (0, 1 or 2) of the i-th corner of the ring, relative to the first corner. */
    private double coordinate(int i, int k) {
        return (double) points.get(3 * polygons.point(corner(i)) + k)
                - points.get(3 * polygons.point(corner(0)) + k);
    }

    /** Projects along the largest component of Newell's normal, with corners counter-clockwise; false without area. */
    private boolean project() {
        double[] normal = new double[3];
        double extent = 0;
        for (int i = 0; i < size; i++) {
            int j = i + 1 == size ? 0 : i + 1;
            for (int k = 0; k < 3; k++) {
                int u = (k + 1) % 3;
                int v = (k + 2) % 3;
                normal[k] += coordinate(i, u) * coordinate(j, v) - coordinate(i, v) * coordinate(j, u);
                extent = Math.max(extent, Math.abs(coordinate(i, k)));
            }
        }
        int axis = largest(normal);
        area = Math.abs(normal[axis]);
        if (!(area > NO_AREA * extent * extent)) {
            return false;
        }
        fill((axis + 1) % 3, (axis + 2) % 3, Math.signum(normal[axis]));
        return true;
    }

    private static int largest(double[] v) {
        int largest = Math.abs(v[1]) > Math.abs(v[0]) ? 1 : 0;
        return Math.abs(v[2]) > Math.abs(v[largest]) ? 2 : largest;
    }

    private void fill(int u, int v, double sign) {
        if (x.length < size) {
            x = Arrays.copyOf(x, 2 * size);
            y = Arrays.copyOf(y, 2 * size);
        }
        for (int i = 0; i < size; i++) {
            x[i] = coordinate(i, u);
            y[i] = sign * coordinate(i, v);
        }
    }

    /** Twice the signed area of the triangle of three corners. */
    double cross(int a, int b, int c) {
        return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    }

    /** Whether the triangle of three corners has an area in space, projected or not. */
    boolean hasArea(int a, int b, int c) {
        double square = 0;
        double longest = 0;
        for (int k = 0; k < 3; k++) {
            int u = (k + 1) % 3;
            int v = (k + 2) % 3;
            double n = step(a, b, u) * step(a, c, v) - step(a, b, v) * step(a, c, u);
            square += n * n;
            longest = Math.max(longest, Math.max(Math.abs(step(a, b, k)), Math.abs(step(a, c, k))));
        }
        return Math.sqrt(square) > NO_AREA * longest * longest;
    }

    private double step(int from, int to, int k) {
        return coordinate(to, k) - coordinate(from, k);
    }

    /** Whether the projected ring is strictly convex, so that a fan from its first corner covers it. */
    boolean isConvex() {
        for (int i = 0; i < size; i++) {
            int next = (i + 1) % size;
            if (!(cross(i, next, (i + 2) % size) > 0) || i > 0 && next > i && !(cross(0, i, next) > 0)) {
                return false;
            }
        }
        return true;
    }
}
