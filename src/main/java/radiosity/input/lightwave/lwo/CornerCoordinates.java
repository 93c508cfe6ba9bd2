package radiosity.input.lightwave.lwo;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/** The texture coordinates of one name in a layer: a pair per point, and pairs of polygon corners that override it. */
public final class CornerCoordinates {

    /** u, v of each point; NaN for points without coordinates. */
    private final float[] ofPoints;
    private final Map<Long, float[]> ofCorners = new HashMap<>();

    public CornerCoordinates(Layer layer, String name) {
        ofPoints = new float[2 * layer.pointCount()];
        Arrays.fill(ofPoints, Float.NaN);
        for (VertexMap map : layer.maps) {
            if (map.name.equals(name)) {
                take(map);
            }
        }
    }

    private void take(VertexMap map) {
        for (int i = 0; i < map.points.size(); i++) {
            int point = map.points.get(i);
            float u = map.values.get(2 * i);
            float v = map.values.get(2 * i + 1);
            if (!Float.isFinite(u) || !Float.isFinite(v)) {
                continue;
            }
            if (map.polygons.size() > 0) {
                ofCorners.put(key(map.polygons.get(i), point), new float[] {u, v});
            } else if (point < ofPoints.length / 2) {
                ofPoints[2 * point] = u;
                ofPoints[2 * point + 1] = v;
            }
        }
    }

    private static long key(int polygon, int point) {
        return (long) polygon << 32 | point;
    }

    /** Writes u and v of a polygon's corner to {@code uv[at]} and {@code uv[at + 1]}; NaN where there are none. */
    public void get(int polygon, int point, double[] uv, int at) {
        float[] own = ofCorners.get(key(polygon, point));
        uv[at] = own == null ? ofPoints[2 * point] : own[0];
        uv[at + 1] = own == null ? ofPoints[2 * point + 1] : own[1];
    }
}
