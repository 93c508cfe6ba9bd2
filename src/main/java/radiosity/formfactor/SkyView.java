package radiosity.formfactor;

import java.util.function.Predicate;
import radiosity.scene.Vec3;
import radiosity.util.Frame;
import radiosity.util.Hash;

/**
 * What a point sees of a sky: the mean of the luminance over the circle below its hemisphere (W. Nusselt, 1928).
 *
 * <p>The circle is mapped to a square (P. Shirley, K. Chiu, A low distortion map between disk and square, 1997), and
 * rays go to the corners and middles of square cells. A cell with one edge is cut along that edge ({@link CutCell}).
 * Other cells with edges are divided, until each part is cut by one edge, or so small that it counts by a random point.
 * Where an edge crosses a side of a divided cell, the cell beyond that side is divided, too: so an opening less wide
 * than a cell is followed to its ends. An opening smaller than a cell may be missed, such as one of 1 m from 24 m away.
 *
 * <p>In an intricate view, as behind leaves or many bars, bars thinner than a cell would be missed, and those that are
 * met would be divided. So rays have random directions there, in all cells that have edges or lie beside such cells.
 */
final class SkyView {

    /** Cells along a side of the square. */
    private static final int SIDE = 48;
    /** Corners along a side of the square. A cell has the number of its first corner. */
    private static final int ROW = SIDE + 1;
    /** Parts along a side of a cell that is divided down to the smallest parts; a power of 2. */
    private static final int PARTS = 16;
    /** Standard deviation that divided cells may leave, relative to the luminance in all others. */
    private static final double UNCERTAIN = 0.0005;
    /** The same of an intricate view, relative to what is seen, over the tolerance of rays; at least, and at most. */
    private static final double INTRICATE = 0.25;
    private static final double LEAST_INTRICATE = 0.005;
    private static final double MOST_INTRICATE = 0.02;
    /**
     * A view is intricate if more cells than this have several edges, or twice as many where openings are narrow, or if
     * more than {@link #MOST_EDGES} have any.
     */
    private static final int MOST_DIVIDED = SIDE;
    /** The edge of a convex opening passes no more cells than lie around the square. */
    private static final int MOST_EDGES = 4 * SIDE;
    /** Largest number of rows of random directions in a cell. */
    private static final int MOST_ROWS = 8;
    /** Number of parts that all divided cells together may have. */
    private static final int MOST_PARTS = 2 * SIDE * SIDE;
    /** Sine of an elevation up to which a direction is on the horizon. */
    private static final double LEVEL = 1e-12;
    /** 3 per corner of the cells, row by row: components of its direction along a point's two tangents and normal. */
    private static final double[] CORNERS = directions(ROW, 0);
    /** The same for the middles of the cells. */
    private static final double[] MIDDLES = directions(SIDE, 0.5);

    private final Sky sky;
    private final Predicate<Vec3> free;
    private final Sky.Detail detail;
    private final Frame frame;
    /** Components of the sky's zenith along the frame. */
    private final double[] up;
    /** 1 per corner: luminance that the point sees there. */
    private final double[] seen = new double[ROW * ROW];
    /** 1 per cell: whether what is seen in it counts as part of the cell beside it. */
    private final boolean[] beyond = new boolean[ROW * SIDE];
    private final boolean[] isDivided = new boolean[ROW * SIDE];
    /** The divided cells, {@link #count} of them. */
    private final int[] divided = new int[SIDE * SIDE];
    private int count;
    /** Side of the largest squares that are cut. */
    private int most;
    /** Side of the smallest parts. */
    private int least;

    /**
     * @param n    normal of the point, length 1
     * @param free whether no triangle stands in the way in a direction from the point
     */
    SkyView(Sky sky, Vec3 n, Predicate<Vec3> free, Sky.Detail detail) {
        this.detail = detail;
        this.sky = sky;
        this.free = free;
        frame = Frame.of(n);
        up = new double[] {frame.u().dot(sky.up()), frame.v().dot(sky.up()), n.dot(sky.up())};
    }

