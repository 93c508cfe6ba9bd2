package radiosity.prediction;

import java.util.function.BooleanSupplier;
import radiosity.util.NoNumberException;

/**
 * Solves H = D + K rho H for the irradiances H at vertices, for several channels (colours of each layer), by
 * Gauss-Seidel sweeps (section 2.1 of the paper). A row of K has the form factors from a vertex to the three corners of
 * each patch.
 *
 * <p>In white rooms and in long rooms, sweeps alone would need thousands of turns. So the results of the last sweeps
 * are combined with the coefficients that leave the smallest change (D. Anderson, Iterative procedures for nonlinear
 * integral equations, 1965).
 */
public final class GaussSeidel {

    private static final int MOST_SWEEPS = 500;
    /** Number of earlier sweeps that are combined. */
    private static final int MEMORY = 6;
    /** Pivot, relative to its diagonal element, up to which a change counts as linearly dependent on earlier ones. */
    private static final double NOTHING_NEW = 1e-13;

    private final int channels;
    private final CoarseRows rows;
    private final double[] reflectance;
    private final double enough;
    /** 3 x channels per node of the coarse mesh, used for patches: radiosity reflected at the corners of the patch. */
    private final double[] reflected;

    /**
     * @param reflectance colours per node of the coarse mesh, used for patches, alike in all layers; not modified
     * @param enough      sum of changes, relative to the sum of absolute values in a channel, that ends the sweeps
     */
    GaussSeidel(CoarseRows rows, int channels, double[] reflectance, double enough) {
        this.rows = rows;
        this.channels = channels;
        this.reflectance = reflectance;
        this.enough = enough;
        reflected = new double[3 * channels * rows.nodes()];
    }

    /**
     * Solves the system. Where {@link #MOST_SWEEPS} do not suffice, what is expected after the last is returned.
     *
     * @param direct D, channels per row; not modified
     * @param goOn   whether to go on; asked before every sweep
     * @return H, channels per row; null where {@code goOn} was false
     * @throws NoNumberException where H is not finite
     */
    double[] solve(double[] direct, BooleanSupplier goOn) {
        double largest = 0;
        for (double d : direct) {
            largest = Math.max(largest, Math.abs(d));
        }
        if (largest == 0 || !Double.isFinite(largest)) {
            return ofUnit(direct, goOn);
        }
        // the squares of very small numbers would underflow; scaling by a power of two changes no digit
        int up = -Math.getExponent(largest);
        double[] h = ofUnit(scaled(direct, up), goOn);
        return h == null ? null : scaled(h, -up);
    }

    private static double[] scaled(double[] values, int up) {
        double[] scaled = new double[values.length];
        for (int i = 0; i < scaled.length; i++) {
            scaled[i] = Math.scalb(values[i], up);
        }
        return scaled;
    }

    /** @param direct D, at most about 1 in absolute value; not modified */
    private double[] ofUnit(double[] direct, BooleanSupplier goOn) {
        double[] h = new double[direct.length];
        double[][] steps = new double[MEMORY][];
        double[][] changes = new double[MEMORY][];
        double[] before = null;
        double[] changedBefore = null;
        for (int sweep = 0; sweep < MOST_SWEEPS; sweep++) {
            if (!goOn.getAsBoolean()) {
                return null;
            }
            double[] next = h.clone();
            if (sweep(direct, next)) {
                return next;
            }
            double[] changed = difference(next, h);
            if (before != null) {
                steps[sweep % MEMORY] = difference(h, before);
                changes[sweep % MEMORY] = difference(changed, changedBefore);
            }
            before = h;
            changedBefore = changed;
            h = next;
            for (int c = 0; c < channels && sweep > 0; c++) {
                combine(c, h, changed, steps, changes);
            }
        }
        return h;
    }

    private static double[] difference(double[] a, double[] b) {
        double[] d = new double[a.length];
        for (int i = 0; i < d.length; i++) {
            d[i] = a[i] - b[i];
        }
        return d;
    }

