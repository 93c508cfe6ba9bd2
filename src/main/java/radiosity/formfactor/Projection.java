package radiosity.formfactor;

import radiosity.util.Hash;
import radiosity.visibility.RadiosityBounds;

/**
 * A calculator that divides the hemisphere of a receiving point into cells, each with a delta form factor. A patch's
 * form factor is the sum over the cells in which the patch is seen.
 *
 * <p>A patch is seen in a cell if a ray through the middle of the cell meets the patch first. An item buffer would give
 * the same, but here only the cells that the patch covers are examined.
 */
abstract class Projection extends PatchByPatch {

    Projection(RadiosityBounds bounds) {
        super(bounds);
    }

    /** A patch in the receiver's coordinates: x and y along the horizon, turned by an angle from its key, z up. */
    final class View {

        private final Receiver to;
        private final int node;
        /** 9: x, y, z of the corners, relative to the receiver. */
        final double[] corner = new double[9];
        /** 9: normals of the planes through the receiver and the edge opposite each corner, towards the inside. */
        private final double[] inside = new double[9];

        private View(Receiver to, int node) {
            this.to = to;
            this.node = node;
            double[] axes = axes(to);
            for (int i = 0; i < 9; i++) {
                int k = i / 3;
                int row = 3 * (i % 3);
                float[] c = to.shooter().corner;
                corner[i] = axes[row] * (c[9 * node + 3 * k] - to.px())
                        + axes[row + 1] * (c[9 * node + 3 * k + 1] - to.py())
                        + axes[row + 2] * (c[9 * node + 3 * k + 2] - to.pz());
            }
            for (int k = 0; k < 3; k++) {
                cross((k + 2) % 3, (k + 1) % 3, k);
            }
        }

        private void cross(int i, int j, int k) {
            for (int a = 0; a < 3; a++) {
                int b = (a + 1) % 3;
                int c = (a + 2) % 3;
                inside[3 * k + a] = corner[3 * i + b] * corner[3 * j + c] - corner[3 * i + c] * corner[3 * j + b];
            }
        }

        /** Adds the cell in a direction with its delta form factor, if the patch is seen there. */
        void cell(double x, double y, double z, double weight) {
            double a = x * inside[0] + y * inside[1] + z * inside[2];
            double b = x * inside[3] + y * inside[4] + z * inside[5];
            double c = x * inside[6] + y * inside[7] + z * inside[8];
            double sum = a + b + c;
            if (a >= 0 && b >= 0 && c >= 0 && sum > 0) {
                float fb = (float) (b / sum);
                float fc = (float) (c / sum);
                addSample(to, node, Math.max(0, 1 - fb - fc), fb, fc, weight);
            }
        }
    }

    @Override
    final double patch(Receiver to, int node) {
        cover(new View(to, node));
        return 1;
    }

    /** Calls {@link View#cell} for every cell that the patch may cover. */
    abstract void cover(View view);

    /**
     * Two axes along the horizon and the normal, 3 numbers each. The axes are turned by an angle from the receiver's
     * key, else neighbouring receivers would have similar errors. Sine and cosine come from t = tan of half the angle.
     */
    private static double[] axes(Receiver to) {
        double t = Hash.unit(Hash.mix(to.key(), 2));
        double cos = (1 - t * t) / (1 + t * t);
        double sin = 2 * t / (1 + t * t);
        double[] n = {to.nx(), to.ny(), to.nz()};
        int least = Math.abs(n[0]) < Math.abs(n[1]) ? 0 : 1;
        least = Math.abs(n[2]) < Math.abs(n[least]) ? 2 : least;
        double[] u = new double[3];
        u[least] = 1;
        double length = Math.sqrt(1 - n[least] * n[least]);
        for (int a = 0; a < 3; a++) {
            u[a] = (u[a] - n[least] * n[a]) / length;
        }
        double[] axes = new double[9];
        for (int a = 0; a < 3; a++) {
            int b = (a + 1) % 3;
            int c = (a + 2) % 3;
            double v = n[b] * u[c] - n[c] * u[b];
            axes[a] = cos * u[a] + sin * v;
            axes[3 + a] = cos * v - sin * u[a];
            axes[6 + a] = n[a];
        }
        return axes;
    }
}
