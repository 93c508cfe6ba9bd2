package radiosity.input.polygon;

import radiosity.input.file.FloatList;
import radiosity.util.Hash;
import radiosity.util.LongIndex;

/**
 * The set of polygons met so far, compared by a hash of 64 bits. Polygons are equal if they visit the same places in
 * the same order, whichever corner is first; a polygon and its reverse are different.
 */
final class PolygonSet {

    private final FloatList points;
    private final Polygons polygons;
    private final LongIndex seen = new LongIndex(16);

    PolygonSet(FloatList points, Polygons polygons) {
        this.points = points;
        this.polygons = polygons;
    }

    /** Adds a polygon; false if an equal one was added before. */
    boolean add(PolygonRing outline) {
        int next = seen.size();
        return seen.findOrAdd(hash(outline), next) == next;
    }

    /** The sum over all corners of a hash of the corner and its neighbours: independent of which corner is first. */
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

    /** A hash of a corner's position; adding 0 turns -0 into +0. */
    private long place(int corner) {
        int p = 3 * polygons.point(corner);
        long x = Float.floatToIntBits(points.get(p) + 0f);
        long y = Float.floatToIntBits(points.get(p + 1) + 0f);
        long z = Float.floatToIntBits(points.get(p + 2) + 0f);
        return Hash.mix(Hash.mix(x, y), z);
    }
}
