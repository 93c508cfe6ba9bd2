package radiosity.scene;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The original triangles of a world and their surfaces (section 4.5.1 of the paper).
 *
 * <p>The arrays belong to the scene: nobody modifies them after it is made.
 *
 * @param name      for messages, usually the file's name
 * @param points    x, y, z of each point, right-handed, +Y up, scene units; 3 per point, all finite
 * @param corners   indices of points, 3 per triangle, counter-clockwise seen from the visible side
 * @param surfaceOf index into {@code surfaces}, 1 per triangle
 * @param surfaces  at least those that are named in {@code surfaceOf}
 * @param lights    sources without geometry
 * @param camera    from where the scene's maker looked at it
 * @param textureCoordinates u, v of each corner, 6 per triangle, v upwards; NaN where a triangle has none; empty if no
 *                  triangle has any
 */
public record Scene(String name, double[] points, int[] corners, int[] surfaceOf, List<Surface> surfaces,
                    List<Light> lights, Optional<Camera> camera, float[] textureCoordinates) {

    /** A scene without texture coordinates. */
    public Scene(String name, double[] points, int[] corners, int[] surfaceOf, List<Surface> surfaces,
                 List<Light> lights, Optional<Camera> camera) {
        this(name, points, corners, surfaceOf, surfaces, lights, camera, new float[0]);
    }

    public Scene {
        surfaces = List.copyOf(surfaces);
        lights = List.copyOf(lights);
        require(points.length % 3 == 0, "3 coordinates per point", points.length);
        require(corners.length == 3 * surfaceOf.length, "3 corners per triangle", corners.length);
        require(textureCoordinates.length == 0 || textureCoordinates.length == 6 * surfaceOf.length,
                "no texture coordinates or 6 per triangle", textureCoordinates.length);
        for (double x : points) {
            require(Double.isFinite(x), "finite coordinates", x);
        }
        for (int p : corners) {
            require(p >= 0 && p < points.length / 3, "a point below " + points.length / 3, p);
        }
        for (int s : surfaceOf) {
            require(s >= 0 && s < surfaces.size(), "a surface below " + surfaces.size(), s);
        }
    }

    private static void require(boolean holds, String expected, Object got) {
        if (!holds) {
            throw new IllegalArgumentException("scene: expected " + expected + ", got " + got);
        }
    }

    /** The surfaces that emit and have triangles, then the lights. */
    public List<Lamp> lamps() {
        Stream<Lamp> emitting = Arrays.stream(surfaceOf).distinct().sorted().filter(s -> surfaces.get(s).emits())
                .mapToObj(s -> new Lamp(surfaces.get(s).name(), true, s));
        Stream<Lamp> shining = IntStream.range(0, lights.size())
                .mapToObj(l -> new Lamp(lights.get(l).name(), false, l));
        return Stream.concat(emitting, shining).toList();
    }

    /** Number of original triangles. */
    public int triangles() {
        return surfaceOf.length;
    }

    public Surface surface(int triangle) {
        return surfaces.get(surfaceOf[triangle]);
    }

    /** Whether what a triangle reflects or emits differs from point to point. */
    public boolean isMapped(int triangle) {
        return !surface(triangle).maps().isEmpty() && textureCoordinates.length > 0
                && !Float.isNaN(textureCoordinates[6 * triangle]);
    }

    /** What there is to see of a triangle at a point on it. */
    public MaterialSample look(int triangle, Vec3 point) {
        Surface surface = surface(triangle);
        if (!isMapped(triangle)) {
            return new MaterialSample(surface.exitance(), surface.reflectance());
        }
        double[] at = textureCoordinates(triangle, point);
        return new MaterialSample(surface.maps().exitance().map(map -> map.at(at[0], at[1])).orElse(surface.exitance()),
                surface.maps().reflectance().map(map -> map.at(at[0], at[1])).orElse(surface.reflectance()));
    }

    /** The same in the mean under a part of a triangle. */
    public MaterialSample meanLook(int triangle, Vec3 a, Vec3 b, Vec3 c) {
        Surface surface = surface(triangle);
        if (!isMapped(triangle)) {
            return new MaterialSample(surface.exitance(), surface.reflectance());
        }
        double[][] at = {textureCoordinates(triangle, a), textureCoordinates(triangle, b),
                textureCoordinates(triangle, c)};
        double[] u = {at[0][0], at[1][0], at[2][0]};
        double[] v = {at[0][1], at[1][1], at[2][1]};
        return new MaterialSample(surface.maps().exitance().map(map -> map.mean(u, v)).orElse(surface.exitance()),
                surface.maps().reflectance().map(map -> map.mean(u, v)).orElse(surface.reflectance()));
    }

    /** Pixels of a mapped triangle's pictures per scene unit along an edge, at most. */
    public double pixelsPerUnit(int triangle) {
        Surface.Maps maps = surface(triangle).maps();
        double most = 0;
        for (int k = 0; k < 3; k++) {
            Vec3 p = corner(triangle, k);
            Vec3 q = corner(triangle, (k + 1) % 3);
            double[] a = textureCoordinates(triangle, p);
            double[] b = textureCoordinates(triangle, q);
            most = Math.max(most, Stream.concat(maps.exitance().stream(), maps.reflectance().stream())
                    .mapToDouble(map -> StrictMath.hypot((b[0] - a[0]) * map.width(), (b[1] - a[1]) * map.height()))
                    .max().orElse(0) / q.minus(p).length());
        }
        return most;
    }

    /** u and v at a point of a triangle that has them. */
    private double[] textureCoordinates(int triangle, Vec3 point) {
        Vec3 a = corner(triangle, 0);
        Vec3 ab = corner(triangle, 1).minus(a);
        Vec3 ac = corner(triangle, 2).minus(a);
        Vec3 n = ab.cross(ac);
        double s = n.dot(point.minus(a).cross(ac)) / n.dot(n);
        double t = n.dot(ab.cross(point.minus(a))) / n.dot(n);
        double[] at = new double[2];
        for (int i = 0; i < 2; i++) {
            float first = textureCoordinates[6 * triangle + i];
            at[i] = first + s * (textureCoordinates[6 * triangle + 2 + i] - first)
                    + t * (textureCoordinates[6 * triangle + 4 + i] - first);
        }
        return at;
    }

    /** Corner k (0, 1 or 2) of a triangle. */
    public Vec3 corner(int triangle, int k) {
        int p = 3 * corners[3 * triangle + k];
        return new Vec3(points[p], points[p + 1], points[p + 2]);
    }

    /** At right angles to a triangle, out of its front, twice as long as its area is large. */
    public Vec3 cross(int triangle) {
        Vec3 a = corner(triangle, 0);
        return corner(triangle, 1).minus(a).cross(corner(triangle, 2).minus(a));
    }

    /** Area of a triangle, square scene units. */
    public double area(int triangle) {
        return 0.5 * cross(triangle).length();
    }

    /** Area of all triangles, each counted once, square scene units. */
    public double area() {
        double sum = 0;
        for (int t = 0; t < triangles(); t++) {
            sum += area(t);
        }
        return sum;
    }
}
