package radiosity.output.grid;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.util.Aabb;

/**
 * The points of a grid: middles of cells of about one size, in rows and columns.
 *
 * <p>On a surface, the points lie on its triangles, plane by plane; on planes smaller than a cell, as the facets of a
 * scan, there are together as many points as cells have their area, but at least one. On a plane like {@code y=0.85},
 * the points lie all over the scene's box.
 *
 * @param onSurface whether the points lie on a surface; otherwise in the air
 * @param points    scene units
 * @param normals   unit normals of the side whose light is asked for, one per point
 * @param areas     area for which a point stands, square scene units, one per point: that of its plane's triangles
 *                  over the number of points on the plane; together the surface's area
 */
record GridPlaces(boolean onSurface, List<Vec3> points, List<Vec3> normals, List<Double> areas) {

    private static final Pattern PLANE = Pattern
            .compile("([+-]?)([xyz])=([+-]?(?:[0-9]+[.]?[0-9]*|[.][0-9]+)(?:[eE][+-]?[0-9]+)?)");
    private static final int MOST = 1_000_000;
    /**
     * Components of normals, and offsets over the root of the scene's area, are those of one plane if they differ by at
     * most half as much, and of two planes if by more than one and a half times as much.
     */
    private static final double PLANE_ROUNDING = 1e-4;

    /** The triangles of a surface that lie in one plane. */
    private record Plane(Vec3 normal, double offset, List<Integer> triangles) {

        double area(Scene scene) {
            return triangles.stream().mapToDouble(scene::area).sum();
        }

        /** The triangles' centre of area or, where that is beside them, the middle of the largest triangle. */
        Vec3 middle(Scene scene) {
            Vec3 sum = Vec3.ZERO;
            for (int t : triangles) {
                sum = sum.plus(scene.middle(t).times(scene.area(t)));
            }
            Vec3 centre = sum.times(1 / area(scene));
            int largest = Collections.max(triangles, Comparator.comparingDouble(scene::area));
            return place(scene, centre).orElse(scene.middle(largest));
        }

        /** The place on the triangles above or below a point; triangles may lie beside the plane by rounding. */
        Optional<Vec3> place(Scene scene, Vec3 p) {
            return triangles.stream().filter(t -> holds(scene, t, p, normal)).findFirst()
                    .map(t -> on(scene, t, p, normal));
        }
    }

    /**
     * Places the points of a grid.
     *
     * @param where   a surface's name, or a plane: x, y or z = a number, with - before it for the side towards smaller
     *                numbers
     * @param spacing approximate distance of neighbouring points, scene units, above 0
     * @throws IllegalArgumentException if there is no surface of the name, the plane is outside the box of the
     *         scene and its lights, or there would be more than a million points
     */
    static GridPlaces of(Scene scene, String where, double spacing) {
        Matcher plane = PLANE.matcher(where);
        GridPlaces places = new GridPlaces(!plane.matches(), new ArrayList<>(), new ArrayList<>(),
                new ArrayList<>());
        if (!places.onSurface) {
            places.inTheAir(scene, plane, spacing);
        } else {
            places.on(scene, where, spacing);
        }
        return places;
    }

    private void inTheAir(Scene scene, Matcher plane, double spacing) {
        int axis = plane.group(2).charAt(0) - 'x';
        double at = Double.parseDouble(plane.group(3));
        Aabb box = Aabb.of(Arrays.stream(scene.corners()).mapToObj(scene::point));
        double[] lamps = scene.lights().stream().filter(light -> !light.kind().isOutside())
                .mapToDouble(light -> light.position().coordinate(axis)).toArray();
        double low = Math.min(box.low().coordinate(axis), Arrays.stream(lamps).min().orElse(Double.POSITIVE_INFINITY));
        double high = Math.max(box.high().coordinate(axis),
                Arrays.stream(lamps).max().orElse(Double.NEGATIVE_INFINITY));
        if (!(at >= low && at <= high)) {
            throw new IllegalArgumentException(String.format(Locale.ROOT,
                    "expected a plane from %s=%.6g to %.6g, got %s", plane.group(2), low, high, plane.group()));
        }
        int u = (axis + 1) % 3;
        int v = (axis + 2) % 3;
        Vec3 normal = unit(axis).times(plane.group(1).equals("-") ? -1 : 1);
        Vec3 corner = box.low().minus(unit(axis).times(box.low().coordinate(axis))).plus(unit(axis).times(at));
        double[] extent = {0, box.extent().coordinate(u), 0, box.extent().coordinate(v)};
        fill(corner, unit(u), unit(v), extent, spacing, normal, null, null);
    }

