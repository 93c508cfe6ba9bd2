package radiosity.gltf;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;

/**
 * A value in a glTF file's JSON. Messages about a missing or wrong value have the path to the value.
 *
 * @param file the file's name
 * @param path from the root to the value
 * @param node the value
 */
public record JsonCursor(String file, String path, JsonNode node) {

    public JsonCursor(String file, JsonNode root) {
        this(file, "", root);
    }

    /** Why a text is no JSON, in a parser's words without those about the parser's own settings. */
    public static String reason(JsonProcessingException e) {
        return e.getOriginalMessage().replaceAll("\\[Source: REDACTED \\(.*?\\); (line: \\d+, column: \\d+)\\]", "$1");
    }

    public JsonCursor at(String key) throws SceneFormatException {
        return below("/" + key, node.get(key));
    }

    public JsonCursor at(int index) throws SceneFormatException {
        return below("/" + index, node.get(index));
    }

    private JsonCursor below(String step, JsonNode child) throws SceneFormatException {
        if (child == null || child.isNull()) {
            throw new SceneFormatException(file, "JSON " + path + step, "a value", "none");
        }
        return new JsonCursor(file, path + step, child);
    }

    /** The value under a key; empty if there is none, or null. */
    public Optional<JsonCursor> optional(String key) {
        return Optional.ofNullable(node.get(key)).filter(child -> !child.isNull())
                .map(child -> new JsonCursor(file, path + "/" + key, child));
    }

    /** An extension of the value; empty if there is none. */
    public Optional<JsonCursor> extension(String name) {
        return optional("extensions").flatMap(extensions -> extensions.optional(name));
    }

    /** The number under a key, or another if there is none. */
    public double number(String key, double otherwise) throws SceneFormatException {
        Optional<JsonCursor> there = optional(key);
        return there.isPresent() ? there.get().number() : otherwise;
    }

    /** The numbers under a key, or others if there are none; their number must be equal. */
    public double[] numbers(String key, double... otherwise) throws SceneFormatException {
        Optional<JsonCursor> there = optional(key);
        return there.isPresent() ? there.get().numbers(otherwise.length) : otherwise;
    }

    /** The index under a key, or -1 if there is none. */
    public int index(String key) throws SceneFormatException {
        Optional<JsonCursor> there = optional(key);
        return there.isPresent() ? there.get().integer() : -1;
    }

    /** The text under a key, or another if there is none. */
    public String text(String key, String otherwise) throws SceneFormatException {
        Optional<JsonCursor> there = optional(key);
        return there.isPresent() ? there.get().text() : otherwise;
    }

    /** Whether a switch under a key is on; a missing switch is off. */
    public boolean isOn(String key) {
        return node.path(key).booleanValue();
    }

    /** The members of the list under a key; empty if there is no list. */
    public List<JsonCursor> list(String key) throws SceneFormatException {
        Optional<JsonCursor> list = optional(key);
        List<JsonCursor> members = new ArrayList<>();
        for (int i = 0; list.isPresent() && i < list.get().size(); i++) {
            members.add(list.get().at(i));
        }
        return members;
    }

    public int size() {
        return node.size();
    }

    /** The value as a whole number from 0 to 2³¹ - 1. */
    public int integer() throws SceneFormatException {
        require(node.isIntegralNumber() && node.canConvertToInt() && node.intValue() >= 0, "a whole number");
        return node.intValue();
    }

    /** The value as a whole number of any size, or -1 if it is something else. */
    public long unchecked() {
        return node.isIntegralNumber() && node.canConvertToLong() ? node.longValue() : -1;
    }

    /** The whole number of any size under a key: 0 if there is no value, -1 if the value is something else. */
    public long unchecked(String key) {
        return optional(key).map(JsonCursor::unchecked).orElse(0L);
    }

    public double number() throws SceneFormatException {
        require(node.isNumber() && Double.isFinite(node.doubleValue()), "a number");
        return node.doubleValue();
    }

    public String text() throws SceneFormatException {
        require(node.isTextual(), "text");
        return node.textValue();
    }

    /** @param count expected number of numbers */
    public double[] numbers(int count) throws SceneFormatException {
        require(node.isArray() && node.size() == count, count + " numbers");
        double[] numbers = new double[count];
        for (int i = 0; i < count; i++) {
            numbers[i] = at(i).number();
        }
        return numbers;
    }

    public Rgb rgb() throws SceneFormatException {
        double[] rgb = numbers(3);
        return new Rgb(rgb[0], rgb[1], rgb[2]);
    }

    public SceneFormatException wrong(String expected) {
        String got = node.toString();
        return new SceneFormatException(file, "JSON " + path, expected,
                got.length() > 60 ? got.substring(0, 60) + "…" : got);
    }

    private void require(boolean holds, String expected) throws SceneFormatException {
        if (!holds) {
            throw wrong(expected);
        }
    }
}
