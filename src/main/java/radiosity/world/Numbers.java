package radiosity.world;

import java.io.IOException;
import java.nio.ByteBuffer;

/** How some numbers are written: in the shortest form that loses nothing. */
enum Numbers {
    DOUBLES(Double.BYTES), FLOATS(Float.BYTES),
    /** Multiples of {@link Units}. */
    BYTES(Byte.BYTES),
    /** That are left out. */
    NONE(0);

    /** Of each. */
    final int bytes;

    Numbers(int bytes) {
        this.bytes = bytes;
    }

    /** For those. */
    static Numbers of(double[] numbers, Units units) {
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
    static Numbers of(int form) throws IOException {
        if (form < 0 || form >= NONE.ordinal()) {
            throw new IOException("shot: expected a form below " + NONE.ordinal() + ", got " + form);
        }
        return values()[form];
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
