package radiosity.util;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/** A byte sequence that may be longer than an array, as a list of arrays. */
public final class Pieces {

    private Pieces() { }

    /** Number of bytes of all pieces. */
    public static long length(List<byte[]> pieces) {
        return pieces.stream().mapToLong(piece -> piece.length).sum();
    }

    /** Cuts an array into pieces of at most {@code most} bytes; an array that is no longer is its own only piece. */
    public static byte[][] cut(byte[] bytes, int most) {
        byte[][] pieces = new byte[Math.max(1, (int) ((bytes.length + most - 1L) / most))][];
        for (int i = 0; i < pieces.length; i++) {
            pieces[i] = pieces.length == 1 ? bytes
                    : Arrays.copyOfRange(bytes, i * most, (int) Math.min(bytes.length, (i + 1L) * most));
        }
        return pieces;
    }

    /**
     * A stream over all bytes; {@code available} returns the number of bytes left, at most {@link Integer#MAX_VALUE}.
     *
     * @param pieces not copied; must not be modified while the stream is in use
     */
    public static InputStream open(List<byte[]> pieces) {
        if (pieces.size() == 1) {
            return new ByteArrayInputStream(pieces.get(0));
        }
        return new SequenceInputStream(Collections.enumeration(
                pieces.stream().<InputStream>map(ByteArrayInputStream::new).toList())) {

            private long left = length(pieces);

            @Override
            public int read() throws IOException {
                int value = super.read();
                left -= value < 0 ? 0 : 1;
                return value;
            }

            @Override
            public int read(byte[] to, int at, int most) throws IOException {
                int count = super.read(to, at, most);
                left -= Math.max(0, count);
                return count;
            }

            @Override
            public int available() {
                return (int) Math.min(Integer.MAX_VALUE, left);
            }
        };
    }
}
