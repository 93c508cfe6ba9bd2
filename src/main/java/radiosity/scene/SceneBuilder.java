package radiosity.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Builds a {@link Scene} from polygons in code.
 *
 * <p>Corners with equal coordinates become one point, so that polygons that meet edge to edge share points.
 */
public final class SceneBuilder {

    private final Map<Vec3, Integer> points = new LinkedHashMap<>();
    private final Map<Surface, Integer> surfaces = new LinkedHashMap<>();
    private final List<Light> lights = new ArrayList<>();
    private int[] corners = new int[48];
    private int[] surfaceOf = new int[16];
    private int triangles;
    /** 6 per triangle up to the last one with images, {@link #textured} in all; NaN where a triangle has none. */
    private float[] coordinates = {};
    private int textured;
    private Optional<Camera> camera = Optional.empty();

    /** A builder without any triangle. */
    public SceneBuilder() { }

    /**
     * Adds a polygon as a fan of triangles around its first corner.
     *
     * @param surface how the polygon emits and reflects; equal surfaces are one surface of the scene
     * @param polygon at least three corners, counter-clockwise seen from the visible side; star-shaped around the first
     *                corner; scene units
     * @return this builder
     * @throws IllegalArgumentException for fewer than three corners, or a coordinate that is not finite
     */
    public SceneBuilder polygon(Surface surface, Vec3... polygon) {
        if (polygon.length < 3) {
            throw new IllegalArgumentException("polygon: expected at least 3 corners, got " + polygon.length);
        }
        for (int i = 2; i < polygon.length; i++) {
            triangle(surface, polygon[0], polygon[i - 1], polygon[i]);
        }
        return this;
    }

    /**
     * Adds a polygon on which the surface's images lie, see {@link #polygon(Surface, Vec3...)}.
     *
     * @param u texture coordinate at each corner, 1 at the images' right edge
     * @param v texture coordinate at each corner, 1 at the images' upper edge
     * @return this builder
     * @throws IllegalArgumentException also where there is not one of each per corner, or one is not finite
     */
    public SceneBuilder polygon(Surface surface, Vec3[] polygon, double[] u, double[] v) {
        if (u.length != polygon.length || v.length != polygon.length) {
            throw new IllegalArgumentException("polygon: expected u and v for each of " + polygon.length
                    + " corners, got " + u.length + " and " + v.length);
        }
        for (int k = 0; k < u.length; k++) {
            if (!Float.isFinite((float) u[k]) || !Float.isFinite((float) v[k])) {
                throw new IllegalArgumentException("polygon: expected finite u and v, got " + u[k] + " and " + v[k]);
            }
        }
        int first = 6 * triangles;
        polygon(surface, polygon);
        if (coordinates.length < 6 * triangles) {
            coordinates = Arrays.copyOf(coordinates, 2 * corners.length);
        }
        Arrays.fill(coordinates, textured, first, Float.NaN);
        textured = first;
        for (int i = 2; i < polygon.length; i++) {
            for (int k : new int[] {0, i - 1, i}) {
                coordinates[textured++] = (float) u[k];
                coordinates[textured++] = (float) v[k];
            }
        }
        return this;
    }

    private void triangle(Surface surface, Vec3 a, Vec3 b, Vec3 c) {
        if (triangles == surfaceOf.length) {
            surfaceOf = Arrays.copyOf(surfaceOf, 2 * triangles);
            corners = Arrays.copyOf(corners, 6 * triangles);
        }
        corners[3 * triangles] = point(a);
        corners[3 * triangles + 1] = point(b);
        corners[3 * triangles + 2] = point(c);
        surfaceOf[triangles++] = surfaces.computeIfAbsent(surface, s -> surfaces.size());
    }

    private int point(Vec3 p) {
        if (!p.isFinite()) {
            throw new IllegalArgumentException("polygon: expected finite coordinates, got " + p);
        }
        Vec3 positiveZero = p.plus(Vec3.ZERO);
        return points.computeIfAbsent(positiveZero, q -> points.size());
    }

    /**
     * Adds a light without geometry.
     *
     * @return this builder
     */
    public SceneBuilder light(Light light) {
        lights.add(light);
        return this;
    }

    /**
     * Sets the camera of the scene.
     *
     * @return this builder
     */
    public SceneBuilder camera(Camera view) {
        camera = Optional.of(view);
        return this;
    }

    /**
     * Builds the scene; more polygons may be added afterwards for a further scene.
     *
     * @param name the scene's name in messages and files
     */
    public Scene scene(String name) {
        double[] places = new double[3 * points.size()];
        int i = 0;
        for (Vec3 p : points.keySet()) {
            places[i++] = p.x();
            places[i++] = p.y();
            places[i++] = p.z();
        }
        float[] images = textured == 0 ? new float[0] : Arrays.copyOf(coordinates, 6 * triangles);
        Arrays.fill(images, Math.min(textured, images.length), images.length, Float.NaN);
        return new Scene(name, places, Arrays.copyOf(corners, 3 * triangles), Arrays.copyOf(surfaceOf, triangles),
                List.copyOf(surfaces.keySet()), lights, camera, images);
    }
}
