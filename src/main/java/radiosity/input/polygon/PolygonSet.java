package radiosity.input.polygon;

import radiosity.input.file.FloatList;
import radiosity.util.Hash;
import radiosity.util.LongIndex;

/**
 * Which polygons have been met: the same places in the same order round, wherever it begins. A reversed twin is another
 * polygon.
 */
final class PolygonSet {

    private final FloatList points;
    private final Polygons polygons;
    private final LongIndex seen = new LongIndex(16);

    PolygonSet(FloatList points, Polygons polygons) {
        this.points = points;
        this.polygons = polygons;
    }

    /** False if the polygon has been met before. */
    boolean add(PolygonRing outline) {
        int next = seen.size();
        return seen.findOrAdd(hash(outline), next) == next;
    }

    /** The sum over the corners of what the corner and the next two make: where it begins does not matter. */
    private long hash(PolygonRing outline) {
        int n = outline.size();
        long before = place(outline.corner(n - 1));
        long here = place(outline.corner(0));
        long hash = n;
        for (int i = 0; i < n; i++) {
            long after = place(outline.corner(i + 1 == n ? 0 : i + 1));
            hash += Hash.mix(Hash.mix(before, here), after);
            before = here;
            here = after;
        }
        return hash;
    }

    /** Adding zero makes minus zero plus zero. */
    private long place(int corner) {
        int p = 3 * polygons.point(corner);
        long x = Float.floatToIntBits(points.get(p) + 0f);
        long y = Float.floatToIntBits(points.get(p + 1) + 0f);
        long z = Float.floatToIntBits(points.get(p + 2) + 0f);
        return Hash.mix(Hash.mix(x, y), z);
    }
}