    /** Directions of a place in every cell of some rows, row by row; offset is the place's distance from the corner. */
    private static double[] directions(int side, double offset) {
        double[] directions = new double[3 * side * side];
        for (int i = 0; i < side * side; i++) {
            double[] local = direction((i / side + offset) * PARTS, (i % side + offset) * PARTS);
            System.arraycopy(local, 0, directions, 3 * i, 3);
        }
        return directions;
    }

    /** Direction of a point of the square: components along two tangents and the normal; row and column in parts. */
    private static double[] direction(double row, double column) {
        return onCircle(2 * row / (SIDE * PARTS) - 1, 2 * column / (SIDE * PARTS) - 1);
    }

    /** The same of a point of the square from -1 to 1: components along two tangents and the normal. */
    static double[] onCircle(double a, double b) {
        boolean byA = Math.abs(a) > Math.abs(b);
        double r = byA ? a : b;
        double angle = r == 0 ? 0 : byA ? Math.PI / 4 * (b / a) : Math.PI / 2 - Math.PI / 4 * (a / b);
        return new double[] {r * StrictMath.cos(angle), r * StrictMath.sin(angle), Math.sqrt(Math.max(0, 1 - r * r))};
    }

    /** Mean over the circle of the luminance that the point sees. To be called once. */
    double mean() {
        for (int i = 0; i < seen.length; i++) {
            seen[i] = at(CORNERS, 3 * i);
        }
        int edges = edges();
        if (edges > MOST_EDGES) {
            return intricate();
        }
        most = most(edges);
        double[] mean = new double[ROW * SIDE];
        for (int i = 0; i < mean.length; i++) {
            mean[i] = i % ROW == SIDE ? 0 : whole(i);
        }
        double sum = 0;
        for (int i = 0; i < mean.length; i++) {
            if (Double.isNaN(mean[i])) {
                mean[i] = isAlike(i) ? seen[i] : 0;
                divide(i);
            }
            sum += mean[i];
        }
        if (count > (most == PARTS ? MOST_DIVIDED : 2 * MOST_DIVIDED)) {
            return intricate();
        }
        least = Math.min(PARTS / 2, Math.max(least(count, UNCERTAIN * sum), affordable(count)));
        most = Math.max(most, least);
        for (int k = 0; k < count; k++) {
            int i = divided[k];
            sum += parts(i / ROW * PARTS, i % ROW * PARTS, PARTS, seen[i], seen[i + 1], seen[i + ROW],
                    seen[i + ROW + 1]) - mean[i];
        }
        return sum / (SIDE * SIDE);
    }

    /** Number of cells whose corners do not see all the same. */
    private int edges() {
        int edges = 0;
        for (int i = 0; i < ROW * SIDE; i++) {
            edges += i % ROW == SIDE || isAlike(i) ? 0 : 1;
        }
        return edges;
    }

    /** Mean over the circle, of an intricate view. */
    private double intricate() {
        double[] mean = new double[ROW * SIDE];
        int mixed = 0;
        double sum = 0;
        for (int i = 0; i < mean.length; i++) {
            mean[i] = i % ROW == SIDE ? 0 : isAlike(i) ? whole(i) : Double.NaN;
            mixed += Double.isNaN(mean[i]) ? 1 : 0;
            sum += Double.isNaN(mean[i]) ? 0 : mean[i];
        }
        double uncertain = Math.max(LEAST_INTRICATE, Math.min(MOST_INTRICATE, INTRICATE * detail.tolerance()))
                * (sum + mixed / 2.);
        int rows = (int) Math.max(1, Math.min(MOST_ROWS, Math.ceil(Math.sqrt(mixed) / 2 / uncertain)));
        for (int i = 0; i < mean.length; i++) {
            if (i % ROW != SIDE && hasEdgeNear(mean, i)) {
                sum += random(i, rows) - (Double.isNaN(mean[i]) ? 0 : mean[i]);
            }
        }
        return sum / (SIDE * SIDE);
    }

    /** Whether the mean of a cell, or of one of the 8 around it, is NaN. */
    private static boolean hasEdgeNear(double[] mean, int cell) {
        boolean has = false;
        for (int r = Math.max(0, cell / ROW - 1); r <= Math.min(SIDE - 1, cell / ROW + 1); r++) {
            for (int c = Math.max(0, cell % ROW - 1); c <= Math.min(SIDE - 1, cell % ROW + 1); c++) {
                has |= Double.isNaN(mean[r * ROW + c]);
            }
        }
        return has;
    }

