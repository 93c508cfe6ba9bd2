package radiosity.input.file;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;
import radiosity.scene.SceneFormatException;

/**
 * What there is to say about one file: each kind of remark once, with the first place it holds for and how often.
 *
 * <p>So a file with a million bad polygons makes one line. Remarks come out at {@link #flush()}.
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
     * @param file     its name as the user knows it
     * @param warnings gets one line per remark
     * @param strict   the first remark is thrown as an exception instead
     */
    public Diagnostics(String file, Consumer<String> warnings, boolean strict) {
        this.file = file;
        this.warnings = warnings;
        this.strict = strict;
    }

    /** The same way of telling, about another file. */
    public Diagnostics about(String otherFile) {
        return new Diagnostics(otherFile, warnings, strict);
    }

    public void note(String place, String remark) {
        note(place, remark, "");
    }

    /**
     * @param place  where in the file; empty for the whole of it
     * @param remark the kind: a fixed text of this program
     * @param detail what the file says there; only the first one of a kind is reported
     */
    public void note(String place, String remark, String detail) {
        remarks.computeIfAbsent(remark, r -> new Remark(place, shorten(detail))).count++;
    }

    /** Reports something that is no fault of the file, so no error under --strict either. */
    public void remark(String remark) {
        warnings.accept(line("", remark));
    }

    public SceneFormatException error(String place, String expected, String got) {
        return new SceneFormatException(file, place, expected, shorten(got));
    }

    /** Reports what was noted since the last call. */
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
