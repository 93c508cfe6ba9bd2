package radiosity.scene;

import java.io.IOException;
import java.util.Locale;

/** A file that cannot be read in the expected format; the message says <i>where: expected X, got Y</i>. */
public final class SceneFormatException extends IOException {

    /**
     * @param file     name of the file as the user knows it
     * @param place    place in the file: "line 12" or "byte 1040, chunk SURF"; empty for the whole file
     * @param expected what should stand there
     * @param got      what stands there; control characters in all four texts are escaped
     */
    public SceneFormatException(String file, String place, String expected, String got) {
        super(escape(file) + (place.isEmpty() ? "" : ", " + escape(place)) + ": expected " + escape(expected)
                + ", got " + escape(got));
    }

    /** A text made safe for a terminal: control and format characters become \\u and four hexadecimal digits. */
    public static String escape(String text) {
        StringBuilder safe = new StringBuilder(text.length());
        text.codePoints().forEach(c -> {
            if (Character.isISOControl(c) || Character.getType(c) == Character.FORMAT) {
                safe.append(String.format(Locale.ROOT, "\\u%04x", c));
            } else {
                safe.appendCodePoint(c);
            }
        });
        return safe.toString();
    }
}