    /**
     * Combines the result h of a sweep, which is modified, with earlier ones in channel c: fits the last change by
     * differences of earlier changes (least squares, by elimination), and subtracts the corresponding steps.
     */
    private void combine(int c, double[] h, double[] changed, double[][] steps, double[][] changes) {
        double[][] a = new double[MEMORY][MEMORY + 1];
        for (int i = 0; i < MEMORY; i++) {
            for (int j = 0; j < MEMORY && changes[i] != null; j++) {
                a[i][j] = changes[j] == null ? 0 : dot(changes[i], changes[j], c);
            }
            a[i][MEMORY] = changes[i] == null ? 0 : dot(changes[i], changed, c);
        }
        double[] share = eliminate(a);
        for (int i = 0; i < MEMORY; i++) {
            for (int k = c; k < h.length && share[i] != 0; k += channels) {
                h[k] -= share[i] * (steps[i][k] + changes[i][k]);
            }
        }
    }

    private double dot(double[] x, double[] y, int c) {
        double sum = 0;
        for (int k = c; k < x.length; k += channels) {
            sum += x[k] * y[k];
        }
        return sum;
    }

    /** Solves a system a, symmetric matrix and right side, which is modified; gives 0 where a pivot is too small. */
    private static double[] eliminate(double[][] a) {
        int n = a.length;
        double[] x = new double[n];
        double[] size = new double[n];
        for (int i = 0; i < n; i++) {
            size[i] = a[i][i];
        }
        for (int i = 0; i < n; i++) {
            if (a[i][i] <= NOTHING_NEW * size[i]) {
                a[i][i] = 0;
                continue;
            }
            for (int r = i + 1; r < n; r++) {
                double times = a[r][i] / a[i][i];
                for (int k = i; k <= n; k++) {
                    a[r][k] -= times * a[i][k];
                }
            }
        }
        for (int i = n - 1; i >= 0; i--) {
            double sum = a[i][n];
            for (int k = i + 1; k < n; k++) {
                sum -= a[i][k] * x[k];
            }
            x[i] = a[i][i] == 0 ? 0 : sum / a[i][i];
        }
        return x;
    }

    /** Makes one sweep over all rows of h, which is modified; returns whether the change is small enough to end. */
    private boolean sweep(double[] direct, double[] h) {
        double[] sum = new double[channels];
        double[] change = new double[channels];
        double[] size = new double[channels];
        for (int v = 0; v < rows.count(); v++) {
            reflect(v, h);
        }
        for (int v = 0; v < rows.count(); v++) {
            System.arraycopy(direct, channels * v, sum, 0, channels);
            add(rows.patches(v), rows.factors(v), sum);
            for (int c = 0; c < channels; c++) {
                change[c] += Math.abs(sum[c] - h[channels * v + c]);
                size[c] += Math.abs(sum[c]);
                h[channels * v + c] = sum[c];
            }
            reflect(v, h);
        }
        boolean done = true;
        for (int c = 0; c < channels; c++) {
            if (!Double.isFinite(size[c])) {
                throw new NoNumberException("predicted light: expected numbers, got " + size[c]
                        + "; surfaces may emit too much");
            }
            done &= change[c] <= enough * size[c];
        }
        return done;
    }

    /** Sets what is reflected at the corners of patches whose irradiance is that of an unknown. */
    private void reflect(int v, double[] h) {
        int colours = reflectance.length / rows.nodes();
        for (int corner : rows.corners(v)) {
            for (int c = 0; c < channels; c++) {
                reflected[channels * corner + c] = reflectance[colours * (corner / 3) + c % colours]
                        * h[channels * v + c];
            }
        }
    }

    /** @param sum modified: the light of a row's patches is added, one per channel */
    private void add(int[] patch, float[] factor, double[] sum) {
        if (channels == 3) {
            double r = sum[0];
            double g = sum[1];
            double b = sum[2];
            for (int i = 0; i < patch.length; i++) {
                int j = 9 * patch[i];
                float p = factor[3 * i];
                float q = factor[3 * i + 1];
                float s = factor[3 * i + 2];
                r += p * reflected[j] + q * reflected[j + 3] + s * reflected[j + 6];
                g += p * reflected[j + 1] + q * reflected[j + 4] + s * reflected[j + 7];
                b += p * reflected[j + 2] + q * reflected[j + 5] + s * reflected[j + 8];
            }
            sum[0] = r;
            sum[1] = g;
            sum[2] = b;
            return;
        }
        for (int i = 0; i < patch.length; i++) {
            for (int k = 0; k < 3; k++) {
                float part = factor[3 * i + k];
                int at = channels * (3 * patch[i] + k);
                for (int c = 0; c < channels; c++) {
                    sum[c] += part * reflected[at + c];
                }
            }
        }
    }
}
