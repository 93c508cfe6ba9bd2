package radiosity.input.lightwave.lws;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.Utf8;

/**
 * Iterates over the lines of a scene file, skips empty lines and removes blanks at both ends of a line.
 *
 * <p>Lines end with LF, CR or both. A file of valid UTF-8 is decoded as UTF-8, any other file as Latin-1. Control
 * characters at the ends of lines (Ctrl-Z, zero bytes) count as blanks.
 */
final class SceneLines {

    private static final int LONGEST = 4096;
    private static final int BYTE_ORDER_MARK = 3;

    private final byte[] file;
    private final Charset charset;
    private final Diagnostics notes;
    private int at;
    private int number;
    private int lineStart;
    private int lineNumber;
    private String line = "";

    SceneLines(byte[] file, Diagnostics notes) {
        this.file = file;
        this.notes = notes;
        this.charset = Utf8.isValid(file) ? StandardCharsets.UTF_8 : StandardCharsets.ISO_8859_1;
        this.at = Utf8.hasMark(file) ? BYTE_ORDER_MARK : 0;
    }

    /** Moves to the next line that is not empty; false at the end of the file. */
    boolean next() {
        while (at < file.length) {
            lineStart = at;
            lineNumber = number + 1;
            line = read().trim();
            if (!line.isEmpty()) {
                return true;
            }
        }
        lineStart = at;
        lineNumber = number + 1;
        line = "";
        return false;
    }

    private String read() {
        int end = at;
        while (end < file.length && file[end] != '\n' && file[end] != '\r') {
            end++;
        }
        int length = end - at;
        if (length > LONGEST) {
            notes.note("line " + lineNumber, "lines of more than " + LONGEST + " characters are cut");
        }
        String text = new String(file, at, Math.min(LONGEST, length), charset);
        boolean both = end + 1 < file.length && file[end] == '\r' && file[end + 1] == '\n';
        at = Math.min(file.length, end + (both ? 2 : 1));
        number++;
        return text;
    }

    /** Moves back, so that the current line becomes the next one again. */
    void back() {
        at = lineStart;
        number = lineNumber - 1;
    }

    /** The position before the next line, for {@link #returnTo}. */
    long mark() {
        return (long) number << 32 | at;
    }

    void returnTo(long mark) {
        at = (int) mark;
        number = (int) (mark >>> 32);
    }

    String line() {
        return line;
    }

    /** The first word of the line. */
    String keyword() {
        return firstWord(line);
    }

    /** The line after its first word. */
    String value() {
        return afterWord(line);
    }

    /** The text before its first blank or tab. */
    static String firstWord(String text) {
        int end = 0;
        while (end < text.length() && text.charAt(end) != ' ' && text.charAt(end) != '\t') {
            end++;
        }
        return text.substring(0, end);
    }

    /** The text after its first blank or tab, without blanks at both ends; empty if it has neither. */
    static String afterWord(String text) {
        return text.substring(firstWord(text).length()).trim();
    }

    /** Number of the line in the file, from 1. */
    int number() {
        return lineNumber;
    }

    String place() {
        return "line " + lineNumber;
    }
}
