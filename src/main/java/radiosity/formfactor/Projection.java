package radiosity.formfactor;

import radiosity.util.Hash;
import radiosity.visibility.RadiosityBounds;

/**
 * A calculator that divides what a receiving point sees into cells once and for all; a patch's form factor is the sum
 * of those in which it is seen.
 *
 * <p>What is seen in a cell is what a ray through its middle meets: what an item buffer would hold there, found for the
 * cells only that the patch covers.
 */
abstract class Projection extends PatchByPatch {

    Projection(RadiosityBounds bounds) {
        super(bounds);
    }

    /** A patch as the receiver sees it: x and y along the horizon, turned by the receiver's key, z up. */
    final class View {

        private final Receiver to;
        private final int node;
        /** 9: corners. */
        final double[] corner = new double[9];
        /** 9: towards the inside of the edge opposite each corner, in planes through the eye. */
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

        /** If the patch is seen in this direction, the cell around it counts so much. */
        void cell(double x, double y, double z, double weight) {
            double a = x * inside[0] + y * inside[1] + z * inside[2];
            double b = x * inside[3] + y * inside[4] + z * inside[5];
            double c = x * inside[6] + y * inside[7] + z * inside[8];
            double sum = a + b + c;
            if (a >= 0 && b >= 0 && c >= 0 && sum > 0) {
                float fb = (float) (b / sum);
                float fc = (float) (c / sum);
                look(to, node, Math.max(0, 1 - fb - fc), fb, fc, weight);
            }
        }
    }

    @Override
    final double patch(Receiver to, int node) {
        cover(new View(to, node));
        return 1;
    }

    /** Offers the view every cell that the patch may cover. */
    abstract void cover(View view);

    /**
     * Two axes along the horizon and the normal, 3 each. The first is turned by an angle that follows from the key, or
     * neighbours' cells would err alike; points of a circle without sine: t = tan of half the angle.
     */
    private static double[] axes(Receiver to) {
        double t = (Hash.mix(to.key(), 2) >>> 11) * 0x1p-53;
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
