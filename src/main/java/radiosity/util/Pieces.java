package radiosity.util;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.util.Collections;
import java.util.List;

/** More bytes than one array may hold, in several arrays. */
public final class Pieces {

    private Pieces() { }

    /** Number of bytes of all pieces. */
    public static long length(List<byte[]> pieces) {
        return pieces.stream().mapToLong(piece -> piece.length).sum();
    }

    /**
     * All bytes from the first on; {@code available} says how many are left, or {@link Integer#MAX_VALUE}.
     *
     * @param pieces not copied, not to be modified while they are read
     */
    public static InputStream open(List<byte[]> pieces) {
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
