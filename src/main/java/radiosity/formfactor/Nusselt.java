package radiosity.formfactor;

import radiosity.visibility.RadiosityBounds;

/**
 * Form factors by Nusselt's projection (section 2.3.3 of the paper; W. Nusselt, Graphische Bestimmung des
 * Winkelverhältnisses bei der Wärmestrahlung, 1928): a patch is projected onto the hemisphere around the receiving
 * point, then down to the hemisphere's base. The share of the base that the patch covers is its form factor.
 *
 * <p>The cells are equal squares of the base.
 */
final class Nusselt extends Projection {

    /** Cells across the base where the user gives no number. */
    static final int DEFAULT_CELLS = 72;

    private final int cells;

    /** @param cells number of cells across the base */
    Nusselt(RadiosityBounds bounds, int cells) {
        super(bounds);
        this.cells = cells;
    }

    @Override
    void cover(View view) {
        double[] cap = cap(view.corner);
        double step = 2.0 / cells;
        for (int i = first(cap, 0); i <= last(cap, 0); i++) {
            double x = (i + 0.5) * step - 1;
            for (int j = first(cap, 1); j <= last(cap, 1); j++) {
                double y = (j + 0.5) * step - 1;
                double z2 = 1 - x * x - y * y;
                if (z2 > 0) {
                    view.cell(x, y, Math.sqrt(z2), step * step / Math.PI);
                }
            }
        }
    }

    private int first(double[] cap, int axis) {
        return (int) Math.max(0, (1 - most(-cap[axis], cap[3])) / 2 * cells - 0.5);
    }

    private int last(double[] cap, int axis) {
        return (int) Math.min(cells - 1, (1 + most(cap[axis], cap[3])) / 2 * cells + 0.5);
    }

    /** Largest coordinate along an axis within a cap: from the cap's middle and the cosine of its angular radius. */
    private static double most(double middle, double cos) {
        return !(cos > 0) || middle >= cos ? 1
                : middle * cos + Math.sqrt(Math.max(0, 1 - middle * middle)) * Math.sqrt(Math.max(0, 1 - cos * cos));
    }

    /** A cap of the sphere around a triangle's projection: 3 for the middle, then the cosine of the angular radius. */
    private static double[] cap(double[] corner) {
        double[] unit = new double[9];
        double[] cap = new double[4];
        for (int i = 0; i < 9; i++) {
            int k = i - i % 3;
            unit[i] = corner[i] / length(corner[k], corner[k + 1], corner[k + 2]);
            cap[i % 3] += unit[i];
        }
        double length = length(cap[0], cap[1], cap[2]);
        cap[3] = 1;
        for (int k = 0; k < 9; k += 3) {
            cap[3] = Math.min(cap[3], (cap[0] * unit[k] + cap[1] * unit[k + 1] + cap[2] * unit[k + 2]) / length);
        }
        for (int a = 0; a < 3; a++) {
            cap[a] /= length;
        }
        return cap;
    }

    private static double length(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }
}