    /** Mean luminance over a cell, seen in random directions in some rows of as many parts. */
    private double random(int cell, int rows) {
        double sum = 0;
        double size = (double) PARTS / rows;
        for (int i = 0; i < rows * rows; i++) {
            long place = Hash.mix(detail.key(), (long) cell * MOST_ROWS * MOST_ROWS + i);
            sum += at(cell / ROW * PARTS + size * (i / rows + Hash.unit(Hash.mix(place, 0))),
                    cell % ROW * PARTS + size * (i % rows + Hash.unit(Hash.mix(place, 1))));
        }
        return sum / (rows * rows);
    }

    /** Notes that a cell is to be divided, unless it counts as part of the cell beside it. */
    private void divide(int cell) {
        if (!isDivided[cell] && !(beyond[cell] && isAlike(cell))) {
            isDivided[cell] = true;
            divided[count++] = cell;
        }
    }

    /**
     * Side of parts so small that they leave little uncertain: each half its luminance, the errors of any two
     * independent. An edge passes twice as many parts of half the side.
     *
     * @param cells     number of cells that are to be divided
     * @param uncertain standard deviation that may be left, in luminances of a cell
     */
    private static int least(int cells, double uncertain) {
        int size = PARTS / 2;
        while (size > 1 && Math.sqrt((double) cells * PARTS / size) * size * size / (2 * PARTS * PARTS)
                > uncertain) {
            size /= 2;
        }
        return size;
    }

    /** Side of the smallest parts into which some cells may be divided, with no more than {@link #MOST_PARTS}. */
    private static int affordable(int cells) {
        int size = 1;
        while (size < PARTS && (long) cells * PARTS * PARTS > (long) MOST_PARTS * size * size) {
            size *= 2;
        }
        return size;
    }

    /**
     * Side of squares that are less wide than openings. The mean width of openings is twice their area over the length
     * of their edges, both counted in cells. Narrow openings differ more in width from end to end.
     */
    private int most(int edges) {
        int open = 0;
        for (int i = 0; i < ROW * SIDE; i++) {
            open += seen[i] > 0 ? 1 : 0;
        }
        int size = PARTS;
        while (size > 1 && open * PARTS < edges * size) {
            size /= 2;
        }
        return Math.max(size < PARTS / 2 ? Math.max(1, size / 2) : size, affordable(edges));
    }

    private boolean isAlike(int cell) {
        return isAlike(seen[cell], seen[cell + 1], seen[cell + ROW], seen[cell + ROW + 1]);
    }

    private static boolean isAlike(double a, double b, double c, double d) {
        return a > 0 == b > 0 && b > 0 == c > 0 && c > 0 == d > 0;
    }

    /** Mean luminance over a cell; NaN where it is to be divided. */
    private double whole(int cell) {
        int row = cell / ROW * PARTS;
        int column = cell % ROW * PARTS;
        double mean = undivided(row, column, PARTS, seen[cell], seen[cell + 1], seen[cell + ROW], seen[cell + ROW + 1]);
        if (!isAlike(cell)) {
            return mean;
        }
        double middle = at(MIDDLES, 3 * (cell / ROW * SIDE + cell % ROW));
        // exact where luminance is a square polynomial: on a line the same as Simpson's rule
        return middle > 0 == mean > 0 ? (mean + 2 * middle) / 3 : Double.NaN;
    }

    /** Mean luminance over a square whose corners have the luminances a to d; NaN where it is to be divided. */
    private double undivided(int row, int column, int size, double a, double b, double c, double d) {
        if (isAlike(a, b, c, d)) {
            return (a + b + c + d) / 4;
        }
        if (isBelowHorizon(row, column, size)) {
            return 0;
        }
        boolean[] isSeen = {a > 0, b > 0, d > 0, c > 0};
        CutCell.Part part = size > most ? null
                : new CutCell(row, column, size, isSeen, (r, s) -> at(r, s) > 0).seen();
        if (part == null) {
            return Double.NaN;
        }
        if (part.beyond() != null && size == PARTS) {
            int r = (int) Math.floor(part.beyond()[0] / PARTS);
            int s = (int) Math.floor(part.beyond()[1] / PARTS);
            if (r >= 0 && r < SIDE && s >= 0 && s < SIDE) {
                beyond[r * ROW + s] = true;
            }
        }
        return part.share() * luminance(part);
    }

