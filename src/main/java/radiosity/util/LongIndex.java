package radiosity.util;

import java.util.Arrays;

/** A map from long keys to numbers of at least 0 that the caller chooses: open addressing, no boxing. */
public final class LongIndex {

    private long[] keys;
    private int[] numbers;
    private int size;

    /**
     * @param expected number of keys for which there is room without growing
     * @throws TooLargeException where an array cannot have that much room
     */
    public LongIndex(long expected) {
        long power = Long.highestOneBit(Math.max(8, expected));
        keys = new long[ArraySize.of("an index of " + expected + " keys", power, 4)];
        numbers = new int[keys.length];
        Arrays.fill(numbers, -1);
    }

    public int size() {
        return size;
    }

    /** The key's number, or -1. */
    public int find(long key) {
        return numbers[slot(key)];
    }

    /** The key's number; a new key gets {@code next}. */
    public int findOrAdd(long key, int next) {
        int slot = slot(key);
        if (numbers[slot] < 0) {
            keys[slot] = key;
            numbers[slot] = next;
            if (++size > keys.length / 2) {
                grow();
            }
            return next;
        }
        return numbers[slot];
    }

    /** Sets the number of a key, which may be new. */
    public void put(long key, int number) {
        if (findOrAdd(key, number) != number) {
            numbers[slot(key)] = number;
        }
    }

    private int slot(long key) {
        int mask = keys.length - 1;
        int slot = (int) Hash.mix(0, key) & mask;
        while (numbers[slot] >= 0 && keys[slot] != key) {
            slot = (slot + 1) & mask;
        }
        return slot;
    }

    private void grow() {
        long[] oldKeys = keys;
        int[] oldNumbers = numbers;
        keys = new long[ArraySize.of("an index of " + size + " keys", 2, oldKeys.length)];
        numbers = new int[keys.length];
        Arrays.fill(numbers, -1);
        for (int i = 0; i < oldKeys.length; i++) {
            if (oldNumbers[i] >= 0) {
                int slot = slot(oldKeys[i]);
                keys[slot] = oldKeys[i];
                numbers[slot] = oldNumbers[i];
            }
        }
    }
}
