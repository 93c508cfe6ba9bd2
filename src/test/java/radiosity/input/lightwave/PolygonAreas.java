package radiosity.input.lightwave;

import radiosity.input.file.IntList;
import radiosity.input.lightwave.lwo.Layer;
import radiosity.scene.Vec3;

/** Area vectors of polygons and of the triangles they were cut into. */
final class PolygonAreas {

    private PolygonAreas() {
    }

    /** Half of Newell's normal. */
    static Vec3 ofPolygon(Layer layer, int polygon) {
        int start = layer.polygons.start(polygon);
        int end = layer.polygons.end(polygon);
        Vec3 sum = Vec3.ZERO;
        for (int c = start + 2; c < end; c++) {
            sum = sum.plus(ofTriangle(layer, start, c - 1, c));
        }
        return sum;
    }

    /** The sum over triangles, given by 3 corner numbers each. */
    static Vec3 ofTriangles(Layer layer, IntList triangles) {
        Vec3 sum = Vec3.ZERO;
        for (int i = 0; i < triangles.size(); i += 3) {
            sum = sum.plus(ofTriangle(layer, triangles.get(i), triangles.get(i + 1), triangles.get(i + 2)));
        }
        return sum;
    }

    private static Vec3 ofTriangle(Layer layer, int a, int b, int c) {
        Vec3 origin = point(layer, a);
        return point(layer, b).minus(origin).cross(point(layer, c).minus(origin)).times(0.5);
    }

    private static Vec3 point(Layer layer, int corner) {
        int p = 3 * layer.polygons.point(corner);
        return new Vec3(layer.points.get(p), layer.points.get(p + 1), layer.points.get(p + 2));
    }
}
