package radiosity.world;

import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * Solves H = D + M H for several channels, which are colours in layers, by Gauss-Seidel sweeps (section 2.1 of the paper); M is sparse.
 *
 * <p>In white rooms a sweep leaves an error of the shape of the light itself, which falls by the reflectance only; that
 * one is taken out now and then: as much of a given shape is added as makes the sum of the equations hold.
 */
final class GaussSeidel {

    private static final int MOST_SWEEPS = 2000;
    private static final double ENOUGH = 1e-5;
    private static final int SWEEPS_PER_CORRECTION = 8;

    private final int channels;
    private final int colours;
    private final int[][] column;
    private final float[][] entry;

    /**
     * @param column per row: the unknowns in it
     * @param entry  per row: one per colour for each of them; the same in all layers
     */
    GaussSeidel(int channels, int colours, int[][] column, float[][] entry) {
        this.channels = channels;
        this.colours = colours;
        this.column = column;
        this.entry = entry;
    }

    /**
     * @param direct D, channels per row; not modified
     * @param shape  channels per row, what is added in a correction; null: the solution as it is then
     * @param goOn   asked before every sweep
     * @return H, channels per row; null where it was not to go on
     */
    double[] solve(double[] direct, double[] shape, BooleanSupplier goOn) {
        double[] h = new double[direct.length];
        double[] change = new double[channels];
        double[] size = new double[channels];
        boolean done = false;
        for (int sweep = 1; sweep <= MOST_SWEEPS && !done; sweep++) {
            if (!goOn.getAsBoolean()) {
                return null;
            }
            if (sweep % SWEEPS_PER_CORRECTION == 0) {
                correct(direct, h, shape == null ? h.clone() : shape);
            }
            Arrays.fill(change, 0);
            Arrays.fill(size, 0);
            sweep(direct, h, change, size);
            done = true;
            for (int c = 0; c < channels; c++) {
                done &= change[c] <= ENOUGH * size[c];
            }
        }
        return h;
    }

    private void sweep(double[] direct, double[] h, double[] change, double[] size) {
        double[] sum = new double[channels];
        for (int v = 0; v < column.length; v++) {
            row(v, direct, h, sum);
            for (int c = 0; c < channels; c++) {
                change[c] += Math.abs(sum[c] - h[channels * v + c]);
                size[c] += Math.abs(sum[c]);
                h[channels * v + c] = sum[c];
            }
        }
    }

    /** @param sum modified: D + M H in a row */
    private void row(int v, double[] direct, double[] h, double[] sum) {
        System.arraycopy(direct, channels * v, sum, 0, channels);
        int[] unknown = column[v];
        float[] m = entry[v];
        if (channels == 3 && colours == 3) {
            double r = sum[0];
            double g = sum[1];
            double b = sum[2];
            for (int i = 0; i < unknown.length; i++) {
                int j = 3 * unknown[i];
                r += m[3 * i] * h[j];
                g += m[3 * i + 1] * h[j + 1];
                b += m[3 * i + 2] * h[j + 2];
            }
            sum[0] = r;
            sum[1] = g;
            sum[2] = b;
            return;
        }
        for (int i = 0; i < unknown.length; i++) {
            for (int c = 0; c < channels; c++) {
                sum[c] += m[colours * i + c % colours] * h[channels * unknown[i] + c];
            }
        }
    }

    private void correct(double[] direct, double[] h, double[] shape) {
        double[] none = new double[direct.length];
        double[] missing = new double[channels];
        double[] unit = new double[channels];
        double[] sum = new double[channels];
        for (int v = 0; v < column.length; v++) {
            row(v, direct, h, sum);
            for (int c = 0; c < channels; c++) {
                missing[c] += sum[c] - h[channels * v + c];
            }
            row(v, none, shape, sum);
            for (int c = 0; c < channels; c++) {
                unit[c] += shape[channels * v + c] - sum[c];
            }
        }
        for (int i = 0; i < h.length; i++) {
            int c = i % channels;
            h[i] += unit[c] > 0 ? missing[c] / unit[c] * shape[i] : 0;
        }
    }
}
