package radiosity.input.polygon;

import java.util.function.IntFunction;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FloatList;
import radiosity.input.file.IntList;
import radiosity.input.file.WorkBudget;

/** Cuts polygons into triangles: convex polygons as a fan from the first corner, others by ear clipping. */
public final class Triangulation {

    /** Largest excess of the area of the triangles over the area of a sound polygon, relative to the polygon's area. */
    private static final double AREA_TOLERANCE = 1e-6;

    private final FloatList points;
    private final Polygons polygons;
    private final IntFunction<String> place;
    private final Diagnostics notes;
    private final PolygonRing outline;
    private final EarClipper ears;
    private final PolygonSet seen;
    private final IntList local = new IntList();

    /**
     * @param points   x, y, z of each point
     * @param polygons corners of polygons, which may name points that do not exist
     * @param place    place of a polygon in its file, for remarks: "layer 2, polygon 7"
     * @param work     shared by all polygons of a scene
     */
    public Triangulation(FloatList points, Polygons polygons, IntFunction<String> place, WorkBudget work,
            Diagnostics notes) {
        this.points = points;
        this.polygons = polygons;
        this.place = place;
        this.notes = notes;
        this.outline = new PolygonRing(points, polygons);
        this.ears = new EarClipper(outline, work);
        this.seen = new PolygonSet(points, polygons);
    }

    /** Appends the corners of a polygon's triangles, 3 per triangle; notes and drops a polygon that cannot be cut. */
    public void cut(int polygon, IntList triangles) {
        int corners = polygons.end(polygon) - polygons.start(polygon);
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
        notes.note(place.apply(polygon), remark);
    }

    private boolean isSound(int polygon) {
        for (int c = polygons.start(polygon); c < polygons.end(polygon); c++) {
            int point = polygons.point(c);
            if (3 * point >= points.size()) {
                note(polygon, "polygons with points that do not exist are dropped");
                return false;
            }
            if (!isFinite(point)) {
                note(polygon, "polygons with coordinates that are no finite numbers are dropped");
                return false;
            }
        }
        return true;
    }

    private boolean isFinite(int point) {
        return Float.isFinite(points.get(3 * point)) && Float.isFinite(points.get(3 * point + 1))
                && Float.isFinite(points.get(3 * point + 2));
    }

    private void fan(IntList triangles) {
        for (int i = 2; i < outline.size(); i++) {
            triangles.add(outline.corner(0));
            triangles.add(outline.corner(i - 1));
            triangles.add(outline.corner(i));
        }
    }

    private void ears(int polygon, IntList triangles) {
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
