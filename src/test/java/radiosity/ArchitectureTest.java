package radiosity;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import org.junit.jupiter.api.Test;

/** Who may import whom, as {@code docs/ARCHITECTURE.md} says it, held against the classes by the JDK's jdeps. */
class ArchitectureTest {

    private static final Set<String> ALL = Set.of("scene", "lightwave", "patch", "visibility", "formfactor", "world",
            "output", "viewer");

    /** The packages of the program that each may import. */
    private static final Map<String, Set<String>> MAY = Map.of(
            "scene", Set.of(),
            "lightwave", Set.of("scene"),
            "patch", Set.of("scene"),
            "visibility", Set.of("scene"),
            "formfactor", Set.of("scene", "patch", "visibility"),
            "world", Set.of("scene", "patch", "visibility", "formfactor"),
            "output", Set.of("scene", "patch", "visibility", "world"),
            "viewer", Set.of("scene", "patch", "visibility", "output", "lightwave"),
            "cli", ALL);

    /** Packages of the JDK and of libraries, and which of ours may import them. */
    private static final Map<String, Set<String>> ONLY = Map.of(
            "java\\.rmi.*|sun\\.rmi.*", Set.of("world", "cli"),
            "org\\.jogamp.*|com\\.jogamp.*|javax\\.vecmath.*", Set.of("viewer"),
            "java\\.awt.*|javax\\.(imageio|swing).*", Set.of("output", "viewer"),
            "picocli.*|org\\.jline.*|me\\.tongfei.*", Set.of("cli"),
            "de\\.javagl.*", Set.of("output", "viewer"));

    private static final Pattern ARROW = Pattern.compile(" +radiosity\\.(\\w+) +-> (\\S+) .*");

    @Test
    void packages_importOnlyWhatTheTableAllows() throws Exception {
        List<String> wrong = new ArrayList<>();
        Map<String, Set<String>> imports = imports();
        imports.forEach((ours, theirs) -> theirs.stream().filter(p -> !allowed(ours, p))
                .forEach(p -> wrong.add(ours + " imports " + p)));
        assertEquals(List.of(), wrong);
    }

    @Test
    void everyPackage_standsInTheTable() throws Exception {
        assertTrue(MAY.keySet().containsAll(imports().keySet()), imports().keySet().toString());
        assertTrue(imports().containsKey("cli"), "jdeps found the classes");
    }

    private static boolean allowed(String ours, String theirs) {
        if (theirs.startsWith("radiosity.")) {
            String name = theirs.substring("radiosity.".length());
            return name.equals(ours) || MAY.get(ours).contains(name);
        }
        return ONLY.entrySet().stream().noneMatch(e -> theirs.matches(e.getKey()) && !e.getValue().contains(ours));
    }

    /** Imported packages by package of the program, without its prefix. */
    private static Map<String, Set<String>> imports() throws Exception {
        Map<String, Set<String>> imports = new TreeMap<>();
        for (String line : jdeps().split("\\R")) {
            Matcher arrow = ARROW.matcher(line);
            if (arrow.matches()) {
                imports.computeIfAbsent(arrow.group(1), p -> new TreeSet<>()).add(arrow.group(2));
            }
        }
        return imports;
    }

    private static String jdeps() throws Exception {
        String classes = java.nio.file.Path.of(radiosity.scene.Scene.class.getProtectionDomain().getCodeSource()
                .getLocation().toURI()).toString();
        StringWriter out = new StringWriter();
        ToolProvider.findFirst("jdeps").orElseThrow().run(new PrintWriter(out), new PrintWriter(out),
                "-verbose:package", "-filter:none", "--multi-release", "base", classes);
        return out.toString();
    }
}
