package radiosity.world;

import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * How some numbers are written: in the shortest form that loses nothing.
 *
 * @param exponent of shorts, which have it in common: they count units of two to it
 */
record Numbers(Form form, int exponent, double unit) {

    /** Beyond it a unit is no normal number, or its inverse is not. */
    private static final int MOST_EXPONENT = 1000;

    /** In what; NONE stands for numbers that are left out. */
    enum Form { DOUBLES, FLOATS, SHORTS, NONE }

    /** For those. */
    static Numbers of(double[] numbers) {
        int exponent = Math.getExponent(Rounding.largest(numbers)) - Short.SIZE + 2;
        exponent = Math.max(-MOST_EXPONENT, exponent);
        double unit = Math.scalb(1.0, exponent);
        boolean isFloat = true;
        boolean isShort = true;
        for (double x : numbers) {
            isFloat &= (float) x == x;
            isShort &= (short) (x / unit) * unit == x;
        }
        return new Numbers(isShort ? Form.SHORTS : isFloat ? Form.FLOATS : Form.DOUBLES, exponent, unit);
    }

    /** As they were written. */
    static Numbers of(int form, int exponent) throws IOException {
        if (form < 0 || form >= Form.NONE.ordinal()) {
            throw new IOException("shot: expected a form below " + Form.NONE.ordinal() + ", got " + form);
        }
        return new Numbers(Form.values()[form], exponent, Math.scalb(1.0, exponent));
    }

    /** Of each. */
    int bytes() {
        return switch (form) {
            case DOUBLES -> Double.BYTES;
            case FLOATS -> Float.BYTES;
            case SHORTS -> Short.BYTES;
            case NONE -> 0;
        };
    }

    void put(double x, ByteBuffer bytes) {
        switch (form) {
            case DOUBLES -> bytes.putDouble(x);
            case FLOATS -> bytes.putFloat((float) x);
            case SHORTS -> bytes.putShort((short) (x / unit));
            case NONE -> { }
        }
    }

    double get(ByteBuffer bytes) {
        return switch (form) {
            case DOUBLES -> bytes.getDouble();
            case FLOATS -> bytes.getFloat();
            case SHORTS -> bytes.getShort() * unit;
            case NONE -> 0;
        };
    }
}
