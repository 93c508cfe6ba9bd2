package radiosity.input.file;

import java.nio.charset.StandardCharsets;

/**
 * Reads a window of a file's bytes from its start to its end, big-endian.
 *
 * <p>Never reads outside the window: missing bytes count as zero, and {@link #ranOut()} reports them.
 */
public final class ByteReader {

    private final byte[] file;
    private final int end;
    private int at;
    private boolean ranOut;

    /** @param file not modified */
    public ByteReader(byte[] file) {
        this(file, 0, file.length);
    }

    private ByteReader(byte[] file, int at, int end) {
        this.file = file;
        this.at = at;
        this.end = end;
    }

    /** The next n bytes, or the rest where fewer are left, as a window of their own; this window moves past them. */
    public ByteReader window(long n) {
        ByteReader part = new ByteReader(file, at, at + (int) Math.max(0, Math.min(n, left())));
        at = part.end;
        return part;
    }

    /** A window from the current position to the end of this window. */
    public ByteReader copy() {
        return new ByteReader(file, at, end);
    }

    /** Current position as an offset in the file, bytes. */
    public int offset() {
        return at;
    }

    public int left() {
        return end - at;
    }

    public boolean has(int n) {
        return left() >= n;
    }

    /** Whether a read went beyond the end of the window. */
    public boolean ranOut() {
        return ranOut;
    }

    public void skip(int n) {
        at += Math.min(n, left());
    }

    public int u1() {
        if (at >= end) {
            ranOut = true;
            return 0;
        }
        return file[at++] & 0xFF;
    }

    /** The byte at a distance from the current position, which stays as it is; -1 beyond the end. */
    public int peek(int distance) {
        return has(distance + 1) ? file[at + distance] & 0xFF : -1;
    }

    public int u2() {
        return u1() << 8 | u1();
    }

    public int i2() {
        return (short) u2();
    }

    public long u4() {
        return (long) u2() << 16 | u2();
    }

    public float f4() {
        return Float.intBitsToFloat((int) u4());
    }

    public double f8() {
        return Double.longBitsToDouble(u4() << 32 | u4());
    }

    /** Reads an index of 2 bytes, or of 4 bytes if the first byte is 0xFF. */
    public int vx() {
        return peek(0) == 0xFF ? (int) (u4() & 0x00FFFFFF) : u2();
    }

    /** Whether a complete index follows. */
    public boolean hasVx() {
        return has(peek(0) == 0xFF ? 4 : 2);
    }

    /** Reads four characters. */
    public String id() {
        String id = new String(file, at, Math.min(4, left()), StandardCharsets.ISO_8859_1);
        ranOut |= left() < 4;
        skip(4);
        return id;
    }

    /** Reads text up to a zero byte or the end; text and zero byte are padded to an even length. */
    public String s0() {
        int stop = at;
        while (stop < end && file[stop] != 0) {
            stop++;
        }
        String text = new String(file, at, stop - at, StandardCharsets.ISO_8859_1);
        int length = stop - at + 1;
        skip(length + (length & 1));
        return text;
    }
}
