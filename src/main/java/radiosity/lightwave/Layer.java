package radiosity.lightwave;

import java.util.ArrayList;
import java.util.List;

/** A layer of an object as its file lists it: points, polygons and texture coordinates, in left-handed coordinates. */
final class Layer {

    final int number;
    final boolean hidden;
    /** x, y, z of the point about which a scene turns the layer. */
    final double[] pivot;

    /** x, y, z of each point. */
    final Floats points = new Floats();
    final Polygons polygons = new Polygons();
    final List<VertexMap> maps = new ArrayList<>();

    /** Number of the first point and the first polygon of the latest chunk: what follows counts from them. */
    int firstPoint;
    int firstPolygon;

    Layer(int number, boolean hidden, double[] pivot) {
        this.number = number;
        this.hidden = hidden;
        this.pivot = pivot;
    }

    Layer(int number) {
        this(number, false, new double[3]);
    }

    int pointCount() {
        return points.size() / 3;
    }

    /** Appends the points of a chunk. */
    void readPoints(Bytes data, String place, Notes notes) {
        firstPoint = pointCount();
        if (data.left() % 12 != 0) {
            notes.note(place, "the points are no whole number of 12 bytes, the rest is left out");
        }
        for (int i = data.left() / 12 * 3; i > 0; i--) {
            points.add(data.f4());
        }
    }
}
