package radiosity.input.polygon;

import radiosity.input.file.WorkBudget;

/**
 * Grid of the corners of a polygon that are not convex, to find those in the bounding box of a triangle.
 *
 * <p>Corners that have become convex or were cut off are removed from the grid when a search first meets them.
 */
final class CornerGrid {

    private static final int MOST_CELLS_PER_SIDE = 256;

    private final PolygonRing outline;
    private final WorkBudget work;
    private int side = 1;
    private double left;
    private double bottom;
    private double cellsPerWidth;
    private double cellsPerHeight;
    /** Index in {@link #corners} of the first corner of each cell, and the index behind the last one that is left. */
    private int[] starts = new int[1];
    private int[] ends = new int[1];
    private int[] corners = new int[16];
    private boolean[] convex = new boolean[0];

    /* The cells of the box that is searched, and the position of the search. */
    private int firstColumn;
    private int lastColumn;
    private int lastRow;
    private int column;
    private int row;
    private int at;

    CornerGrid(PolygonRing outline, WorkBudget work) {
        this.outline = outline;
        this.work = work;
    }

    /**
     * Enters the corners that are not convex.
     *
     * @param flags whether each corner is convex; kept, and read again by each search
     */
    void fill(boolean[] flags) {
        convex = flags;
        int n = 0;
        for (int i = 0; i < outline.size(); i++) {
            n += convex[i] ? 0 : 1;
        }
        side = Math.max(1, Math.min(MOST_CELLS_PER_SIDE, (int) Math.sqrt(n / 2.0)));
        measure();
        int[] counts = new int[side * side + 1];
        for (int i = 0; i < outline.size(); i++) {
            if (!convex[i]) {
                counts[cell(i) + 1]++;
            }
        }
        for (int c = 0; c < side * side; c++) {
            counts[c + 1] += counts[c];
        }
        starts = counts;
        ends = counts.clone();
        corners = new int[n];
        for (int i = 0; i < outline.size(); i++) {
            if (!convex[i]) {
                corners[ends[cell(i)]++] = i;
            }
        }
    }

    private void measure() {
        left = Double.POSITIVE_INFINITY;
        bottom = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double top = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < outline.size(); i++) {
            left = Math.min(left, outline.x[i]);
            right = Math.max(right, outline.x[i]);
            bottom = Math.min(bottom, outline.y[i]);
            top = Math.max(top, outline.y[i]);
        }
        cellsPerWidth = side / (right - left);
        cellsPerHeight = side / (top - bottom);
    }

    private int cell(int corner) {
        return row(outline.y[corner]) * side + column(outline.x[corner]);
    }

    private int column(double x) {
        return Math.max(0, Math.min(side - 1, (int) ((x - left) * cellsPerWidth)));
    }

    private int row(double y) {
        return Math.max(0, Math.min(side - 1, (int) ((y - bottom) * cellsPerHeight)));
    }

    /** Starts a search of the cells of the bounding box of a triangle. */
    void look(int a, int b, int c) {
        firstColumn = column(Math.min(outline.x[a], Math.min(outline.x[b], outline.x[c])));
        lastColumn = column(Math.max(outline.x[a], Math.max(outline.x[b], outline.x[c])));
        lastRow = row(Math.max(outline.y[a], Math.max(outline.y[b], outline.y[c])));
        row = row(Math.min(outline.y[a], Math.min(outline.y[b], outline.y[c])));
        column = firstColumn;
        at = starts[cell()];
    }

    private int cell() {
        return row * side + column;
    }

    /** Moves to the next corner in the searched cells that is not convex; false at the end. */
    boolean next() {
        while (true) {
            work.spend(1);
            int cell = cell();
            while (at < ends[cell] && convex[corners[at]]) {
                corners[at] = corners[--ends[cell]];
            }
            if (at < ends[cell]) {
                at++;
                return true;
            }
            if (!nextCell()) {
                return false;
            }
        }
    }

    /** The corner that the last {@link #next} moved to. */
    int corner() {
        return corners[at - 1];
    }

    private boolean nextCell() {
        if (column < lastColumn) {
            column++;
        } else if (row < lastRow) {
            row++;
            column = firstColumn;
        } else {
            return false;
        }
        at = starts[cell()];
        return true;
    }
}
