package radiosity.util;

/**
 * A sum that does not depend on the order of its terms: fixed point, good to 2^-70 of a given scale.
 *
 * <p>Each term is cut into two whole numbers; sums of whole numbers are exact.
 */
public final class ExactSum {

    private static final double LOW = 0x1p35;

    /** 2^-70 of the scale's power of two. */
    private final double unit;
    private long high;
    private long low;

    /** @param scale about as large as the sum can become, by a factor of 2^14 at most; at least 0 */
    public ExactSum(double scale) {
        unit = scale > 0 ? Math.scalb(1.0, Math.max(-1000, Math.getExponent(scale) - 70)) : 1;
    }

    public void add(double term) {
        double q = term / unit;
        double h = Math.floor(q / LOW);
        high += (long) h;
        low += (long) Math.rint(q - h * LOW);
    }

    /** @param other of the same scale */
    public void add(ExactSum other) {
        high += other.high;
        low += other.low;
    }

    public double value() {
        return (high * LOW + low) * unit;
    }

    public long high() {
        return high;
    }

    public long low() {
        return low;
    }

    public ExactSum with(long h, long l) {
        high = h;
        low = l;
        return this;
    }
}
