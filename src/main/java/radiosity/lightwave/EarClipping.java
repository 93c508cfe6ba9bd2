package radiosity.lightwave;

/**
 * Cuts an outline into triangles by taking off ears.
 *
 * <p>An ear is a convex corner whose triangle holds no other corner. Only corners that are not convex can lie in it;
 * they stand in a grid, so that a polygon of n corners mostly costs n log n and not n². Holes are joined to the outline
 * by edges walked both ways: corners at the place of one of the ear's own do not count.
 *
 * <p>Source of the method: G. Meisters, Polygons have ears (1975).
 */
final class EarClipping {

    /** Corners looked at before a polygon is given up: more than any sound one of 65,535 corners needs. */
    private static final long MOST_WORK = 200_000_000;

    private final Outline outline;
    private int[] next = new int[0];
    private int[] previous = new int[0];
    private boolean[] convex = new boolean[0];
    private final CornerGrid grid;
    private long work;

    /** How strict an ear is: no corner on its border; none inside; any convex corner; any corner. */
    private enum Level { CLEAR, TOUCHING, CONVEX, ANY }

    EarClipping(Outline outline) {
        this.outline = outline;
        this.grid = new CornerGrid(outline);
    }

    /**
     * Appends three corners of the outline for each triangle, n - 2 of them.
     *
     * <p>An outline that crosses itself, which folded polygons do when projected, keeps its border all the same: some
     * triangles then are reversed, and their area vectors still add up to the polygon's.
     *
     * @return twice the area of all triangles, more than the outline's if it crosses itself; NaN if it is too tangled
     */
    double cut(Ints triangles) {
        start();
        double area = 0;
        int left = outline.size();
        int corner = 0;
        int refused = 0;
        Level level = Level.CLEAR;
        while (left > 2 && work < MOST_WORK) {
            if (isEar(corner, level)) {
                area += takeOff(corner, triangles);
                corner = next[next[corner]];
                left--;
                refused = 0;
                level = Level.CLEAR;
            } else if (++refused < left) {
                corner = next[corner];
            } else if (level == Level.ANY) {
                return Double.NaN;
            } else {
                level = Level.values()[level.ordinal() + 1];
                refused = 0;
            }
        }
        return left > 2 ? Double.NaN : area;
    }

    private void start() {
        int n = outline.size();
        if (next.length < n) {
            next = new int[n];
            previous = new int[n];
            convex = new boolean[n];
        }
        for (int i = 0; i < n; i++) {
            next[i] = i + 1 == n ? 0 : i + 1;
            previous[i] = i == 0 ? n - 1 : i - 1;
        }
        for (int i = 0; i < n; i++) {
            convex[i] = outline.cross(previous[i], i, next[i]) > 0;
        }
        grid.fill(convex);
        work = n;
    }

    private double takeOff(int corner, Ints triangles) {
        int a = previous[corner];
        int c = next[corner];
        triangles.add(a);
        triangles.add(corner);
        triangles.add(c);
        double area = Math.abs(outline.cross(a, corner, c));
        next[a] = c;
        previous[c] = a;
        convex[corner] = true;
        convex[a] = outline.cross(previous[a], a, c) > 0;
        convex[c] = outline.cross(a, c, next[c]) > 0;
        return area;
    }

    private boolean isEar(int corner, Level level) {
        work++;
        if (!convex[corner] || level.compareTo(Level.CONVEX) >= 0) {
            return convex[corner] || level == Level.ANY;
        }
        int a = previous[corner];
        int c = next[corner];
        grid.look(a, corner, c);
        while (grid.hasNext()) {
            int p = grid.next();
            work++;
            if (!convex[p] && p != a && p != c && blocks(p, a, corner, c, level == Level.CLEAR)) {
                return false;
            }
        }
        return true;
    }

    private boolean blocks(int p, int a, int b, int c, boolean borderCounts) {
        if (samePlace(p, a) || samePlace(p, b) || samePlace(p, c)) {
            return false;
        }
        double least = Math.min(outline.cross(a, b, p), Math.min(outline.cross(b, c, p), outline.cross(c, a, p)));
        return borderCounts ? least >= 0 : least > 0;
    }

    private boolean samePlace(int p, int q) {
        return outline.x[p] == outline.x[q] && outline.y[p] == outline.y[q];
    }
}