    /** Mean luminance over a square that is divided into four. */
    private double parts(int row, int column, int size, double a, double b, double c, double d) {
        int half = size / 2;
        double middle = at(row + half, column + half);
        double above = at(row, column + half);
        double left = at(row + half, column);
        double right = at(row + half, column + size);
        double below = at(row + size, column + half);
        follow(row - 1, column + half, above > 0);
        follow(row + half, column - 1, left > 0);
        follow(row + half, column + size, right > 0);
        follow(row + size, column + half, below > 0);
        return (part(row, column, half, a, above, left, middle)
                + part(row, column + half, half, above, b, middle, right)
                + part(row + half, column, half, left, middle, c, below)
                + part(row + half, column + half, half, middle, right, below, d)) / 4;
    }

    /** Divides the cell at row and column where a place on its side does not see what its corners see. */
    private void follow(int row, int column, boolean isSeen) {
        boolean isInside = row >= 0 && row < SIDE * PARTS && column >= 0 && column < SIDE * PARTS;
        int cell = row / PARTS * ROW + column / PARTS;
        if (isInside && isAlike(cell) && isSeen != seen[cell] > 0) {
            divide(cell);
        }
    }

    /** Mean luminance over a part of a divided cell. */
    private double part(int row, int column, int size, double a, double b, double c, double d) {
        double mean = size > most ? Double.NaN : undivided(row, column, size, a, b, c, d);
        if (!Double.isNaN(mean)) {
            return mean;
        }
        if (size == least) {
            long key = Hash.mix(row, column);
            return at(row + size * Hash.unit(Hash.mix(key, 0)), column + size * Hash.unit(Hash.mix(key, 1)));
        }
        return parts(row, column, size, a, b, c, d);
    }

    /**
     * Mean luminance of the sky, seen or not, over a part of a cell: of its corners and, as in {@link #whole}, its
     * middle, which counts so that the mean of a square polynomial over a triangle or a rectangle is exact.
     */
    private double luminance(CutCell.Part part) {
        int corners = part.row().length;
        double sum = 0;
        double row = 0;
        double column = 0;
        for (int i = 0; i < corners; i++) {
            sum += whole(part.row()[i], part.column()[i]);
            row += part.row()[i] / corners;
            column += part.column()[i] / corners;
        }
        int middle = corners == 3 ? 3 : 2;
        return (sum / corners + middle * whole(row, column)) / (1 + middle);
    }

    /** Luminance of the sky, seen or not, at a point of the square; at the horizon what is below it. */
    private double whole(double row, double column) {
        double[] local = direction(row, column);
        return sky.luminance(global(local, 0), Math.max(0, height(local, 0)));
    }

    /** Whether no corner of a square is above the horizon, though some may be on it, which count as sky. */
    private boolean isBelowHorizon(int row, int column, int size) {
        return height(row, column) <= LEVEL && height(row, column + size) <= LEVEL
                && height(row + size, column) <= LEVEL && height(row + size, column + size) <= LEVEL;
    }

    private double height(int row, int column) {
        return height(direction(row, column), 0);
    }

    /** Sine of the elevation of a direction: 3 components from {@code from}, as in {@link #CORNERS}. */
    private double height(double[] local, int from) {
        return local[from] * up[0] + local[from + 1] * up[1] + local[from + 2] * up[2];
    }

    private double at(double row, double column) {
        return at(direction(row, column), 0);
    }

    /** Luminance that the point sees in a direction: 3 components from {@code from}, as in {@link #CORNERS}. */
    private double at(double[] local, int from) {
        double height = height(local, from);
        if (height < -LEVEL) {
            return 0;
        }
        Vec3 d = global(local, from);
        return free.test(d) ? sky.luminance(d, height) : 0;
    }

    private Vec3 global(double[] local, int from) {
        return frame.vector(local[from], local[from + 1], local[from + 2]);
    }
}
