package radiosity.scene;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The original triangles of a world and their surfaces (section 4.5.1 of the paper).
 *
 * <p>The arrays belong to the scene: they are not copied, and nobody modifies them after the scene is made.
 *
 * @param name          name in messages, usually the file's name
 * @param points        x, y, z of each point, right-handed, +Y up, scene units; 3 per point, all finite
 * @param corners       indices of points, 3 per triangle, counter-clockwise seen from the visible side
 * @param surfaceOf     index into {@code surfaces}, 1 per triangle
 * @param surfaces      at least the surfaces that {@code surfaceOf} refers to
 * @param lights        sources without geometry
 * @param camera        the camera that the scene's file describes
 * @param textureCoordinates u, v of each corner, 6 per triangle, v upwards; NaN where a triangle has none; empty if no
 *                      triangle has any
 * @param vertexColours factors of the surface's reflectance at each corner: red, green, blue in [0, 1], 9 per triangle;
 *                      empty if they are all 1
 * @param hierarchy     objects, and the object of each triangle
 * @param units         units of length and light
 */
public record Scene(String name, double[] points, int[] corners, int[] surfaceOf, List<Surface> surfaces,
                    List<Light> lights, Optional<Camera> camera, float[] textureCoordinates, float[] vertexColours,
                    Hierarchy hierarchy, Units units) {

    private static final float[] NONE = new float[0];

    /** A scene without texture coordinates. */
    public Scene(String name, double[] points, int[] corners, int[] surfaceOf, List<Surface> surfaces,
                 List<Light> lights, Optional<Camera> camera) {
        this(name, points, corners, surfaceOf, surfaces, lights, camera, NONE);
    }

    /** A scene without vertex colours and without objects. */
    public Scene(String name, double[] points, int[] corners, int[] surfaceOf, List<Surface> surfaces,
                 List<Light> lights, Optional<Camera> camera, float[] textureCoordinates) {
        this(name, points, corners, surfaceOf, surfaces, lights, camera, textureCoordinates, NONE, Hierarchy.NONE);
    }

    /** A scene of unknown units. */
    public Scene(String name, double[] points, int[] corners, int[] surfaceOf, List<Surface> surfaces,
                 List<Light> lights, Optional<Camera> camera, float[] textureCoordinates, float[] vertexColours,
                 Hierarchy hierarchy) {
        this(name, points, corners, surfaceOf, surfaces, lights, camera, textureCoordinates, vertexColours, hierarchy,
                Units.UNKNOWN);
    }

    public Scene {
        surfaces = List.copyOf(surfaces);
        lights = List.copyOf(lights);
        require(points.length % 3 == 0, "3 coordinates per point", points.length);
        require(corners.length == 3 * surfaceOf.length, "3 corners per triangle", corners.length);
        require(textureCoordinates.length == 0 || textureCoordinates.length == 6 * surfaceOf.length,
                "no texture coordinates or 6 per triangle", textureCoordinates.length);
        for (int t = 0; t < textureCoordinates.length; t += 6) {
            for (int i = t; i < t + 6 && !Float.isNaN(textureCoordinates[t]); i++) {
                require(Float.isFinite(textureCoordinates[i]), "finite texture coordinates, or NaN for the first of a"
                        + " triangle without images", textureCoordinates[i]);
            }
        }
        require(vertexColours.length == 0 || vertexColours.length == 9 * surfaceOf.length,
                "no colours at vertices or 9 numbers per triangle", vertexColours.length);
        for (float colour : vertexColours) {
            require(colour >= 0 && colour <= 1, "colours in [0, 1]", colour);
        }
        require(hierarchy.nodes().isEmpty() || hierarchy.nodeOf().length == surfaceOf.length,
                "a node for each triangle", hierarchy.nodeOf().length);
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

    /** The surfaces that emit and have triangles, in ascending order of their indices, then the lights. */
    public List<Lamp> lamps() {
        Stream<Lamp> emitting = Arrays.stream(surfaceOf).distinct().sorted().filter(s -> surfaces.get(s).emits())
                .mapToObj(s -> new Lamp(surfaces.get(s).name(), true, s));
        Stream<Lamp> fromLights = IntStream.range(0, lights.size())
                .mapToObj(l -> new Lamp(lights.get(l).name(), false, l));
        return Stream.concat(emitting, fromLights).toList();
    }

    /** Number of original triangles. */
    public int triangles() {
        return surfaceOf.length;
    }

    public Surface surface(int triangle) {
        return surfaces.get(surfaceOf[triangle]);
    }

    /** This scene with other surfaces, whose indices must suit {@code surfaceOf}, and other lights. */
    public Scene with(List<Surface> otherSurfaces, List<Light> otherLights) {
        return new Scene(name, points, corners, surfaceOf, otherSurfaces, otherLights, camera, textureCoordinates,
                vertexColours, hierarchy, units);
    }

    /** This scene with its numbers understood in other units; the numbers stay. */
    public Scene with(Units others) {
        return new Scene(name, points, corners, surfaceOf, surfaces, lights, camera, textureCoordinates, vertexColours,
                hierarchy, others);
    }

    /** Whether images or vertex colours make the reflectance or exitance of a triangle differ from its surface's. */
    public boolean isMapped(int triangle) {
        return hasImages(triangle) || isColoured(triangle);
    }

    /** Whether the triangle's surface has images and the triangle has texture coordinates for them. */
    public boolean hasImages(int triangle) {
        return !surface(triangle).maps().isEmpty() && textureCoordinates.length > 0
                && !Float.isNaN(textureCoordinates[6 * triangle]);
    }

    /** Whether a vertex colour of the triangle differs from 1. */
    public boolean isColoured(int triangle) {
        for (int i = 9 * triangle; i < 9 * triangle + 9 && vertexColours.length > 0; i++) {
            if (vertexColours[i] != 1) {
                return true;
            }
        }
        return false;
    }

    /** The factor of the reflectance at a triangle's corner k (0, 1 or 2). */
    public Rgb vertexColour(int triangle, int k) {
        int i = 9 * triangle + 3 * k;
        return vertexColours.length == 0 ? Rgb.grey(1)
                : new Rgb(vertexColours[i], vertexColours[i + 1], vertexColours[i + 2]);
    }

    /** Exitance and reflectance at a point of a triangle. */
    public MaterialSample material(int triangle, Vec3 point) {
        if (!isMapped(triangle)) {
            return everywhere(triangle);
        }
        double[] weights = weights(triangle, point);
        return material(triangle, weights, map ->
                map.at(textureCoordinate(triangle, 0, weights), textureCoordinate(triangle, 1, weights)));
    }

    /** Mean exitance and reflectance over the part a, b, c of a triangle. */
    public MaterialSample meanMaterial(int triangle, Vec3 a, Vec3 b, Vec3 c) {
        if (!isMapped(triangle)) {
            return everywhere(triangle);
        }
        double[][] at = {weights(triangle, a), weights(triangle, b), weights(triangle, c)};
        double[] middle = {(at[0][0] + at[1][0] + at[2][0]) / 3, (at[0][1] + at[1][1] + at[2][1]) / 3};
        return material(triangle, middle, map ->
                map.mean(textureCoordinates(triangle, 0, at), textureCoordinates(triangle, 1, at)));
    }

    private MaterialSample everywhere(int triangle) {
        return new MaterialSample(surface(triangle).exitance(), surface(triangle).reflectance());
    }

    private MaterialSample material(int triangle, double[] weights, Function<Raster, Rgb> value) {
        MaterialSample of = hasImages(triangle) ? surface(triangle).material(value) : everywhere(triangle);
        if (!isColoured(triangle)) {
            return of;
        }
        Rgb colour = vertexColour(triangle, 0).times(1 - weights[0] - weights[1])
                .plus(vertexColour(triangle, 1).times(weights[0])).plus(vertexColour(triangle, 2).times(weights[1]));
        return new MaterialSample(of.exitance(), of.reflectance().times(colour));
    }

    /** Largest number of image pixels per scene unit along an edge of the triangle; 0 where it has no images. */
    public double pixelsPerUnit(int triangle) {
        Surface.Maps maps = surface(triangle).maps();
        double most = 0;
        for (int k = 0; k < 3 && hasImages(triangle); k++) {
            Vec3 p = corner(triangle, k);
            Vec3 q = corner(triangle, (k + 1) % 3);
            double[] a = weights(triangle, p);
            double[] b = weights(triangle, q);
            double du = textureCoordinate(triangle, 0, b) - textureCoordinate(triangle, 0, a);
            double dv = textureCoordinate(triangle, 1, b) - textureCoordinate(triangle, 1, a);
            most = Math.max(most, Stream.concat(maps.exitance().stream(), maps.reflectance().stream())
                    .mapToDouble(map -> StrictMath.hypot(du * map.width(), dv * map.height()))
                    .max().orElse(0) / q.minus(p).length());
        }
        return most;
    }

    /** Barycentric weights of corners 1 and 2 of a triangle at a point of the triangle. */
    private double[] weights(int triangle, Vec3 point) {
        Vec3 a = corner(triangle, 0);
        Vec3 ab = corner(triangle, 1).minus(a);
        Vec3 ac = corner(triangle, 2).minus(a);
        Vec3 n = ab.cross(ac);
        return new double[] {n.dot(point.minus(a).cross(ac)) / n.dot(n), n.dot(ab.cross(point.minus(a))) / n.dot(n)};
    }

    /** Texture coordinate u (which 0) or v (which 1) at the barycentric weights of corners 1 and 2. */
    private double textureCoordinate(int triangle, int which, double[] weights) {
        float first = textureCoordinates[6 * triangle + which];
        return first + weights[0] * (textureCoordinates[6 * triangle + 2 + which] - first)
                + weights[1] * (textureCoordinates[6 * triangle + 4 + which] - first);
    }

    /** Texture coordinate u or v at three points, each given by its barycentric weights. */
    private double[] textureCoordinates(int triangle, int which, double[][] weights) {
        return new double[] {textureCoordinate(triangle, which, weights[0]),
                textureCoordinate(triangle, which, weights[1]), textureCoordinate(triangle, which, weights[2])};
    }

    public Vec3 point(int number) {
        return new Vec3(points[3 * number], points[3 * number + 1], points[3 * number + 2]);
    }

    /** Corner k (0, 1 or 2) of a triangle. */
    public Vec3 corner(int triangle, int k) {
        return point(corners[3 * triangle + k]);
    }

    /** Centroid of a triangle. */
    public Vec3 middle(int triangle) {
        return corner(triangle, 0).plus(corner(triangle, 1)).plus(corner(triangle, 2)).times(1.0 / 3);
    }

    /** Normal of a triangle's visible side, of length twice the triangle's area, square scene units. */
    public Vec3 cross(int triangle) {
        Vec3 a = corner(triangle, 0);
        return corner(triangle, 1).minus(a).cross(corner(triangle, 2).minus(a));
    }

    /** Area of a triangle, square scene units. */
    public double area(int triangle) {
        return 0.5 * cross(triangle).length();
    }

    /** Area of all triangles, each counted once also where two-sided, square scene units. */
    public double area() {
        double sum = 0;
        for (int t = 0; t < triangles(); t++) {
            sum += area(t);
        }
        return sum;
    }
}
