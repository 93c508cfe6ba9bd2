package radiosity.input.file;

import java.util.Arrays;

/** A growing array of single-precision numbers. */
public final class FloatList {

    private static final float[] NONE = {};

    private float[] values = NONE;
    private int size;

    public void add(float value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, size + (size >> 1) + 16);
        }
        values[size++] = value;
    }

    public float get(int i) {
        return values[i];
    }

    public int size() {
        return size;
    }

    public float[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
