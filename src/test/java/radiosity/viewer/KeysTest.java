package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import radiosity.viewer.web.WebPage;

/** The lists of keys of window, page and document say the same. */
class KeysTest {

    /** Keys that do what a page cannot, or that a browser keeps for itself. */
    private static final Set<String> WINDOW_ONLY = Set.of("M", "Ctrl+Z, Ctrl+S", "F", "F11", "Esc");
    /** A key of the table: one character, or a name. */
    private static final Pattern KEY = Pattern.compile("[A-Z0-9+\\-\\[\\]]|F11|Home|Shift|Space|Esc|Ctrl\\+[ZS]");

    /** What each key does, in the order of the help. */
    private static Map<String, String> window() {
        Map<String, String> keys = new LinkedHashMap<>();
        Arrays.stream(Keys.HELP).forEach(line -> keys.put(line[0], line[1]));
        return keys;
    }

    private static List<String> page() throws IOException {
        try (InputStream in = WebPage.class.getResourceAsStream("keys.js")) {
            String script = new String(in.readAllBytes(), StandardCharsets.UTF_8);
            int begin = script.indexOf("HELP = `") + "HELP = `".length();
            return script.substring(begin, script.indexOf('`', begin)).lines().toList();
        }
    }

    @Test
    void page_hasTheWindowsKeysInTheSameWords() throws IOException {
        List<String> expected = window().entrySet().stream().filter(key -> !WINDOW_ONLY.contains(key.getKey()))
                .map(key -> String.format("%-20s%s", key.getKey(), key.getValue())).toList();
        assertEquals(expected, page());
    }

    private static Set<String> single(Stream<String> labels) {
        Set<String> keys = new TreeSet<>();
        labels.flatMap(label -> Arrays.stream(label.split(", ?"))).filter(KEY.asMatchPredicate()).forEach(keys::add);
        return keys;
    }

    private static List<String[]> table() throws IOException {
        return Files.readAllLines(Path.of("docs/VIEWER.md")).stream().dropWhile(line -> !line.startsWith("| | window"))
                .skip(2).takeWhile(line -> line.startsWith("|")).map(line -> line.split(" *\\| *")).toList();
    }

    @Test
    void document_namesEveryKeyAndWhereItWorks() throws IOException {
        Set<String> all = single(window().keySet().stream());
        assertTrue(all.containsAll(Set.of("[", "]", "+", "-", "0", "Home", "Ctrl+Z")), all.toString());
        Set<String> onPage = single(window().keySet().stream().filter(label -> !WINDOW_ONLY.contains(label)));
        Set<String> named = new TreeSet<>();
        for (String[] row : table()) {
            assertEquals(4, row.length, String.join("|", row));
            Set<String> inRow = new TreeSet<>();
            Pattern.compile("`([^`]+)`").matcher(row[1] + row[2]).results().map(found -> found.group(1))
                    .filter(KEY.asMatchPredicate()).forEach(inRow::add);
            named.addAll(inRow);
            for (String key : inRow) {
                if (onPage.contains(key)) {
                    assertNotEquals("no", row[3], key);
                } else {
                    assertNotEquals("yes", row[3], key);
                }
            }
        }
        assertEquals(all, named);
    }
}
