package radiosity.util;

/**
 * A sum that does not depend on the order of its terms: a fixed-point number with a unit of 2^-70 of a given scale.
 *
 * <p>Each term is rounded to the unit and cut into two whole numbers, whose sums are exact.
 */
public final class ExactSum {

    private static final double LOW = 0x1p35;

    /** 2^-70 of the power of two at or below the scale. */
    private final double unit;
    private long high;
    private long low;

    /** @param scale expected size of the sum, at least 0; the sum may become up to 2^14 times as large */
    public ExactSum(double scale) {
        unit = scale > 0 ? Math.scalb(1.0, Math.max(-1000, Math.getExponent(scale) - 70)) : 1;
    }

    public void add(double term) {
        double q = term / unit;
        double h = Math.floor(q / LOW);
        high += (long) h;
        low += (long) Math.rint(q - h * LOW);
    }

    /** @param other a sum with the same scale; not modified */
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

    /** Sets the two whole numbers of this sum, as {@link #high} and {@link #low} return them. */
    public ExactSum with(long h, long l) {
        high = h;
        low = l;
        return this;
    }
}
