package radiosity.protocol;

import java.io.IOException;
import java.nio.ByteBuffer;

/** The forms in which the radiosities of a tree are written; the shortest form that loses nothing is chosen. */
enum ShortestNumbers {
    DOUBLES(0, Double.BYTES), FLOATS(1, Float.BYTES),
    /** Whole multiples of the units of a {@link Quantizer}. */
    BYTES(3, Byte.BYTES),
    /** The radiosities are left out. */
    NONE(4, 0);

    /** Number that stands for this form in files; saved calculations may still have 2, which stood for shorts. */
    final int form;
    /** Bytes per number. */
    final int bytes;

    ShortestNumbers(int form, int bytes) {
        this.form = form;
        this.bytes = bytes;
    }

    /** The shortest form that represents the numbers exactly. */
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

    /** @throws IOException where no form has this number */
    static ShortestNumbers of(int form) throws IOException {
        for (ShortestNumbers numbers : values()) {
            if (numbers.form == form) {
                return numbers;
            }
        }
        throw new IOException("shot: expected numbers in a form that this version writes, got form " + form);
    }

    /** @param unit used by {@link #BYTES} only: size of which the number is a multiple; 0 where the number is 0 */
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
