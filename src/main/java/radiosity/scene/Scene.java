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
        Stream<Lamp> shining = IntStream.range(0, lights.size()).mapToObj(l -> new Lamp(lights.get(l).name(), false, l));
        return Stream.concat(emitting, shining).toList();
    }

    /** Number of original triangles. */
    public int triangles() {
        return surfaceOf.length;
    }

    public Surface surface(int triangle) {
        return surfaces.get(surfaceOf[triangle]);
    }

    /** Corner k (0, 1 or 2) of a triangle. */
    public Vec3 corner(int triangle, int k) {
        int p = 3 * corners[3 * triangle + k];
        return new Vec3(points[p], points[p + 1], points[p + 2]);
    }

    /** Area of a triangle, square scene units. */
    public double area(int triangle) {
        Vec3 a = corner(triangle, 0);
        return 0.5 * corner(triangle, 1).minus(a).cross(corner(triangle, 2).minus(a)).length();
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
