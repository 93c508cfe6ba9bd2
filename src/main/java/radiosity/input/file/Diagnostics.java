package radiosity.input.file;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import radiosity.scene.SceneFormatException;

/**
 * Remarks about one file: each kind of remark is reported once, with its first place, the first details and the number
 * of its occurrences.
 *
 * <p>Thus a file with a million bad polygons makes one line. {@link #flush()} reports the remarks.
 */
public final class Diagnostics {

    private static final int LONGEST = 200;
    /** Number of different details that are reported of one kind of remark. */
    private static final int MOST_DETAILS = 5;

    private final String file;
    private final Consumer<String> warnings;
    private final boolean strict;
    private final Map<String, Remark> remarks = new LinkedHashMap<>();

    private static final class Remark {
        final String place;
        final Set<String> details = new LinkedHashSet<>();
        boolean hasMore;
        int count;

        Remark(String place) {
            this.place = place;
        }

        void add(String detail) {
            count++;
            boolean isNew = !detail.isEmpty() && !details.contains(detail);
            int length = details.stream().mapToInt(String::length).sum() + detail.length();
            if (isNew && (details.isEmpty() || details.size() < MOST_DETAILS && length <= LONGEST)) {
                details.add(detail);
            } else {
                hasMore |= isNew;
            }
        }

        @Override
        public String toString() {
            String all = details.isEmpty() ? "" : ": " + String.join(", ", details) + (hasMore ? ", ..." : "");
            return all + (count > 1 ? " (" + count + " times)" : "");
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
     * @param detail content of the file at the place; only the first different details of a kind are reported
     */
    public void note(String place, String remark, String detail) {
        remarks.computeIfAbsent(remark, r -> new Remark(place)).add(shorten(detail));
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
            String place = entry.getValue().place;
            String text = entry.getKey() + entry.getValue();
            if (strict) {
                throw new SceneFormatException(file, place, "no warning (--strict)", text);
            }
            warnings.accept(line(place, text));
        }
        remarks.clear();
    }

    private String line(String place, String text) {
        return SceneFormatException.escape(file + (place.isEmpty() ? "" : ", " + place) + ": " + text);
    }

    static String shorten(String text) {
        return text.length() <= LONGEST ? text : text.substring(0, LONGEST) + "...";
    }
}
