package radiosity;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.objectweb.asm.ClassReader;

/**
 * Who may import whom, as {@code docs/ARCHITECTURE.md} says it, held against the classes by the JDK's jdeps; and which
 * methods of the JDK nobody may call, as their results differ between machines.
 */
class ArchitectureTest {

    private static final Path DOCUMENT = Path.of("docs/ARCHITECTURE.md");
    private static final Pattern ROW = Pattern.compile("(?m)^\\| `([a-z.()]+)` \\| .* \\| ([a-z., ()-]+) \\|$");
    private static final String FRONT = "(front)";

    private static final int MOST_TYPES = 25;
    private static final int LARGEST_KNOT = 6;
    private static final int MOST_LINES_OF_A_FILE = 600;
    private static final double LARGEST_SHARE = 0.12;
    private static final int COLUMNS = 120;
    private static final Path SOURCES = Path.of("src/main/java");

    /** Packages of the JDK and of libraries, and which of ours may import them. */
    private static final Map<String, Set<String>> ONLY = Map.of(
            "java\\.rmi.*|sun\\.rmi.*", Set.of("rmi", "worker", "master", "partition", "cli"),
            "org\\.jogamp.*|com\\.jogamp.*|javax\\.vecmath.*", Set.of("viewer"),
            "java\\.awt.*|javax\\.(imageio|swing).*", Set.of("output.image", "output.lightmap", "viewer"),
            "picocli.*|org\\.jline.*", Set.of("cli"),
            "de\\.javagl.*", Set.of("output.gltf", "viewer"));

    /** Methods of Math whose results are fixed to the last bit; all others may differ between processors and JDKs. */
    private static final Set<String> EXACT = Set.of("abs", "min", "max", "sqrt", "fma", "floor", "ceil", "rint",
            "round",
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
    private static final Set<String> DING_NAMES = Set.of("radiosity/cli/render/JournalClaim",
            "radiosity/output/file/LockedFile");

    /** Tag of a method in a constant pool (Java Virtual Machine Specification, 4.4). */
    private static final int METHOD_REFERENCE = 10;

    private static final Pattern ARROW = Pattern.compile(" +(radiosity[\\w.$]*) +-> (\\S+) .*");

    @Test
    void packages_importOnlyWhatTheTableAllows() throws Exception {
        Map<String, Set<String>> table = table();
        List<String> wrong = new ArrayList<>();
        importsOfPackages().forEach((ours, theirs) -> theirs.stream().filter(p -> !allowed(ours, p, table))
                .forEach(p -> wrong.add(ours + " imports " + p)));
        assertEquals(List.of(), wrong);
    }

    @Test
    void table_namesThePackagesAndNoImportThatIsNotThere() throws Exception {
        Map<String, Set<String>> real = new TreeMap<>();
        importsOfPackages().forEach((ours, theirs) -> real.put(ours, theirs.stream().filter(p -> isOurs(p))
                .map(ArchitectureTest::shortName).filter(p -> !p.equals(ours))
                        .collect(Collectors.toCollection(TreeSet::new))));
        assertEquals(real, table());
    }

    @Test
    void noTwoPackages_importEachOther() throws Exception {
        Map<String, Set<String>> packages = new TreeMap<>();
        importsOfPackages().forEach((ours, theirs) -> packages.put(ours, theirs.stream()
                .filter(ArchitectureTest::isOurs)
                .map(ArchitectureTest::shortName).collect(Collectors.toSet())));
        assertEquals(List.of(), knots(packages, 1));
    }

    @Test
    void typesThatImportEachOther_areFew() throws Exception {
        assertEquals(List.of(), knots(importsOfTypes(), LARGEST_KNOT));
    }

    @Test
    void packages_areSmall() throws Exception {
        Map<String, Long> types = sources().stream().filter(file -> !file.endsWith("package-info.java"))
                .collect(Collectors.groupingBy(file -> SOURCES.relativize(file.getParent()).toString(),
                        Collectors.counting()));
        Map<String, Long> lines = sources().stream()
                .collect(Collectors.groupingBy(file -> file.getParent().toString(),
                        Collectors.summingLong(ArchitectureTest::lines)));
        long all = lines.values().stream().mapToLong(Long::longValue).sum();
        assertEquals(List.of(), types.entrySet().stream().filter(p -> p.getValue() > MOST_TYPES).toList());
        assertEquals(List.of(), lines.entrySet().stream().filter(p -> p.getValue() > LARGEST_SHARE * all).toList());
    }

    @Test
    void files_areShortAndNarrow() {
        assertEquals(List.of(), sources().stream().filter(file -> lines(file) > MOST_LINES_OF_A_FILE).toList());
        List<String> wide = new ArrayList<>();
        for (Path file : sources()) {
            read(file).lines().filter(line -> line.length() > COLUMNS && !line.startsWith("import "))
                    .forEach(line -> wide.add(file + ": " + line));
        }
        assertEquals(List.of(), wide);
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
                    .filter(method -> !method.contains("Random") || !DING_NAMES.contains(reader.getClassName()))
                    .forEach(method -> wrong.add(reader.getClassName() + " calls " + method));
        }
        assertEquals(List.of(), wrong);
    }

