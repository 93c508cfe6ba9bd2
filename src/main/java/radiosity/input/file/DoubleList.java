package radiosity.input.file;

import java.util.Arrays;

/** A growing array of double-precision numbers. */
public final class DoubleList {

    private static final double[] NONE = {};

    private double[] values = NONE;
    private int size;

    public void add(double value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, size + (size >> 1) + 16);
        }
        values[size++] = value;
    }

    public double get(int i) {
        return values[i];
    }

    public int size() {
        return size;
    }
}
