package radiosity.formfactor;

/**
 * A square cell of directions, some of whose corners see the sky: how much of the cell does, where one edge cuts it in
 * two.
 *
 * <p>Bisection finds the two points at which the edge leaves the cell, and from the middle of the line between them how
 * far the edge is from that line. A low edge is taken for a parabola, with two thirds of length times height between it
 * and the line (Archimedes); the halves of a higher one are treated like the whole. Where the edge has a corner in the
 * next cell, beyond a side whose ends are alike, what is seen there counts here.
 */
final class CutCell {

    /** Steps of bisection, which find a point of an edge to half of 2^-STEPS of the length that is searched. */
    private static final int STEPS = 7;
    /** Distance between a smooth edge and the line between its ends, over the length of that line, at most. */
    private static final double SMOOTH = 0.125;
    /** The same of any edge: that of a corner of 53 degrees. */
    private static final double HIGHEST = 1;
    /** The same of half an edge: that of a corner of 67 degrees. */
    private static final double HIGHEST_HALF = 0.75;
    /** Largest share that a part may have with what lies beyond a side; what seems larger is no single edge. */
    private static final double MOST_SHARE = 1.5;
    /** Number of times that an edge is halved. */
    private static final int HALVINGS = 4;

    /** Whether the sky is seen towards a point of the square of directions. */
    @FunctionalInterface
    interface Sight {
        boolean sees(double row, double column);
    }

    /** Rows and columns of the corners, in the order of a walk around the cell. */
    private final double[] row;
    private final double[] column;
    private final boolean[] isSeen;
    private final Sight sight;
    /** Row and column of a corner of the edge that lies beyond a side; null where none does. */
    private double[] beyond;

    /** @param isSeen whether the corners see the sky: (row, column), the next column, the next of both, the next row */
    CutCell(double row, double column, double size, boolean[] isSeen, Sight sight) {
        this.row = new double[] {row, row, row + size, row + size};
        this.column = new double[] {column, column + size, column + size, column};
        this.isSeen = isSeen;
        this.sight = sight;
    }

    /**
     * The part of a cell that sees the sky.
     *
     * @param share  its area over the cell's; may be above 1 with what lies beyond a side
     * @param row    of its corners; the first and last are on the edge
     * @param beyond a place in the next cell that is included; null where nothing is
     */
    record Part(double share, double[] row, double[] column, double[] beyond) { }

    /** The part that sees the sky; null where that is not one part with one edge. */
    Part seen() {
        int first = -1;
        int count = 0;
        for (int k = 0; k < 4; k++) {
            int next = k + 1 & 3;
            if (isSeen[k] == isSeen[next] && isSeen[k]
                    != sight.sees((row[k] + row[next]) / 2, (column[k] + column[next]) / 2)) {
                return null;
            }
            count += isSeen[k] ? 1 : 0;
            if (isSeen[k] && !isSeen[k + 3 & 3]) {
                if (first >= 0) {
                    return null;
                }
                first = k;
            }
        }
        if (first < 0) {
            return null;
        }
        double[] r = new double[count + 2];
        double[] c = new double[count + 2];
        for (int i = 0; i < count; i++) {
            r[i + 1] = row[first + i & 3];
            c[i + 1] = column[first + i & 3];
        }
        cross(first, first + 3 & 3, r, c, 0);
        cross(first + count - 1 & 3, first + count & 3, r, c, count + 1);
        double beside = besideLine(r[count + 1], c[count + 1], r[0], c[0], HALVINGS);
        double side = row[2] - row[0];
        double share = (area(r, c) + beside) / (side * side);
        return share >= 0 && share <= MOST_SHARE ? new Part(share, r, c, beyond) : null;
    }

    /** Finds where the edge crosses the side between a seen corner and one that is not, and writes the place there. */
    private void cross(int from, int to, double[] r, double[] c, int at) {
        double place = bisect(row[from], column[from], row[to] - row[from], column[to] - column[from]);
        r[at] = row[from] + place * (row[to] - row[from]);
        c[at] = column[from] + place * (column[to] - column[from]);
    }

    /** Part of the way by (dr, dc) from a seen point, to one that is not, at which the edge lies. */
    private double bisect(double r, double c, double dr, double dc) {
        double low = 0;
        double step = 0.5;
        for (int i = 0; i < STEPS; i++, step /= 2) {
            low += sight.sees(r + (low + step) * dr, c + (low + step) * dc) ? step : 0;
        }
        return low + step;
    }

    /**
     * Area between the edge and the line from one of its points to another, which has the seen polygon on its left;
     * positive where the edge is on the right. NaN where that is not one edge.
     */
    private double besideLine(double r0, double c0, double r1, double c1, int halvings) {
        double dr = r1 - r0;
        double dc = c1 - c0;
        double square = dr * dr + dc * dc;
        double r = (r0 + r1) / 2;
        double c = (c0 + c1) / 2;
        if (square == 0) {
            return 0;
        }
        double height = height(r, c, dr, dc, -SMOOTH, SMOOTH);
        if (!Double.isNaN(height)) {
            return 2. / 3 * square * height;
        }
        double highest = halvings == HALVINGS ? HIGHEST : HIGHEST_HALF;
        height = height(r, c, dr, dc, -SMOOTH, highest);
        height = Double.isNaN(height) ? height(r, c, dr, dc, -highest, SMOOTH) : height;
        double top = square * height / 2;
        if (halvings == 0 || Double.isNaN(height)) {
            return top;
        }
        double topR = r - height * dc;
        double topC = c + height * dr;
        if (topR < row[0] || topR > row[2] || topC < column[0] || topC > column[2]) {
            beyond = new double[] {topR, topC};
        }
        return top + besideLine(r0, c0, topR, topC, halvings - 1) + besideLine(topR, topC, r1, c1, halvings - 1);
    }

    /**
     * Distance of the edge from the middle of a line, over the line's length: positive to the right of the direction
     * (dr, dc). NaN where what is at {@code low} is not seen, or what is at {@code high} is.
     */
    private double height(double r, double c, double dr, double dc, double low, double high) {
        boolean isBetween = sight.sees(r - low * dc, c + low * dr) && !sight.sees(r - high * dc, c + high * dr);
        return !isBetween ? Double.NaN : low + (high - low)
                * bisect(r - low * dc, c + low * dr, (low - high) * dc, (high - low) * dr);
    }

    /** Area of a polygon whose corners are in the order of the cell's. */
    private static double area(double[] r, double[] c) {
        double twice = 0;
        for (int i = 0; i < r.length; i++) {
            int next = (i + 1) % r.length;
            twice += c[i] * r[next] - c[next] * r[i];
        }
        return twice / 2;
    }
}