    /** Such a stream has a temporary file that is to be deleted at the end: it cannot be opened while that comes. */
    @Test
    void pictures_areWrittenWhileTheProgramEnds() throws Exception {
        List<String> wrong = new ArrayList<>();
        for (ClassReader reader : classes()) {
            methods(reader).stream().filter(m -> m.matches("javax/imageio/ImageIO.write\\(.*java/io/OutputStream;\\).*"))
                    .forEach(method -> wrong.add(reader.getClassName() + " calls " + method));
        }
        assertEquals(List.of(), wrong);
    }

    /** So the light of a scene with mirrors and glass, and the time it takes, are those of the scene without them. */
    @Test
    void whatShines_isUnknownToTheCalculation() throws Exception {
        Set<String> users = importsOfTypes().entrySet().stream()
                .filter(type -> type.getValue().contains("radiosity.scene.Specular"))
                .map(type -> type.getKey().substring(0, type.getKey().lastIndexOf('.')))
                .filter(p -> !p.equals("radiosity.scene") && !p.startsWith("radiosity.input."))
                .collect(Collectors.toCollection(TreeSet::new));
        assertEquals(Set.of("radiosity.output.gltf", "radiosity.output.raytrace"), users);
    }

    private static boolean allowed(String ours, String theirs, Map<String, Set<String>> table) {
        if (isOurs(theirs)) {
            return shortName(theirs).equals(ours) || table.getOrDefault(ours, Set.of()).contains(shortName(theirs));
        }
        return ONLY.entrySet().stream().noneMatch(e -> theirs.matches(e.getKey())
                && e.getValue().stream().noneMatch(p -> ours.equals(p) || ours.startsWith(p + ".")));
    }

    /** The packages that each package may import, as the document says. */
    private static Map<String, Set<String>> table() {
        Map<String, Set<String>> table = new TreeMap<>();
        Matcher row = ROW.matcher(read(DOCUMENT));
        while (row.find()) {
            table.put(row.group(1), row.group(2).equals("-") ? new TreeSet<>()
                    : new TreeSet<>(Set.of(row.group(2).split(", "))));
        }
        return table;
    }

    private static boolean isOurs(String name) {
        return name.equals("radiosity") || name.startsWith("radiosity.");
    }

    /** A package of the program without its prefix. */
    private static String shortName(String name) {
        return name.equals("radiosity") ? FRONT : name.substring("radiosity.".length());
    }

    /** Imported packages by package of the program, without its prefix. */
    private static Map<String, Set<String>> importsOfPackages() throws Exception {
        Map<String, Set<String>> imports = new TreeMap<>();
        for (String line : jdeps("-verbose:package").split("\\R")) {
            Matcher arrow = ARROW.matcher(line);
            if (arrow.matches()) {
                imports.computeIfAbsent(shortName(arrow.group(1)), p -> new TreeSet<>()).add(arrow.group(2));
            }
        }
        assertTrue(imports.containsKey("cli"), "jdeps found the classes");
        return imports;
    }

    /** Types of the program that each of its top-level types refers to. */
    private static Map<String, Set<String>> importsOfTypes() throws Exception {
        Map<String, Set<String>> imports = new TreeMap<>();
        for (String line : jdeps("-verbose:class").split("\\R")) {
            Matcher arrow = ARROW.matcher(line);
            if (arrow.matches() && isOurs(arrow.group(2))) {
                imports.computeIfAbsent(topLevel(arrow.group(1)), p -> new TreeSet<>()).add(topLevel(arrow.group(2)));
            }
        }
        return imports;
    }

    private static String topLevel(String type) {
        return type.replaceAll("\\$.*", "");
    }

    /** Sets of more than a number of nodes each of which leads to all the others. */
    private static List<Set<String>> knots(Map<String, Set<String>> graph, int most) {
        Map<String, Set<String>> reached = new TreeMap<>();
        graph.keySet().forEach(node -> reached.put(node, reachable(graph, node)));
        Set<Set<String>> knots = new LinkedHashSet<>();
        for (String node : graph.keySet()) {
            Set<String> knot = reached.get(node).stream()
                    .filter(other -> reached.getOrDefault(other, Set.of()).contains(node))
                    .collect(Collectors.toCollection(TreeSet::new));
            knot.add(node);
            if (knot.size() > most) {
                knots.add(knot);
            }
        }
        return List.copyOf(knots);
    }

    private static Set<String> reachable(Map<String, Set<String>> graph, String from) {
        Set<String> found = new TreeSet<>();
        Deque<String> next = new ArrayDeque<>(graph.getOrDefault(from, Set.of()));
        while (!next.isEmpty()) {
            String node = next.pop();
            if (!node.equals(from) && found.add(node)) {
                next.addAll(graph.getOrDefault(node, Set.of()));
            }
        }
        return found;
    }

    private static List<Path> sources() {
        try (Stream<Path> files = Files.walk(SOURCES)) {
            return files.filter(file -> file.toString().endsWith(".java")).sorted().toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static long lines(Path file) {
        return read(file).lines().count();
    }

    /**
     * Methods of classes that a class calls or refers to, as owner, name and descriptor: those in its constant pool.
     */
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

    private static String jdeps(String verbosity) throws Exception {
        StringWriter out = new StringWriter();
        ToolProvider.findFirst("jdeps").orElseThrow().run(new PrintWriter(out), new PrintWriter(out),
                verbosity, "-filter:none", "--multi-release", "base", root().toString());
        return out.toString();
    }
}
