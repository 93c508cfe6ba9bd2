package radiosity.input.obj;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import radiosity.input.file.Utf8;
import radiosity.util.Decimal;

/**
 * The lines of an OBJ or MTL file, each a keyword and words. A line that ends in a backslash continues in the next one;
 * empty lines and comments are skipped, also comments behind words, but not behind names, which may hold a #. Each byte
 * is read a bounded number of times, whatever the file holds.
 */
final class TextLines {

    private final byte[] file;
    private final Charset charset;
    private int at;
    private int number;
    private int first;
    private String line = "";
    private int word;

    /** @param file not modified */
    TextLines(byte[] file) {
        this.file = file;
        charset = Utf8.isValid(file) ? StandardCharsets.UTF_8 : StandardCharsets.ISO_8859_1;
        at = Utf8.hasMark(file) ? 3 : 0;
    }

    /** Moves to the next line that is neither empty nor a comment; false at the end. */
    boolean next() {
        while (at < file.length) {
            first = number + 1;
            line = whole().strip();
            word = 0;
            if (!line.isEmpty() && line.charAt(0) != '#') {
                return true;
            }
        }
        return false;
    }

    /** A line joined with its continuation lines; a comment has none, as it may be a path that ends in a backslash. */
    private String whole() {
        String piece = piece();
        if (!piece.endsWith("\\") || piece.stripLeading().startsWith("#")) {
            return piece;
        }
        StringBuilder pieces = new StringBuilder();
        while (piece.endsWith("\\") && at < file.length) {
            pieces.append(piece, 0, piece.length() - 1).append(' ');
            piece = piece();
        }
        return pieces.append(piece).toString();
    }

    private String piece() {
        int start = at;
        while (at < file.length && file[at] != '\n' && file[at] != '\r') {
            at++;
        }
        String piece = new String(file, start, at - start, charset);
        at += at + 1 < file.length && file[at] == '\r' && file[at + 1] == '\n' ? 2 : 1;
        number++;
        return piece;
    }

    /** Number of the line, for messages. */
    String place() {
        return "line " + first;
    }

    int number() {
        return first;
    }

    /** The next word of the line, the keyword first; empty at the end of the line, or where a comment begins. */
    String word() {
        int start = skipBlanks();
        if (start < line.length() && line.charAt(start) == '#') {
            word = line.length();
            return "";
        }
        while (word < line.length() && !isBlank(line.charAt(word))) {
            word++;
        }
        return line.substring(start, word);
    }

    /** A path without the quotes that some programs write around paths with blanks. */
    static String unquoted(String path) {
        boolean isQuoted = path.length() > 1 && path.startsWith("\"") && path.endsWith("\"");
        return isQuoted ? path.substring(1, path.length() - 1) : path;
    }

    /** The rest of the line after the words that were read. */
    String rest() {
        return line.substring(skipBlanks());
    }

    /** The next word, or {@code otherwise} at the end of the line, as a number; NaN where it is not a number. */
    double number(String otherwise) {
        String text = word();
        return number(text.isEmpty() ? otherwise : text, Double.NaN);
    }

    /** A word as a number; {@code otherwise} where it is not a number. */
    static double number(String text, double otherwise) {
        double number = Decimal.parse(text);
        return Double.isNaN(number) ? otherwise : number;
    }

    private int skipBlanks() {
        while (word < line.length() && isBlank(line.charAt(word))) {
            word++;
        }
        return word;
    }

    private static boolean isBlank(char c) {
        return c == ' ' || c == '\t' || c == '\f' || c == 0x0B;
    }
}
