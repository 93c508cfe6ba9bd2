package radiosity.accuracy;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/**
 * A scene made of polygons in code. Corners with equal coordinates become one point, so that a scene whose polygons
 * meet edge to edge is watertight by its indices.
 */
public final class SceneBuilder {

    private final Map<Vec3, Integer> points = new LinkedHashMap<>();
    private final List<Integer> corners = new ArrayList<>();
    private final List<Integer> surfaceOf = new ArrayList<>();
    private final List<Surface> surfaces = new ArrayList<>();

    /**
     * Adds a polygon as a fan around its first corner.
     *
     * @param surface how it emits and reflects
     * @param polygon counter-clockwise seen from the visible side; star-shaped around its first corner
     */
    public SceneBuilder polygon(Surface surface, Vec3... polygon) {
        for (int i = 2; i < polygon.length; i++) {
            corners.add(point(polygon[0]));
            corners.add(point(polygon[i - 1]));
            corners.add(point(polygon[i]));
            surfaceOf.add(number(surface));
        }
        return this;
    }

    private int point(Vec3 p) {
        Vec3 positiveZero = p.plus(Vec3.ZERO);
        return points.computeIfAbsent(positiveZero, q -> points.size());
    }

    private int number(Surface surface) {
        if (!surfaces.contains(surface)) {
            surfaces.add(surface);
        }
        return surfaces.indexOf(surface);
    }

    /** Everything that was added, as a scene without lights and camera. */
    public Scene scene(String name) {
        double[] coordinates = points.keySet().stream()
                .flatMap(p -> Stream.of(p.x(), p.y(), p.z())).mapToDouble(x -> x).toArray();
        return new Scene(name, coordinates, ints(corners), ints(surfaceOf), surfaces, List.of(), Optional.empty());
    }

    private static int[] ints(List<Integer> list) {
        return list.stream().mapToInt(i -> i).toArray();
    }
}
