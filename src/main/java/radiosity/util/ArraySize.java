package radiosity.util;

import java.util.Locale;

/** Lengths of arrays as products of counts, checked where the counts are known. */
public final class ArraySize {

    /** Largest length of an array that every JVM can make. */
    public static final int MOST = Integer.MAX_VALUE - 8;

    private ArraySize() { }

    /**
     * A product of counts as the length of an array.
     *
     * @param what    the array's content, for the message
     * @param factors at least 0 each
     * @throws TooLargeException where the product is larger than an array can be
     */
    public static int of(String what, long... factors) {
        double product = 1;
        for (long factor : factors) {
            product *= factor;
        }
        if (product > MOST) {
            throw new TooLargeException(String.format(Locale.ROOT, "%s: expected at most %,d numbers, got %,.0f", what,
                    MOST, product));
        }
        return (int) product;
    }

    /**
     * How many items an array is given room for when it grows: as many as wanted, or all that an array can hold.
     *
     * @param what   the array's content, for the message
     * @param needed number of items that there must be room for
     * @param wanted number of items that there is better room for
     * @param each   numbers per item, at least 1
     * @throws TooLargeException where an array cannot hold the items that are needed
     */
    public static int room(String what, long needed, long wanted, int each) {
        of(what, needed, each);
        return (int) Math.max(needed, Math.min(wanted, MOST / each));
    }
}
