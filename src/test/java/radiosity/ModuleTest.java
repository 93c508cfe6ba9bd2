package radiosity;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.Member;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Holds the library's module, which the build puts into its jar, against the classes. */
class ModuleTest {

    private static final Path CLASSES = Path.of("target/classes");
    private static final Pattern OURS = Pattern.compile("radiosity(\\.[a-z]+)*(?=\\.[A-Z])");

    private static Set<String> declared(String directive) throws IOException {
        String module = Files.readString(Path.of("src/main/module/module-info.java"));
        return Pattern.compile("(?m)^    " + directive + " ([\\w.]+);").matcher(module).results()
                .map(found -> found.group(1)).collect(Collectors.toCollection(TreeSet::new));
    }

    /** Whoever is given an object of a closed package can neither name its type nor call its methods. */
    @Test
    void whatIsExported_namesNoTypeOfAClosedPackage() throws Exception {
        Set<String> open = declared("exports");
        Set<String> closed = new TreeSet<>();
        for (String name : open) {
            try (Stream<Path> files = Files.list(CLASSES.resolve(name.replace('.', '/')))) {
                for (Path file : files.filter(f -> f.toString().endsWith(".class")).toList()) {
                    String type = file.getFileName().toString().replaceAll("\\.class$", "");
                    addClosed(Class.forName(name + "." + type), open, closed);
                }
            }
        }
        assertEquals(Set.of(), closed);
    }

    private static void addClosed(Class<?> type, Set<String> open, Set<String> closed) {
        if (!Modifier.isPublic(type.getModifiers())) {
            return;
        }
        Stream<Member> members = Stream.of(type.getDeclaredFields(), type.getDeclaredMethods(),
                type.getDeclaredConstructors()).flatMap(Stream::of);
        members.filter(member -> (member.getModifiers() & (Modifier.PUBLIC | Modifier.PROTECTED)) != 0)
                .map(member -> member instanceof Field field ? field.toGenericString()
                        : ((Executable) member).toGenericString().replaceAll(" throws .*", ""))
                .forEach(text -> OURS.matcher(text).results().filter(found -> !open.contains(found.group()))
                        .forEach(found -> closed.add(text)));
    }

    @Test
    void modulesThatTheClassesNeed_areRequired() throws IOException {
        StringWriter out = new StringWriter();
        ToolProvider.findFirst("jdeps").orElseThrow().run(new PrintWriter(out), new PrintWriter(out), "-s",
                "--multi-release", "base", CLASSES.toString());
        Set<String> needed = Pattern.compile("-> (java\\S+|jdk\\S+)").matcher(out.toString()).results()
                .map(found -> found.group(1)).collect(Collectors.toCollection(TreeSet::new));
        Set<String> required = declared("requires(?: static)?");
        required.add("java.base");
        required.remove("com.fasterxml.jackson.databind");
        assertEquals(required, needed);
    }
}
