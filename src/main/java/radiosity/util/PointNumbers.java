package radiosity.util;

/** Numbers for points: equal coordinates get equal numbers. */
public final class PointNumbers {

    private PointNumbers() { }

    /**
     * @param points x, y, z, 3 per point; not modified
     * @return 1 per point: the lowest index of a point with the same coordinates
     */
    public static int[] of(double[] points) {
        int n = points.length / 3;
        int[] number = new int[n];
        LongIndex index = new LongIndex(n);
        for (int p = 0; p < n; p++) {
            long key = Hash.mix(Hash.mix(bits(points[3 * p]), bits(points[3 * p + 1])), bits(points[3 * p + 2]));
            int first = index.findOrAdd(key, p);
            while (first != p && !same(points, first, p)) {
                key = Hash.mix(key, 1);
                first = index.findOrAdd(key, p);
            }
            number[p] = first;
        }
        return number;
    }

    /** The bits of a coordinate; -0 counts as 0. */
    private static long bits(double x) {
        return Double.doubleToLongBits(x + 0.0);
    }

    private static boolean same(double[] points, int p, int q) {
        return points[3 * p] == points[3 * q] && points[3 * p + 1] == points[3 * q + 1]
                && points[3 * p + 2] == points[3 * q + 2];
    }
}
