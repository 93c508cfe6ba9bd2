package radiosity.lightwave;

import java.util.Arrays;

/** A growing array of whole numbers. */
final class Ints {

    private static final int[] NONE = {};

    private int[] values = NONE;
    private int size;

    void add(int value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, size + (size >> 1) + 16);
        }
        values[size++] = value;
    }

    int get(int i) {
        return values[i];
    }

    void set(int i, int value) {
        values[i] = value;
    }

    int size() {
        return size;
    }

    /** Keeps the first n only. */
    void cut(int n) {
        size = Math.min(size, n);
    }

    int[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
