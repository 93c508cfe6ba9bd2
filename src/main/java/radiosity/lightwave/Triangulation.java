package radiosity.lightwave;

/** Cuts the polygons of a layer into triangles: convex ones as a fan from the first corner, others by their ears. */
final class Triangulation {

    /** Largest share by which the triangles of a sound polygon may have more than its area. */
    private static final double AREA_TOLERANCE = 1e-6;

    private final Layer layer;
    private final Notes notes;
    private final Outline outline;
    private final EarClipping ears;
    private final PolygonSet seen;
    private final Ints local = new Ints();

    Triangulation(Layer layer, Work work, Notes notes) {
        this.layer = layer;
        this.notes = notes;
        this.outline = new Outline(layer);
        this.ears = new EarClipping(outline, work);
        this.seen = new PolygonSet(layer);
    }

    /** Appends the corners of a polygon's triangles, 3 per triangle; what is wrong with it is noted. */
    void cut(int polygon, Ints triangles) {
        int corners = layer.polygons.end(polygon) - layer.polygons.start(polygon);
        if (corners < 3 || !isSound(polygon)) {
            return;
        }
        if (!outline.take(polygon)) {
            note(polygon, "polygons without area are dropped");
        } else if (!seen.add(outline)) {
            note(polygon, "polygons that lie on one another are dropped but for the first");
        } else if (outline.size() == 3 || outline.isConvex()) {
            fan(triangles);
        } else {
            ears(polygon, triangles);
        }
    }

    private void note(int polygon, String remark) {
        notes.note("layer " + layer.number + ", polygon " + polygon, remark);
    }

    private boolean isSound(int polygon) {
        for (int c = layer.polygons.start(polygon); c < layer.polygons.end(polygon); c++) {
            int point = layer.polygons.point(c);
            if (point >= layer.pointCount()) {
                note(polygon, "polygons with points that do not exist are dropped");
                return false;
            }
            if (!layer.hasFinite(point)) {
                note(polygon, "polygons with coordinates that are no finite numbers are dropped");
                return false;
            }
        }
        return true;
    }

    private void fan(Ints triangles) {
        for (int i = 2; i < outline.size(); i++) {
            triangles.add(outline.corner(0));
            triangles.add(outline.corner(i - 1));
            triangles.add(outline.corner(i));
        }
    }

    private void ears(int polygon, Ints triangles) {
        local.cut(0);
        double area = ears.cut(local);
        if (Double.isNaN(area)) {
            note(polygon, "polygons too tangled to be cut are dropped");
            return;
        }
        if (area - outline.area > AREA_TOLERANCE * outline.area) {
            note(polygon, "polygons that cross themselves or are folded are cut along their border");
        }
        for (int i = 0; i < local.size(); i += 3) {
            if (outline.hasArea(local.get(i), local.get(i + 1), local.get(i + 2))) {
                for (int k = 0; k < 3; k++) {
                    triangles.add(outline.corner(local.get(i + k)));
                }
            }
        }
    }
}
