package radiosity.input.file;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;

/** Recognises text in UTF-8. */
public final class Utf8 {

    private static final int PIECE = 8192;

    private Utf8() {
    }

    /** Whether a file begins with the byte order mark of UTF-8. */
    public static boolean hasMark(byte[] file) {
        return file.length >= 3 && file[0] == (byte) 0xEF && file[1] == (byte) 0xBB && file[2] == (byte) 0xBF;
    }

    /** Whether all bytes are valid UTF-8; decodes the file in pieces, so that little memory is needed. */
    public static boolean isValid(byte[] file) {
        CharsetDecoder decoder = StandardCharsets.UTF_8.newDecoder();
        CharBuffer piece = CharBuffer.allocate(PIECE);
        ByteBuffer bytes = ByteBuffer.wrap(file);
        CoderResult result = CoderResult.OVERFLOW;
        while (result.isOverflow()) {
            piece.clear();
            result = decoder.decode(bytes, piece, true);
        }
        return !result.isError();
    }
}
