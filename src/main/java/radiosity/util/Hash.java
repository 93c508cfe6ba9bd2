package radiosity.util;

/** Hash keys that depend on the content of an object alone, never on its owner or on the time at which it was made. */
public final class Hash {

    private Hash() { }

    /** Mixes a value into a key. Source: G. Steele, D. Lea, C. Flood, Fast splittable pseudorandom generators, 2014. */
    public static long mix(long key, long value) {
        long z = key * 0x9E3779B97F4A7C15L + value;
        z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }

    /** The number in [0, 1) that the upper 53 bits of a hash are. */
    public static double unit(long hash) {
        return (hash >>> 11) * 0x1p-53;
    }
}
