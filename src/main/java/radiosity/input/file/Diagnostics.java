package radiosity.input.file;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;
import radiosity.scene.SceneFormatException;

/**
 * Remarks about one file: each kind of remark is reported once, with its first place and the number of its occurrences.
 *
 * <p>Thus a file with a million bad polygons makes one line. {@link #flush()} reports the remarks.
 */
public final class Diagnostics {

    private static final int LONGEST = 200;

    private final String file;
    private final Consumer<String> warnings;
    private final boolean strict;
    private final Map<String, Remark> remarks = new LinkedHashMap<>();

    private static final class Remark {
        final String place;
        final String detail;
        int count;

        Remark(String place, String detail) {
            this.place = place;
            this.detail = detail;
        }
    }

    /**
     * @param file     name of the file as the user knows it
     * @param warnings receives a line per kind of remark
     * @param strict   whether the first remark is thrown as an exception instead
     */
    public Diagnostics(String file, Consumer<String> warnings, boolean strict) {
        this.file = file;
        this.warnings = warnings;
        this.strict = strict;
    }

    /** Diagnostics of another file, which are reported in the same way. */
    public Diagnostics about(String otherFile) {
        return new Diagnostics(otherFile, warnings, strict);
    }

    public void note(String place, String remark) {
        note(place, remark, "");
    }

    /**
     * @param place  place in the file; empty for the whole file
     * @param remark kind of the remark, a fixed text of this program
     * @param detail content of the file at the place; only the first detail of a kind is reported
     */
    public void note(String place, String remark, String detail) {
        remarks.computeIfAbsent(remark, r -> new Remark(place, shorten(detail))).count++;
    }

    /** Reports, at once, something that is no fault of the file and so no error under --strict either. */
    public void remark(String remark) {
        warnings.accept(line("", remark));
    }

    public SceneFormatException error(String place, String expected, String got) {
        return new SceneFormatException(file, place, expected, shorten(got));
    }

    /**
     * Reports the remarks noted since the last call.
     *
     * @throws SceneFormatException with the first remark, under --strict
     */
    public void flush() throws SceneFormatException {
        for (Map.Entry<String, Remark> entry : remarks.entrySet()) {
            Remark remark = entry.getValue();
            String text = text(entry.getKey(), remark);
            if (strict) {
                throw new SceneFormatException(file, remark.place, "no warning (--strict)", text);
            }
            warnings.accept(line(remark.place, text));
        }
        remarks.clear();
    }

    private String line(String place, String text) {
        return SceneFormatException.escape(file + (place.isEmpty() ? "" : ", " + place) + ": " + text);
    }

    private static String text(String kind, Remark remark) {
        String detail = remark.detail.isEmpty() ? "" : ": " + remark.detail;
        return kind + detail + (remark.count > 1 ? " (" + remark.count + " times)" : "");
    }

    static String shorten(String text) {
        return text.length() <= LONGEST ? text : text.substring(0, LONGEST) + "...";
    }
}
