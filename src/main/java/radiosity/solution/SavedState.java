package radiosity.solution;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import radiosity.util.Pieces;

/**
 * The state of a calculation from which {@code ProgressiveRadiosity.resume} goes on, as opaque bytes; immutable.
 *
 * <p>The bytes are held in pieces of any lengths, because the state of more than about 15 million elements does not fit
 * into one array. Two states are equal if their bytes are equal, however the bytes are cut into pieces.
 */
public final class SavedState {

    /** No bytes: a solution that cannot be continued. */
    public static final SavedState NONE = new SavedState(List.of());

    /** Bytes per piece of a state that is read from a file. */
    private static final int PIECE = 1 << 24;
    /** Bytes written at a time: a file channel copies the bytes of each call to memory outside of the heap. */
    private static final int WRITTEN_AT_ONCE = 1 << 20;

    /** The bytes in order; not modified. */
    private final List<byte[]> pieces;
    private final long length;
    /** Null until first needed. */
    private String sha256;

    private SavedState(List<byte[]> pieces) {
        this.pieces = pieces;
        length = Pieces.length(pieces);
    }

    /**
     * A state of the bytes of several arrays, one after the other.
     *
     * @param pieces the arrays; not copied, so the caller must not modify them
     */
    public static SavedState of(List<byte[]> pieces) {
        return new SavedState(List.copyOf(pieces));
    }

    /**
     * Reads a state and computes its SHA-256 on the way.
     *
     * @param length length of the state in bytes, at least 0
     * @throws EOFException where the input has fewer bytes
     */
    public static SavedState read(InputStream in, long length) throws IOException {
        return read(in, length, PIECE);
    }

    /** @param most largest number of bytes per piece, at least 1 */
    static SavedState read(InputStream in, long length, int most) throws IOException {
        MessageDigest digest = digest();
        List<byte[]> pieces = new ArrayList<>();
        for (long read = 0; read < length;) {
            byte[] piece = new byte[(int) Math.min(most, length - read)];
            int count = in.readNBytes(piece, 0, piece.length);
            read += count;
            if (count < piece.length) {
                throw new EOFException("state: expected " + length + " bytes, got " + read);
            }
            digest.update(piece);
            pieces.add(piece);
        }
        SavedState state = new SavedState(pieces);
        state.sha256 = HexFormat.of().formatHex(digest.digest());
        return state;
    }

    private static MessageDigest digest() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
    }

    /** Number of bytes. */
    public long length() {
        return length;
    }

    public boolean isEmpty() {
        return length == 0;
    }

    /** A stream of all bytes; its {@code available} is the number of bytes left, at most {@link Integer#MAX_VALUE}. */
    public InputStream open() {
        return Pieces.open(pieces);
    }

    /** Writes all bytes; does not close the stream. */
    public void writeTo(OutputStream out) throws IOException {
        for (byte[] piece : pieces) {
            for (int at = 0; at < piece.length; at += WRITTEN_AT_ONCE) {
                out.write(piece, at, Math.min(WRITTEN_AT_ONCE, piece.length - at));
            }
        }
    }

    /** SHA-256 of all bytes, in hexadecimal digits; computed once. */
    public synchronized String sha256() {
        if (sha256 == null) {
            MessageDigest digest = digest();
            pieces.forEach(digest::update);
            sha256 = HexFormat.of().formatHex(digest.digest());
        }
        return sha256;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof SavedState state && length == state.length && sha256().equals(state.sha256());
    }

    @Override
    public int hashCode() {
        return sha256().hashCode();
    }

    @Override
    public String toString() {
        return "state of " + length + " bytes in " + pieces.size() + " pieces";
    }
}
