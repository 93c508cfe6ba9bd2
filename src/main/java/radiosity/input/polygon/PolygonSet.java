package radiosity.input.polygon;

import java.util.Arrays;
import radiosity.input.file.FloatList;

/**
 * Which polygons have been met: the same places in the same order round, wherever it begins. A reversed twin is another
 * polygon. Open addressing on 64-bit hashes.
 */
final class PolygonSet {

    private final FloatList points;
    private final Polygons polygons;
    private long[] table = new long[64];
    private int used;

    PolygonSet(FloatList points, Polygons polygons) {
        this.points = points;
        this.polygons = polygons;
    }

    /** False if the polygon has been met before. */
    boolean add(PolygonRing outline) {
        if (2 * used >= table.length) {
            grow();
        }
        return insert(hash(outline));
    }

    private boolean insert(long hash) {
        int i = (int) (hash >>> 32) & table.length - 1;
        while (table[i] != 0) {
            if (table[i] == hash) {
                return false;
            }
            i = i + 1 & table.length - 1;
        }
        table[i] = hash;
        used++;
        return true;
    }

    private void grow() {
        long[] old = table;
        table = new long[2 * old.length];
        used = 0;
        Arrays.stream(old).filter(h -> h != 0).forEach(this::insert);
    }

    /** The sum over the corners of what the corner and the next two make: where it begins does not matter. */
    private long hash(PolygonRing outline) {
        int n = outline.size();
        long before = place(outline.corner(n - 1));
        long here = place(outline.corner(0));
        long hash = n;
        for (int i = 0; i < n; i++) {
            long after = place(outline.corner(i + 1 == n ? 0 : i + 1));
            hash += mix(mix(mix(before) + here) + after);
            before = here;
            here = after;
        }
        return hash == 0 ? 1 : hash;
    }

    /** Adding zero makes minus zero plus zero. */
    private long place(int corner) {
        int p = 3 * polygons.point(corner);
        long x = Float.floatToIntBits(points.get(p) + 0f);
        long y = Float.floatToIntBits(points.get(p + 1) + 0f);
        long z = Float.floatToIntBits(points.get(p + 2) + 0f);
        return mix(mix(mix(x) + y) + z);
    }

    /**
     * The finaliser of SplitMix64 (G. Steele, D. Lea, C. Flood, Fast splittable pseudorandom number generators, 2014).
     */
    private static long mix(long v) {
        long z = v + 0x9E3779B97F4A7C15L;
        z = (z ^ z >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }
}
