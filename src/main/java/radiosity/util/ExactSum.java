package radiosity.util;

/**
 * A sum that does not depend on the order of its terms: a fixed-point number with a unit of 2^-70 of a given scale.
 *
 * <p>Each term is rounded to the unit and cut into two whole numbers, whose sums are exact. A sum with a term that is
 * NaN or infinite is NaN.
 */
public final class ExactSum {

    private static final double LOW = 0x1p35;
    /** Both whole numbers of a sum that is NaN; the low number of any other sum is at least 0. */
    private static final long NOT_A_NUMBER = Long.MIN_VALUE;

    /** 2^-70 of the power of two at or below the scale. */
    private final double unit;
    private long high;
    private long low;
    private boolean isNumber = true;

    /** @param scale expected size of the sum, at least 0; the sum may become up to 2^14 times as large */
    public ExactSum(double scale) {
        unit = scale > 0 ? Math.scalb(1.0, Math.max(-1000, Math.getExponent(scale) - 70)) : 1;
    }

    public void add(double term) {
        double q = term / unit;
        double h = Math.floor(q / LOW);
        isNumber &= Double.isFinite(term);
        high += (long) h;
        low += (long) Math.rint(q - h * LOW);
    }

    /** @param other a sum with the same scale; not modified */
    public void add(ExactSum other) {
        high += other.high;
        low += other.low;
        isNumber &= other.isNumber;
    }

    public double value() {
        return isNumber ? (high * LOW + low) * unit : Double.NaN;
    }

    public long high() {
        return isNumber ? high : NOT_A_NUMBER;
    }

    public long low() {
        return isNumber ? low : NOT_A_NUMBER;
    }

    /** Sets the two whole numbers of this sum, as {@link #high} and {@link #low} return them. */
    public ExactSum with(long h, long l) {
        high = h;
        low = l;
        isNumber = h != NOT_A_NUMBER || l != NOT_A_NUMBER;
        return this;
    }
}
