package radiosity.input.file;

import java.util.Arrays;

/** A growing array of whole numbers. */
public final class IntList {

    private static final int[] NONE = {};

    private int[] values = NONE;
    private int size;

    public void add(int value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, size + (size >> 1) + 16);
        }
        values[size++] = value;
    }

    public int get(int i) {
        return values[i];
    }

    public void set(int i, int value) {
        values[i] = value;
    }

    public int size() {
        return size;
    }

    /** Keeps only the first n numbers. */
    public void cut(int n) {
        size = Math.min(size, n);
    }

    public int[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