    private static Vec3 unit(int axis) {
        return new Vec3(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
    }

    private void on(Scene scene, String name, double spacing) {
        List<Plane> planes = new ArrayList<>();
        Map<List<Long>, Plane> planeOf = new HashMap<>();
        double size = Math.sqrt(scene.area());
        for (int t = 0; t < scene.triangles(); t++) {
            if (scene.surface(t).name().equals(name)) {
                Vec3 normal = scene.cross(t).unit();
                double offset = normal.dot(scene.corner(t, 0));
                double[] numbers = {normal.x() / PLANE_ROUNDING, normal.y() / PLANE_ROUNDING,
                    normal.z() / PLANE_ROUNDING, offset / (size * PLANE_ROUNDING)};
                List<Long> rounded = Arrays.stream(numbers).mapToObj(Math::round).toList();
                if (!planeOf.containsKey(rounded)) {
                    planes.add(new Plane(normal, offset, new ArrayList<>()));
                    for (int up = 0; up < 16; up++) {
                        planeOf.putIfAbsent(rounded(numbers, up), planes.get(planes.size() - 1));
                    }
                }
                planeOf.get(rounded).triangles.add(t);
            }
        }
        if (planes.isEmpty()) {
            throw new IllegalArgumentException("expected a surface of the scene (" + scene.surfaces().stream()
                    .map(Surface::name).distinct().limit(20).collect(Collectors.joining(", "))
                    + ") or a plane like y=0.85, got " + name);
        }
        together(scene, planes.stream().filter(plane -> !on(scene, plane, spacing)).toList(), spacing);
    }

    /** Places points on small planes: where the sum of their areas, in their order, passes half of a further cell. */
    private void together(Scene scene, List<Plane> small, double spacing) {
        double[] area = small.stream().mapToDouble(plane -> plane.area(scene)).toArray();
        double total = Arrays.stream(area).sum();
        double cells = Math.max(1, Math.rint(total / (spacing * spacing)));
        double sum = 0;
        double passed = 0;
        for (int i = 0; i < area.length; i++) {
            sum += area[i];
            double now = Math.floor(cells * (sum / total) + 0.5);
            if (now > passed) {
                requireAtMost(points.size() + 1, spacing);
                points.add(small.get(i).middle(scene));
                normals.add(small.get(i).normal);
                areas.add((now - passed) * total / cells);
                passed = now;
            }
        }
    }

    private static void requireAtMost(double count, double spacing) {
        if (!(count <= MOST)) {
            throw new IllegalArgumentException("expected a spacing that gives at most " + MOST + " points, got "
                    + spacing);
        }
    }

    /** Four numbers rounded down or, where the bit of a number is set in {@code up}, to the next whole number above. */
    private static List<Long> rounded(double[] numbers, int up) {
        return IntStream.range(0, 4).mapToObj(i -> (long) Math.floor(numbers[i]) + (up >> i & 1)).toList();
    }

    /** Whether points were placed on a plane; not where it is as small as one cell, or all middles of cells miss it. */
    private boolean on(Scene scene, Plane plane, double spacing) {
        Vec3 n = plane.normal;
        Vec3 u = (Math.abs(n.y()) > 0.999 ? unit(0) : unit(1).cross(n)).unit();
        Vec3 v = n.cross(u).unit();
        double[] extent = {1 / 0.0, -1 / 0.0, 1 / 0.0, -1 / 0.0};
        for (int t : plane.triangles) {
            for (int k = 0; k < 3; k++) {
                Vec3 p = scene.corner(t, k);
                extent[0] = Math.min(extent[0], p.dot(u));
                extent[1] = Math.max(extent[1], p.dot(u));
                extent[2] = Math.min(extent[2], p.dot(v));
                extent[3] = Math.max(extent[3], p.dot(v));
            }
        }
        int first = points.size();
        if (cells(extent, spacing, 0) * cells(extent, spacing, 2) > 1) {
            fill(n.times(plane.offset), u, v, extent, spacing, n, scene, plane);
        }
        return points.size() > first;
    }

    /** Number of cells along an axis, whose extent are two numbers. */
    private static double cells(double[] extent, double spacing, int at) {
        return Math.max(1, Math.rint((extent[at + 1] - extent[at]) / spacing));
    }

    /** @param plane on whose triangles points must lie; null if points lie anywhere */
    private void fill(Vec3 origin, Vec3 u, Vec3 v, double[] extent, double spacing, Vec3 normal, Scene scene,
                      Plane plane) {
        double columns = cells(extent, spacing, 0);
        double rows = cells(extent, spacing, 2);
        requireAtMost(columns * rows + points.size(), spacing);
        int first = points.size();
        for (int j = 0; j < rows; j++) {
            for (int i = 0; i < columns; i++) {
                Vec3 p = origin.plus(u.times(extent[0] + (extent[1] - extent[0]) * (i + 0.5) / columns))
                        .plus(v.times(extent[2] + (extent[3] - extent[2]) * (j + 0.5) / rows));
                Optional<Vec3> place = plane == null ? Optional.of(p) : plane.place(scene, p);
                place.ifPresent(points::add);
                place.ifPresent(at -> normals.add(normal));
            }
        }
        double area = plane == null ? 1 : plane.area(scene);
        areas.addAll(Collections.nCopies(points.size() - first, area / (points.size() - first)));
    }

    /** The point of a triangle's plane above or below a point. */
    private static Vec3 on(Scene scene, int triangle, Vec3 p, Vec3 normal) {
        Vec3 n = scene.cross(triangle).unit();
        return p.plus(normal.times(scene.corner(triangle, 0).minus(p).dot(n) / normal.dot(n)));
    }

    private static boolean holds(Scene scene, int triangle, Vec3 p, Vec3 normal) {
        for (int k = 0; k < 3; k++) {
            Vec3 a = scene.corner(triangle, k);
            Vec3 edge = scene.corner(triangle, (k + 1) % 3).minus(a);
            if (edge.cross(p.minus(a)).dot(normal) < 0) {
                return false;
            }
        }
        return true;
    }
}
