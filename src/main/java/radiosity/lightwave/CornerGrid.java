package radiosity.lightwave;

/** The corners of an outline that are not convex, in the cells of a grid, to find those in a triangle's box. */
final class CornerGrid {

    private static final int MOST_CELLS_PER_SIDE = 256;

    private final Outline outline;
    private int side = 1;
    private double left;
    private double bottom;
    private double cellsPerWidth;
    private double cellsPerHeight;
    /** Index of the first corner of each cell, one more than cells. */
    private int[] starts = new int[2];
    private int[] corners = new int[16];

    /* The cells of the box looked at, and the place in them. */
    private int firstColumn;
    private int lastColumn;
    private int lastRow;
    private int column;
    private int row;
    private int at;
    private int end;

    CornerGrid(Outline outline) {
        this.outline = outline;
    }

    /** Takes the corners that are not convex. */
    void fill(boolean[] convex) {
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
        deal(convex, n);
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

    private void deal(boolean[] convex, int n) {
        corners = new int[n];
        int[] places = starts.clone();
        for (int i = 0; i < outline.size(); i++) {
            if (!convex[i]) {
                corners[places[cell(i)]++] = i;
            }
        }
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

    /** Begins to go through the corners in the cells of a triangle's box. */
    void look(int a, int b, int c) {
        firstColumn = column(Math.min(outline.x[a], Math.min(outline.x[b], outline.x[c])));
        lastColumn = column(Math.max(outline.x[a], Math.max(outline.x[b], outline.x[c])));
        lastRow = row(Math.max(outline.y[a], Math.max(outline.y[b], outline.y[c])));
        row = row(Math.min(outline.y[a], Math.min(outline.y[b], outline.y[c])));
        column = firstColumn;
        enterCell();
    }

    private void enterCell() {
        at = starts[row * side + column];
        end = starts[row * side + column + 1];
    }

    boolean hasNext() {
        while (at == end) {
            if (column < lastColumn) {
                column++;
            } else if (row < lastRow) {
                row++;
                column = firstColumn;
            } else {
                return false;
            }
            enterCell();
        }
        return true;
    }

    int next() {
        return corners[at++];
    }
}
