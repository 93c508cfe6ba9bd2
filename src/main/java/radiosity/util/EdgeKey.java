package radiosity.util;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.IntPredicate;

/** Keys of edges in either direction: the lower number of an end in the upper 32 bits, the higher in the lower ones. */
public final class EdgeKey {

    private EdgeKey() { }

    /** @param p number of one end, at least 0; {@code q} is that of the other */
    public static long of(int p, int q) {
        return (long) Math.min(p, q) << 32 | Math.max(p, q);
    }

    /**
     * Returns the keys that occur a wanted number of times, each once and ascending.
     *
     * @param sorted keys, ascending; modified: overwritten
     */
    public static long[] occurring(long[] sorted, IntPredicate wanted) {
        int count = 0;
        for (int i = 0, next; i < sorted.length; i = next) {
            next = i + 1;
            while (next < sorted.length && sorted[next] == sorted[i]) {
                next++;
            }
            if (wanted.test(next - i)) {
                sorted[count++] = sorted[i];
            }
        }
        return Arrays.copyOf(sorted, count);
    }

    /** Returns the numbers of all ends of some edges, each once and ascending; the keys are not modified. */
    public static int[] ends(long[] keys) {
        BitSet ends = new BitSet();
        for (long key : keys) {
            ends.set((int) (key >> 32));
            ends.set((int) key);
        }
        return ends.stream().toArray();
    }
}
