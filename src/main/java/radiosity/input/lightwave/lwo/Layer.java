package radiosity.input.lightwave.lwo;

import java.util.ArrayList;
import java.util.List;
import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FloatList;
import radiosity.input.polygon.Polygons;

/** A layer of an object as its file lists it: points, polygons and texture coordinates, in left-handed coordinates. */
public final class Layer {

    public final int number;
    /** x, y, z of the point about which a scene turns the layer. */
    public final double[] pivot;

    /** x, y, z of each point. */
    public final FloatList points = new FloatList();
    public final Polygons polygons = new Polygons();
    final List<VertexMap> maps = new ArrayList<>();

    /** First point and first polygon of the latest PNTS and POLS chunks: indices in later chunks count from these. */
    int firstPoint;
    int firstPolygon;

    Layer(int number, double[] pivot) {
        this.number = number;
        this.pivot = pivot;
    }

    public Layer(int number) {
        this(number, new double[3]);
    }

    public int pointCount() {
        return points.size() / 3;
    }

    /** Appends the points of a chunk. */
    void readPoints(ByteReader data, String place, Diagnostics notes) {
        firstPoint = pointCount();
        if (data.left() % 12 != 0) {
            notes.note(place, "the points are no whole number of 12 bytes, the rest is left out");
        }
        for (int i = data.left() / 12 * 3; i > 0; i--) {
            points.add(data.f4());
        }
    }
}
