package radiosity.scenes;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * One layer of an object: polygons on shared points.
 *
 * <p>Left-handed as LightWave has it: x right, y up, z away. The front of a polygon with the corners a, b … z is
 * where (b - a) x (z - a) points, the cross product taken in these numbers; seen from there its corners run clockwise.
 */
final class Layer {

    /** Points closer than this are one point, scene units. */
    private static final double GRID = 1e-5;

    final String name;
    /** Where the layer turns and is placed, x, y, z. */
    final double[] pivot;
    private final Map<List<Float>, Integer> points = new LinkedHashMap<>();
    private final List<int[]> polygons = new ArrayList<>();
    private final List<Material> materials = new ArrayList<>();

    Layer(String name, double... pivot) {
        this.name = name;
        this.pivot = pivot.length == 3 ? pivot : new double[3];
    }

    /** Adds a polygon; corners x, y, z each. Repeated corners are dropped, and with them what has fewer than three. */
    Layer polygon(Material material, double[]... corners) {
        int[] numbers = Arrays.stream(corners).mapToInt(this::point).distinct().toArray();
        if (numbers.length >= 3) {
            polygons.add(numbers);
            materials.add(material);
        }
        return this;
    }

    /** Adds a polygon that turns its front to the given direction, x, y, z, whatever the order of its corners. */
    Layer facing(Material material, double[] direction, double[]... corners) {
        double[] normal = Vectors.cross(Vectors.minus(corners[1], corners[0]),
                Vectors.minus(corners[corners.length - 1], corners[0]));
        if (Vectors.dot(normal, direction) < 0) {
            Collections.reverse(Arrays.asList(corners));
        }
        return polygon(material, corners);
    }

    private int point(double[] p) {
        return points.computeIfAbsent(List.of(onGrid(p[0]), onGrid(p[1]), onGrid(p[2])), key -> points.size());
    }

    /** Rounded, so that what is computed in two ways becomes one point; + 0 turns -0 into 0. */
    private static float onGrid(double x) {
        return (float) (Math.rint(x / GRID) * GRID) + 0f;
    }

    List<List<Float>> points() {
        return List.copyOf(points.keySet());
    }

    /** Point numbers of each polygon. */
    List<int[]> polygons() {
        return polygons;
    }

    /** The material of each polygon. */
    List<Material> materials() {
        return materials;
    }
}
