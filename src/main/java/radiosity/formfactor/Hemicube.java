package radiosity.formfactor;

import radiosity.visibility.RadiosityBounds;

/**
 * Form factors by projection onto half a cube around the receiving point (section 2.3.1 of the paper; M. Cohen,
 * D. Greenberg, The hemi-cube, 1985).
 *
 * <p>A cell of size du dv at distance r has the delta form factor du dv / (pi r^4) on the top face, and du dv times the
 * cell's height above the base / (pi r^4) on the four side faces.
 */
final class Hemicube extends Projection {

    /** Cells along an edge of the top face where the user gives no number. */
    static final int DEFAULT_CELLS = 64;
    /** Depth before a cube face, in units of the scene's size, below which a patch is cut off before projection. */
    private static final double NEAR = 1e-9;
    /** Axes of the five faces: the components that run along u, along v and outwards, and the sign of the third. */
    private static final int[][] FACES = {{0, 1, 2, 1}, {1, 2, 0, 1}, {1, 2, 0, -1}, {0, 2, 1, 1}, {0, 2, 1, -1}};

    private final int cells;

    /** @param cells number of cells along an edge of the top face, rounded up to an even number */
    Hemicube(RadiosityBounds bounds, int cells) {
        super(bounds);
        this.cells = cells + cells % 2;
    }

    @Override
    void cover(View view) {
        for (int[] face : FACES) {
            cover(view, face);
        }
    }

    private void cover(View view, int[] face) {
        double[] range = range(view.corner, face);
        boolean top = face == FACES[0];
        double step = 2.0 / cells;
        double[] d = new double[3];
        d[face[2]] = face[3];
        for (int i = first(range[0]); i <= last(range[1]); i++) {
            d[face[0]] = (i + 0.5) * step - 1;
            for (int j = Math.max(top ? 0 : cells / 2, first(range[2])); j <= last(range[3]); j++) {
                d[face[1]] = (j + 0.5) * step - 1;
                double r2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
                view.cell(d[0], d[1], d[2], (top ? 1 : d[2]) * step * step / (Math.PI * r2 * r2));
            }
        }
    }

    private int first(double u) {
        return (int) Math.max(0, (u + 1) / 2 * cells - 0.5);
    }

    private int last(double u) {
        return (int) Math.min(cells - 1, (u + 1) / 2 * cells + 0.5);
    }

    /** Least and most u, least and most v of a triangle's part before a face; an empty range where no part is. */
    private static double[] range(double[] corner, int[] face) {
        double[] range = {Double.POSITIVE_INFINITY, -2, Double.POSITIVE_INFINITY, -2};
        for (int k = 0; k < 3; k++) {
            int p = 3 * k;
            int q = 3 * ((k + 1) % 3);
            double wp = face[3] * corner[p + face[2]];
            double wq = face[3] * corner[q + face[2]];
            if (wp >= NEAR) {
                include(range, corner[p + face[0]] / wp, corner[p + face[1]] / wp);
            }
            if (wp < NEAR != wq < NEAR) {
                double t = (NEAR - wp) / (wq - wp);
                include(range, (corner[p + face[0]] + t * (corner[q + face[0]] - corner[p + face[0]])) / NEAR,
                        (corner[p + face[1]] + t * (corner[q + face[1]] - corner[p + face[1]])) / NEAR);
            }
        }
        return range;
    }

    private static void include(double[] range, double u, double v) {
        range[0] = Math.min(range[0], u);
        range[1] = Math.max(range[1], u);
        range[2] = Math.min(range[2], v);
        range[3] = Math.max(range[3], v);
    }
}
