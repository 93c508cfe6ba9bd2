package radiosity.protocol;

import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import radiosity.mesh.PatchTree;

/**
 * Rounds the radiosities of shots, so that fewer bytes are sent. The remainder is not lost: it is not shot, and so
 * remains unshot.
 *
 * @param exact    whether nothing is rounded: between white surfaces the remainder would become visible
 * @param together whether neighbouring nodes are rounded to multiples of one unit, see {@link Quantizer}; else numbers
 *                 are rounded to a float's digits. False with a layer per lamp: to the digits of a float, the light of
 *                 a lamp is then the same alone and among others
 */
public record Rounding(boolean exact, boolean together) {

    /** Smaller numbers come near those at which a float has fewer digits; above the inverse a float may overflow. */
    private static final double LEAST = 1e-30;
    /** Binary digits that a double has more than a float. */
    private static final int SPARE = 29;
    /** The same limit for doubles that are counted in units. */
    private static final double LEAST_UNITS = 1e-290;

    /** The shot with each radiosity rounded to the nearest number that can be sent. */
    public Shot of(Shot shot) {
        return exact ? shot : together ? rounded(shot, tree -> together(tree, Math::rint)) : finely(shot);
    }

    /** The shot with radiosities rounded up where neighbours share a unit: totals that are 0 or more stay so. */
    public Shot upward(Shot shot) {
        return exact || !together ? shot : rounded(shot, tree -> together(tree, Math::ceil));
    }

    /** The shot with radiosities rounded to a float's digits, for the few large elements of a predicted shot. */
    public Shot finely(Shot shot) {
        return exact ? shot : rounded(shot, tree -> DoubleStream.of(tree.radiosity()).map(Rounding::toFloat).toArray());
    }

    private static Shot rounded(Shot shot, Function<PatchTree, double[]> values) {
        return new Shot(shot.trees().stream().map(tree -> new PatchTree(tree.face(), tree.path(), tree.child(),
                values.apply(tree))).toList(), shot.flux());
    }

    /** Rounds to a float's 24 binary digits, half to even, also outside a float's range: any scale is treated alike. */
    private static double toFloat(double x) {
        if (isNear(Math.abs(x), LEAST)) {
            return (float) x;
        }
        long bits = Double.doubleToRawLongBits(x);
        long even = bits >> SPARE & 1;
        return Double.longBitsToDouble(bits + (1L << SPARE - 1) - 1 + even & -1L << SPARE);
    }

    /** Whether neither {@code size} nor its inverse is below {@code least}. */
    private static boolean isNear(double size, double least) {
        return size >= least && size <= 1 / least;
    }

    /** The tree's radiosities in units; unchanged where the largest of them is too small or too large for units. */
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
