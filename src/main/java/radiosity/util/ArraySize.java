package radiosity.util;

import java.util.Locale;

/** Computes lengths of arrays as products of counts, and refuses lengths that no array can have. */
public final class ArraySize {

    /** Largest length of an array that every JVM can make. */
    public static final int MOST = Integer.MAX_VALUE - 8;

    private ArraySize() { }

    /**
     * The length of an array as a product of counts.
     *
     * @param what    content of the array, for the message
     * @param factors at least 0 each
     * @throws TooLargeException where the product is larger than {@link #MOST}
     */
    public static int of(String what, long... factors) {
        double product = 1;
        for (long factor : factors) {
            product *= factor;
        }
        return within(what, MOST, product);
    }

    /**
     * The length of an array with a limit of its own.
     *
     * @param what  content of the array, for the message
     * @param most  largest length
     * @param count whole number of the numbers in the array, at least 0
     * @throws TooLargeException where the count is larger than the limit
     */
    public static int within(String what, int most, double count) {
        if (count > most) {
            throw new TooLargeException(String.format(Locale.ROOT, "%s: expected at most %,d numbers, got %,.0f", what,
                    most, count));
        }
        return (int) count;
    }

    /**
     * Number of items for which a growing array is given room: the wanted number, or as many as an array can hold.
     *
     * @param what   content of the array, for the message
     * @param needed number of items for which there must be room
     * @param wanted number of items for which there should be room
     * @param each   array entries per item, at least 1
     * @throws TooLargeException where an array cannot hold the needed items
     */
    public static int room(String what, long needed, long wanted, int each) {
        of(what, needed, each);
        return (int) Math.max(needed, Math.min(wanted, MOST / each));
    }
}
