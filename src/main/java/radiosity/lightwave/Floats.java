package radiosity.lightwave;

import java.util.Arrays;

/** A growing array of single-precision numbers. */
final class Floats {

    private static final float[] NONE = {};

    private float[] values = NONE;
    private int size;

    void add(float value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, size + (size >> 1) + 16);
        }
        values[size++] = value;
    }

    float get(int i) {
        return values[i];
    }

    int size() {
        return size;
    }

    float[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
