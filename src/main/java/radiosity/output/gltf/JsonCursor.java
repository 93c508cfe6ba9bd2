package radiosity.output.gltf;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;

/**
 * A place in a scene file's JSON: what is not there, or not as it should be, is said with its path.
 *
 * @param file the file's name
 * @param path from the root to here
 * @param node what stands here
 */
record JsonCursor(String file, String path, JsonNode node) {

    JsonCursor(String file, JsonNode root) {
        this(file, "", root);
    }

    JsonCursor at(String key) throws SceneFormatException {
        return below("/" + key, node.get(key));
    }

    JsonCursor at(int index) throws SceneFormatException {
        return below("/" + index, node.get(index));
    }

    private JsonCursor below(String step, JsonNode child) throws SceneFormatException {
        if (child == null || child.isNull()) {
            throw new SceneFormatException(file, "JSON " + path + step, "a value", "none");
        }
        return new JsonCursor(file, path + step, child);
    }

    Optional<JsonCursor> optional(String key) {
        return Optional.ofNullable(node.get(key)).map(child -> new JsonCursor(file, path + "/" + key, child));
    }

    int size() {
        return node.size();
    }

    int integer() throws SceneFormatException {
        require(node.isIntegralNumber() && node.canConvertToInt() && node.intValue() >= 0, "a whole number");
        return node.intValue();
    }

    /** A whole number of any size, -1 where it is none. */
    long unchecked() {
        return node.isIntegralNumber() && node.canConvertToLong() ? node.longValue() : -1;
    }

    double number() throws SceneFormatException {
        require(node.isNumber() && Double.isFinite(node.doubleValue()), "a number");
        return node.doubleValue();
    }

    String text() throws SceneFormatException {
        require(node.isTextual(), "text");
        return node.textValue();
    }

    /** @param count how many numbers there must be */
    double[] numbers(int count) throws SceneFormatException {
        require(node.isArray() && node.size() == count, count + " numbers");
        double[] numbers = new double[count];
        for (int i = 0; i < count; i++) {
            numbers[i] = at(i).number();
        }
        return numbers;
    }

    Rgb rgb() throws SceneFormatException {
        double[] rgb = numbers(3);
        return new Rgb(rgb[0], rgb[1], rgb[2]);
    }

    SceneFormatException wrong(String expected) {
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
