package radiosity.input.polygon;

import radiosity.input.file.IntList;
import radiosity.input.file.WorkBudget;

/**
 * Cuts a polygon into triangles by ear clipping.
 *
 * <p>An ear is a convex corner whose triangle contains no other corner. Only corners that are not convex can lie in the
 * triangle; a grid holds these corners. Cutting off an ear can make ears of its two neighbours only, so each corner is
 * tested a few times, and a polygon of n corners mostly costs n log n. Holes are joined to the outline by edges walked
 * both ways; therefore corners at the same place as a corner of the ear do not count.
 *
 * <p>Source of the method: G. Meisters, Polygons have ears (1975); J. O'Rourke, Computational geometry in C (1998),
 * 1.4.
 */
final class EarClipper {

    private final PolygonRing outline;
    private final WorkBudget work;
    private final CornerGrid grid;
    private int[] next = new int[0];
    private int[] previous = new int[0];
    private boolean[] convex = new boolean[0];
    /** Corners that are ears, and for each corner the index of its valid entry in this list; -1 for none. */
    private final IntList ears = new IntList();
    private int[] placeOf = new int[0];
    private int left;
    /** A corner that has not been cut off. */
    private int some;

    /** Strictness of the test for an ear: no corner inside or on the border; none inside; convex corner; any corner. */
    private enum Level { CLEAR, TOUCHING, CONVEX, ANY }

    EarClipper(PolygonRing outline, WorkBudget work) {
        this.outline = outline;
        this.work = work;
        this.grid = new CornerGrid(outline, work);
    }

    /**
     * Appends three corners of the outline for each triangle, n - 2 triangles in all.
     *
     * <p>An outline that crosses itself, as the projection of a folded polygon does, keeps its border: some triangles
     * are then reversed, and the area vectors of the triangles still add up to the polygon's.
     *
     * @return twice the area of all triangles, which is more than the outline's if the outline crosses itself; NaN if
     *         the budget of work is spent before the end
     */
    double cut(IntList triangles) {
        start();
        double area = 0;
        int at = 0;
        while (left > 2 && !work.isSpent()) {
            if (at == ears.size()) {
                area += takeOff(findEar(), triangles);
            } else if (placeOf[ears.get(at)] == at) {
                area += takeOff(ears.get(at), triangles);
            } else {
                at++;
            }
        }
        return left > 2 ? Double.NaN : area;
    }

    private void start() {
        left = outline.size();
        some = 0;
        if (next.length < left) {
            next = new int[left];
            previous = new int[left];
            convex = new boolean[left];
            placeOf = new int[left];
        }
        for (int i = 0; i < left; i++) {
            next[i] = i + 1 == left ? 0 : i + 1;
            previous[i] = i == 0 ? left - 1 : i - 1;
            convex[i] = outline.cross(previous[i], i, next[i]) > 0;
        }
        grid.fill(convex);
        work.grant(left);
        ears.cut(0);
        for (int i = 0; i < left; i++) {
            list(i);
        }
    }

    /** Appends a corner to the list if the corner is an ear; an earlier entry of the corner becomes invalid. */
    private void list(int corner) {
        placeOf[corner] = -1;
        if (isEar(corner, Level.CLEAR)) {
            placeOf[corner] = ears.size();
            ears.add(corner);
        }
    }

    /** The best corner to cut off from an outline without ears, which is degenerate or crosses itself. */
    private int findEar() {
        int start = some;
        for (Level level : Level.values()) {
            int corner = start;
            for (int i = 0; i < left && !work.isSpent(); i++) {
                if (isEar(corner, level)) {
                    return corner;
                }
                corner = next[corner];
            }
        }
        return start;
    }

    /** Cuts off a corner and appends its triangle; returns twice the triangle's area. */
    private double takeOff(int corner, IntList triangles) {
        int a = previous[corner];
        int c = next[corner];
        triangles.add(a);
        triangles.add(corner);
        triangles.add(c);
        next[a] = c;
        previous[c] = a;
        convex[corner] = true;
        placeOf[corner] = -1;
        convex[a] = outline.cross(previous[a], a, c) > 0;
        convex[c] = outline.cross(a, c, next[c]) > 0;
        left--;
        some = c;
        list(a);
        list(c);
        return Math.abs(outline.cross(a, corner, c));
    }

    private boolean isEar(int corner, Level level) {
        work.spend(1);
        if (!convex[corner] || level.compareTo(Level.CONVEX) >= 0) {
            return convex[corner] || level == Level.ANY;
        }
        int a = previous[corner];
        int c = next[corner];
        grid.look(a, corner, c);
        while (grid.next()) {
            int p = grid.corner();
            if (p != a && p != c && blocks(p, a, corner, c, level == Level.CLEAR)) {
                return false;
            }
        }
        return true;
    }

    /** Whether p lies in the triangle a, b, c, not at its corners; edge c a is first, as most corners lie beyond it. */
    private boolean blocks(int p, int a, int b, int c, boolean borderCounts) {
        double least = outline.cross(c, a, p);
        if (least < 0) {
            return false;
        }
        least = Math.min(least, Math.min(outline.cross(a, b, p), outline.cross(b, c, p)));
        return (borderCounts ? least >= 0 : least > 0) && !samePlace(p, a) && !samePlace(p, b) && !samePlace(p, c);
    }

    private boolean samePlace(int p, int q) {
        return outline.x[p] == outline.x[q] && outline.y[p] == outline.y[q];
    }
}
