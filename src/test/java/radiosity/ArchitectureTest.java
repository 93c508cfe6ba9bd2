package radiosity;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.objectweb.asm.ClassReader;

/**
 * Who may import whom, as {@code docs/ARCHITECTURE.md} says it, held against the classes by the JDK's jdeps; and which
 * methods of the JDK nobody may call, as their results differ between machines.
 */
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

    /** Methods of Math whose results are fixed to the last bit; all others may differ between processors and JDKs. */
    private static final Set<String> EXACT = Set.of("abs", "min", "max", "sqrt", "fma", "floor", "ceil", "rint", "round",
            "signum", "copySign", "scalb", "ulp", "getExponent", "toRadians", "toDegrees", "addExact", "subtractExact",
            "multiplyExact", "multiplyFull", "multiplyHigh", "incrementExact", "decrementExact", "negateExact",
            "absExact", "toIntExact", "floorDiv", "floorMod");

    /** Packages whose numbers are only looked at: what they draw is no result. */
    private static final Set<String> ONLY_SHOWN = Set.of("viewer");

    /**
     * Methods, as owner, name and descriptor, whose answers follow from the machine's locale, encoding, time zone or
     * memory, or from chance. Numbers of sessions (SecureRandom) are to differ.
     */
    private static final Pattern DIFFERENT_ELSEWHERE = Pattern.compile("java/("
            + "lang/String\\.(format\\(Ljava/lang/String;|formatted|to(Low|Upp)erCase\\(\\)|getBytes\\(\\)"
            + "|<init>\\(\\[B(II)?\\))"
            + "|io/Print(Stream|Writer)\\.(printf|format)\\(Ljava/lang/String;"
            + "|io/(InputStreamReader|OutputStreamWriter)\\.<init>\\(Ljava/io/(In|Out)putStream;\\)"
            + "|io/File(Reader|Writer)\\.<init>\\(Ljava/(io/File|lang/String);Z?\\)"
            + "|util/Formatter\\.<init>\\((Ljava/lang/Appendable;)?\\)"
            + "|util/Scanner\\.<init>|util/(Locale|TimeZone)\\.getDefault|time/ZoneId\\.systemDefault"
            + "|nio/charset/Charset\\.defaultCharset|lang/System\\.identityHashCode|lang/Object\\.hashCode"
            + "|util/(Splittable)?Random\\.|util/concurrent/ThreadLocalRandom\\.|util/Collections\\.shuffle).*");

    /** Classes that draw the names of their own files, and pauses between attempts, by chance. */
    private static final Set<String> DRAWING_NAMES = Set.of("radiosity/cli/JournalClaim", "radiosity/output/LockedFile");

    /** Tag of a method in a constant pool (Java Virtual Machine Specification, 4.4). */
    private static final int METHOD_REFERENCE = 10;

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

    @Test
    void methodsOfMath_areThoseWithOneResultOnAllMachines() throws Exception {
        List<String> wrong = new ArrayList<>();
        int calls = 0;
        for (ClassReader reader : classes()) {
            for (String reference : methods(reader)) {
                if (!reference.startsWith("java/lang/Math.")) {
                    continue;
                }
                calls++;
                String method = reference.substring("java/lang/Math.".length(), reference.indexOf('('));
                boolean shown = ONLY_SHOWN.contains(reader.getClassName().split("/")[1]);
                if (!EXACT.contains(method) && !shown) {
                    wrong.add(reader.getClassName() + ": expected StrictMath." + method + ", got Math." + method);
                }
            }
        }
        assertEquals(List.of(), wrong);
        assertTrue(calls > 100, "calls of Math were found: " + calls);
    }

    @Test
    void methodsThatAnswerDifferentlyElsewhere_areNotCalled() throws Exception {
        List<String> wrong = new ArrayList<>();
        for (ClassReader reader : classes()) {
            methods(reader).stream().filter(method -> DIFFERENT_ELSEWHERE.matcher(method).matches())
                    .filter(method -> !method.contains("Random") || !DRAWING_NAMES.contains(reader.getClassName()))
                    .forEach(method -> wrong.add(reader.getClassName() + " calls " + method));
        }
        assertEquals(List.of(), wrong);
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

    /** Methods of classes that a class calls or refers to, as owner, name and descriptor: those in its constant pool. */
    private static List<String> methods(ClassReader reader) {
        List<String> names = new ArrayList<>();
        char[] buffer = new char[reader.getMaxStringLength()];
        for (int item = 1; item < reader.getItemCount(); item++) {
            int at = reader.getItem(item);
            if (at > 0 && reader.readByte(at - 1) == METHOD_REFERENCE) {
                int nameAndType = reader.getItem(reader.readUnsignedShort(at + 2));
                names.add(reader.readClass(at, buffer) + "." + reader.readUTF8(nameAndType, buffer)
                        + reader.readUTF8(nameAndType + 2, buffer));
            }
        }
        return names;
    }

    private static List<ClassReader> classes() throws Exception {
        List<ClassReader> readers = new ArrayList<>();
        try (Stream<Path> files = Files.walk(root())) {
            for (Path file : files.filter(f -> f.toString().endsWith(".class")).sorted().toList()) {
                readers.add(new ClassReader(Files.readAllBytes(file)));
            }
        }
        return readers;
    }

    /** Folder of the compiled classes of the program. */
    private static Path root() throws Exception {
        return Path.of(radiosity.scene.Scene.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    }

    private static String jdeps() throws Exception {
        StringWriter out = new StringWriter();
        ToolProvider.findFirst("jdeps").orElseThrow().run(new PrintWriter(out), new PrintWriter(out),
                "-verbose:package", "-filter:none", "--multi-release", "base", root().toString());
        return out.toString();
    }
}
