package radiosity.input.lightwave.lws;

import java.util.HashMap;
import java.util.Map;

/** An object, null object, light or camera of a scene as its file describes it. */
public final class SceneItem {

    /** What an item is; the number is the first digit of its identity in LWSC 3 and later. */
    public enum Kind {
        OBJECT(1), LIGHT(2), CAMERA(3), BONE(4);

        final int digit;

        Kind(int digit) {
            this.digit = digit;
        }
    }

    /** The layer of an object whose whole file is taken. */
    public static final int WHOLE_FILE = -1;

    final Kind kind;
    private final int line;
    /** As written in LWSC 4 and later; -1 where there is none. */
    final long id;
    /** Path of an object as written; null for a null object and all others. */
    public String file;
    /** Name of a null object as written; null for all others. */
    String nullName;
    /** Number of the layer in its file. */
    public int layer = WHOLE_FILE;
    Motion motion = Motion.NONE;
    private Map<String, String> values = Map.of();
    private Map<String, Motion> envelopes = Map.of();

    SceneItem(Kind kind, long id, int line) {
        this.kind = kind;
        this.id = id;
        this.line = line;
    }

    /** Number of the line where its description begins, from 1. */
    public int line() {
        return line;
    }

    /** Where it is described, for messages. */
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

    public boolean has(String keyword) {
        return values.containsKey(keyword) || envelopes.containsKey(keyword);
    }

    /** What stands after a keyword; empty if the keyword is not there. */
    String text(String keyword) {
        return values.getOrDefault(keyword, "");
    }

    /**
     * The numbers after a keyword, or of its envelopes at a time.
     *
     * @param otherwise what holds where the file gives no number; its length is how many are wanted; not modified
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
     * What the user calls an object: a null object by its name, others by their file's without path and ending, with
     * the number of the layer where it is not the first.
     */
    public String name() {
        if (!isLoaded()) {
            return nullName == null ? "" : nullName;
        }
        String plain = file.substring(1 + Math.max(file.lastIndexOf('/'), Math.max(file.lastIndexOf('\\'),
                file.lastIndexOf(':')))).replaceFirst("(?i)\\.lwo$", "");
        return layer > 0 ? plain + ":" + (layer + 1) : plain;
    }

    /** Whether it is an object with a file, and no null object. */
    public boolean isLoaded() {
        return file != null;
    }
}
