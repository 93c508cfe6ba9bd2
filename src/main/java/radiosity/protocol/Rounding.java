package radiosity.protocol;

import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import radiosity.mesh.PatchTree;

/**
 * Radiosities to be shot, as they are sent: with fewer digits they take less room, and what rounding leaves over is not
 * shot and so not lost.
 *
 * @param exact    whether what is left over would show: among white surfaces it would be a part of what is emitted
 * @param together whether neighbours are counted in one unit: many of them, which are shot again if need be.
 *                 Not where lamps are to be mixed: each alone is then as it is among others to the digits of a float
 */
public record Rounding(boolean exact, boolean together) {

    /** Below this a float has fewer digits, or is about to; above its inverse it is about to overflow. */
    private static final double LEAST = 1e-30;
    /** Digits that a double has more than a float. */
    private static final int SPARE = 29;
    /** Below this a double that is counted in units has fewer digits; above its inverse it is about to overflow. */
    private static final double LEAST_UNITS = 1e-290;

    public Shot of(Shot shot) {
        return exact ? shot : together ? rounded(shot, tree -> together(tree, Math::rint)) : finely(shot);
    }

    /** No element shoots less than is given, nor takes back more: what is not negative in the end stays so. */
    public Shot upward(Shot shot) {
        return exact || !together ? shot : rounded(shot, tree -> together(tree, Math::ceil));
    }

    /** Of what is nearly all that will ever be shot, and is said of few elements. */
    public Shot finely(Shot shot) {
        return exact ? shot : rounded(shot, tree -> DoubleStream.of(tree.radiosity()).map(Rounding::toFloat).toArray());
    }

    private static Shot rounded(Shot shot, Function<PatchTree, double[]> values) {
        return new Shot(shot.trees().stream().map(tree -> new PatchTree(tree.face(), tree.path(), tree.child(),
                values.apply(tree))).toList(), shot.flux());
    }

    /** To the 24 digits of a float, half to even, also where a float has not the range: all scales are alike. */
    private static double toFloat(double x) {
        if (isNear(Math.abs(x), LEAST)) {
            return (float) x;
        }
        long bits = Double.doubleToRawLongBits(x);
        long even = bits >> SPARE & 1;
        return Double.longBitsToDouble(bits + (1L << SPARE - 1) - 1 + even & -1L << SPARE);
    }

    /** Whether neither a size nor its inverse is below the least. */
    private static boolean isNear(double size, double least) {
        return size >= least && size <= 1 / least;
    }

    private static double[] together(PatchTree tree, DoubleUnaryOperator rounding) {
        double[] values = tree.radiosity();
        double largest = 0;
        for (double x : values) {
            largest = Math.max(largest, Math.abs(x));
        }
        return isNear(largest, LEAST_UNITS) ? Quantizer.of(values, tree.channels()).rounded(values, rounding)
                : values;
    }
}
