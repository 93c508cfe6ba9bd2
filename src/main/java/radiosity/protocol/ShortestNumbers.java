package radiosity.protocol;

import java.io.IOException;
import java.nio.ByteBuffer;

/** How some numbers are written: in the shortest form that loses nothing. */
enum ShortestNumbers {
    DOUBLES(0, Double.BYTES), FLOATS(1, Float.BYTES),
    /** Multiples of {@link Quantizer}. */
    BYTES(3, Byte.BYTES),
    /** That are left out. */
    NONE(4, 0);

    /** As it is written; 2 stood for shorts, which saved calculations may still have. */
    final int form;
    /** Of each. */
    final int bytes;

    ShortestNumbers(int form, int bytes) {
        this.form = form;
        this.bytes = bytes;
    }

    /** For those. */
    static ShortestNumbers of(double[] numbers, Quantizer units) {
        if (units.fit(numbers)) {
            return BYTES;
        }
        for (double x : numbers) {
            if ((float) x != x) {
                return DOUBLES;
            }
        }
        return FLOATS;
    }

    /** As they were written. */
    static ShortestNumbers of(int form) throws IOException {
        for (ShortestNumbers numbers : values()) {
            if (numbers.form == form) {
                return numbers;
            }
        }
        throw new IOException("shot: expected numbers in a form that this version writes, got form " + form);
    }

    void put(double x, double unit, ByteBuffer bytes) {
        switch (this) {
            case DOUBLES -> bytes.putDouble(x);
            case FLOATS -> bytes.putFloat((float) x);
            case BYTES -> bytes.put((byte) (unit == 0 ? 0 : x / unit));
            case NONE -> { }
        }
    }

    double get(double unit, ByteBuffer bytes) {
        return switch (this) {
            case DOUBLES -> bytes.getDouble();
            case FLOATS -> bytes.getFloat();
            case BYTES -> bytes.get() * unit;
            case NONE -> 0;
        };
    }
}
