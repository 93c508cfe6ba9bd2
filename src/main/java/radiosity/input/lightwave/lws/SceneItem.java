package radiosity.input.lightwave.lws;

import java.util.HashMap;
import java.util.Map;

/** An object, null object, light, camera or bone of a scene as its file describes it. */
public final class SceneItem {

    /** Kinds of items, with their digit: the first digit of references to items in LWSC 3 and later. */
    public enum Kind {
        OBJECT(1), LIGHT(2), CAMERA(3), BONE(4);

        final int digit;

        Kind(int digit) {
            this.digit = digit;
        }
    }

    /** Value of {@link #layer} for an object whose whole file is loaded. */
    public static final int WHOLE_FILE = -1;

    final Kind kind;
    private final int line;
    /** Identity as written in LWSC 4 and later; -1 where there is none. */
    final long id;
    /** Path of an object's file as written; null for null objects, lights, cameras and bones. */
    public String file;
    /** Name of a null object as written; null for other items. */
    String nullName;
    /** Number of the layer in the object's file, from 0, or {@link #WHOLE_FILE}. */
    public int layer = WHOLE_FILE;
    Motion motion = Motion.NONE;
    private Map<String, String> values = Map.of();
    private Map<String, Motion> envelopes = Map.of();

    SceneItem(Kind kind, long id, int line) {
        this.kind = kind;
        this.id = id;
        this.line = line;
    }

    /** Number of the line where the item's description begins, from 1. */
    public int line() {
        return line;
    }

    /** The line of the item's description, for messages. */
    public String place() {
        return "line " + line;
    }

    void put(String keyword, String value) {
        values = values.isEmpty() ? new HashMap<>(4) : values;
        values.put(keyword, value);
    }

    void put(String keyword, Motion envelope) {
        envelopes = envelopes.isEmpty() ? new HashMap<>(2) : envelopes;
        envelopes.put(keyword, envelope);
    }

    boolean has(String keyword) {
        return values.containsKey(keyword) || envelopes.containsKey(keyword);
    }

    /** The first keyword if the item has it, else the second. */
    public String either(String first, String second) {
        return has(first) ? first : second;
    }

    /** The text after a keyword; empty if the item does not have the keyword. */
    String text(String keyword) {
        return values.getOrDefault(keyword, "");
    }

    /**
     * The numbers after a keyword, or the values of its envelopes at a time.
     *
     * @param otherwise values where the file gives no number; its length is the number of values returned; not modified
     */
    double[] numbers(String keyword, Motion.Instant instant, double... otherwise) {
        double[] numbers = otherwise.clone();
        Motion envelope = envelopes.get(keyword);
        double[] written = SceneNumbers.all(text(keyword), numbers.length);
        for (int i = 0; i < numbers.length; i++) {
            if (envelope != null) {
                numbers[i] = EnvelopeCurve.at(envelope.channels()[i], instant.time(envelope.inFrames()), numbers[i]);
            } else if (i < written.length && !Double.isNaN(written[i])) {
                numbers[i] = written[i];
            }
        }
        return numbers;
    }

    public double number(String keyword, Motion.Instant instant, double otherwise) {
        return numbers(keyword, instant, otherwise)[0];
    }

    /**
     * Name shown to the user: a null object's own name, or the object's file name without directory and extension,
     * followed by the layer's number where the layer is not the first.
     */
    public String name() {
        if (!isLoaded()) {
            return nullName == null ? "" : nullName;
        }
        String plain = file.substring(1 + Math.max(file.lastIndexOf('/'), Math.max(file.lastIndexOf('\\'),
                file.lastIndexOf(':')))).replaceFirst("(?i)\\.lwo$", "");
        return layer > 0 ? plain + ":" + (layer + 1) : plain;
    }

    /** Whether the item is an object with a file, and not a null object. */
    public boolean isLoaded() {
        return file != null;
    }
}
