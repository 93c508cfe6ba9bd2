package radiosity.input.lightwave.lws;

import java.util.Arrays;

/**
 * A value that changes in time: keys and the curves between them.
 *
 * <p>The kind of curve between two keys is that of the second key. The behaviour before the first and after the last
 * key is a number: 0 zero, 1 constant, 2 repeat, 3 oscillate, 4 repeat with offset, 5 linear.
 */
public final class Envelope {

    static final int TCB = 0;
    static final int HERMITE = 1;
    static final int OLD_BEZIER = 2;
    static final int LINEAR = 3;
    static final int STEPPED = 4;
    static final int BEZIER = 5;

    /** Numbers of a key: value, time, kind of curve, and five parameters of the curve. */
    static final int PER_KEY = 8;

    private double[] keys = new double[PER_KEY];
    private int size;
    private int before = 1;
    private int after = 1;

    /** Adds a key of up to PER_KEY numbers; missing numbers are zero. Callers check that value and time are finite. */
    public void add(double[] key) {
        if (keys.length == PER_KEY * size) {
            keys = Arrays.copyOf(keys, 2 * keys.length);
        }
        System.arraycopy(key, 0, keys, PER_KEY * size, Math.min(PER_KEY, key.length));
        size++;
    }

    public void behaviours(int beforeFirst, int afterLast) {
        before = beforeFirst;
        after = afterLast;
    }

    int size() {
        return size;
    }

    double value(int key) {
        return keys[PER_KEY * key];
    }

    double time(int key) {
        return keys[PER_KEY * key + 1];
    }

    int span(int key) {
        return (int) keys[PER_KEY * key + 2];
    }

    /** Parameter n (0 to 4) of the curve at a key. */
    double parameter(int key, int n) {
        return keys[PER_KEY * key + 3 + n];
    }

    int before() {
        return before;
    }

    int after() {
        return after;
    }
}
