package radiosity;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import radiosity.worker.PartitionPort;

/** What the documents say is there, and what they show works. */
class DocumentsTest {

    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#:]+)(#[^)]*)?\\)");
    private static final Pattern EXAMPLE = Pattern.compile("```java\\R(.*?)```", Pattern.DOTALL);
    private static final Pattern WRITTEN = Pattern.compile("\"([\\w-]+\\.(?:scene|png))\"");
    private static final Pattern SOURCE = Pattern.compile("\\[(\\w+)\\]\\([^)]*src/main/java/([\\w/]+)\\.java\\)");
    private static final Pattern CODE = Pattern.compile("`(\\w+)`( in (?=\\[))?");
    private static final Pattern CLASS_NAME = Pattern.compile("([A-Z][a-z0-9]+){2,}");
    private static final Pattern METHOD_NAME = Pattern.compile("[a-z0-9]+([A-Z][a-z0-9]*)+");
    private static final Pattern SCRIPT = Pattern.compile("scripts/[A-Za-z-]+(\\.\\w+)?");

    @TempDir
    Path directory;

    @Test
    void everyLink_leadsToAFile() throws IOException {
        List<String> broken = new ArrayList<>();
        for (Path document : documents()) {
            Matcher link = LINK.matcher(Files.readString(document));
            while (link.find()) {
                if (!Files.exists(document.resolveSibling(link.group(1)))) {
                    broken.add(document + ": " + link.group(1));
                }
            }
        }
        assertEquals(List.of(), broken);
    }

    @Test
    void everyScriptThatIsNamed_exists() throws IOException {
        List<String> missing = new ArrayList<>();
        for (Path document : documents()) {
            Matcher script = SCRIPT.matcher(Files.readString(document));
            while (script.find()) {
                if (!Files.exists(Path.of(script.group()))) {
                    missing.add(document + ": " + script.group());
                }
            }
        }
        assertEquals(List.of(), missing);
    }

    /** Among words in quotes of code, {@code `m` in [C]} and {@code `camelCase`} are methods of the classes linked. */
    @Test
    void everyClassAndMethodOfThePaperTable_exists() throws Exception {
        List<String> missing = new ArrayList<>();
        Set<String> classes = compiledNames();
        int line = 0;
        for (String text : Files.readAllLines(Path.of("docs/PAPER.md"))) {
            line++;
            for (String name : missingNames(text, classes)) {
                missing.add("docs/PAPER.md:" + line + ": " + name);
            }
        }
        assertEquals(List.of(), missing);
    }

    @Test
    void namesThatDoNotExist_areFound() throws Exception {
        String link = "[%s](../src/main/java/radiosity/cli/RadiosityRenderer.java), `OtherReadersTest`, `-it`, `int`";
        Set<String> classes = compiledNames();
        String real = link.formatted("RadiosityRenderer");
        assertEquals(List.of(), missingNames("`main` in " + real, classes));
        assertEquals(List.of("mainly"), missingNames("`mainly` in " + real, classes));
        assertEquals(List.of("mainOf", "NoSuchClass"), missingNames(real + "; `mainOf`, `NoSuchClass`", classes));
        assertEquals(List.of("Renderer"), missingNames(link.formatted("Renderer"), classes));
        assertEquals(List.of("radiosity.cli.NoSuchClass"),
                missingNames("[NoSuchClass](../src/main/java/radiosity/cli/NoSuchClass.java)", classes));
    }

    /** Classes, linked or in quotes of code, and methods that a line of a document names and the program lacks. */
    private static List<String> missingNames(String text, Set<String> classes) {
        List<String> missing = new ArrayList<>();
        Set<String> methods = new HashSet<>();
        for (MatchResult source : SOURCE.matcher(text).results().toList()) {
            String name = source.group(2).replace('/', '.');
            try {
                Class<?> linked = Class.forName(name, false, DocumentsTest.class.getClassLoader());
                Stream.of(linked.getMethods(), linked.getDeclaredMethods()).flatMap(Stream::of)
                        .forEach(method -> methods.add(method.getName()));
                if (!linked.getSimpleName().equals(source.group(1))) {
                    missing.add(source.group(1));
                }
            } catch (ClassNotFoundException e) {
                missing.add(name);
            }
        }
        for (MatchResult code : CODE.matcher(text).results().toList()) {
            String word = code.group(1);
            boolean isMethod = code.group(2) != null || METHOD_NAME.matcher(word).matches();
            if (isMethod ? !methods.contains(word)
                    : CLASS_NAME.matcher(word).matches() && !classes.contains(word)) {
                missing.add(word);
            }
        }
        return missing;
    }

    /** Simple names of all classes of the program and of its tests. */
    private static Set<String> compiledNames() throws Exception {
        Set<String> names = new HashSet<>();
        for (Class<?> one : List.of(Radiosity.class, DocumentsTest.class)) {
            Path root = Path.of(one.getProtectionDomain().getCodeSource().getLocation().toURI());
            try (Stream<Path> files = Files.walk(root)) {
                files.map(file -> file.getFileName().toString()).filter(name -> name.endsWith(".class"))
                        .forEach(name -> names.add(name.replaceAll(".*\\$|\\.class$", "")));
            }
        }
        return names;
    }

    /** The first block of docs/API.md holds the imports of all examples. */
    @Tag("slow")
    @TestFactory
    Stream<DynamicTest> everyExample_runs() throws IOException {
        List<String> recipes = examples(Path.of("docs/API.md"));
        assertTrue(recipes.size() > 10, "ten recipes and their imports");
        String imports = recipes.remove(0);
        recipes.addAll(0, examples(Path.of("README.md")));
        return recipes.stream().map(body -> DynamicTest.dynamicTest(body.lines().findFirst().orElseThrow(), () -> {
            try (PartitionPort host = serve()) {
                run(imports + """
                        public class Example implements java.util.concurrent.Callable<Void> {
                            public Void call() throws Exception {
                        %s
                                return null;
                            }
                        }
                        """.formatted(inDirectory(body.replace("4099", String.valueOf(host.port())))));
            }
            for (String name : written(body)) {
                assertTrue(Files.size(directory.resolve(name)) > 0, name);
            }
        }));
    }

    /** The host of the recipe for other machines, on a free port. */
    private static PartitionPort serve() throws IOException {
        InetAddress loopback = InetAddress.getLoopbackAddress();
        int port;
        try (ServerSocket free = new ServerSocket(0, 1, loopback)) {
            port = free.getLocalPort();
        }
        return PartitionPort.open(new PartitionPort.Options(port, 0, loopback, null, 1), line -> { });
    }

    private static List<String> examples(Path document) throws IOException {
        return EXAMPLE.matcher(Files.readString(document)).results().map(found -> found.group(1))
                .collect(Collectors.toCollection(ArrayList::new));
    }

    private static List<String> written(String example) {
        return WRITTEN.matcher(example).results().map(found -> found.group(1)).toList();
    }

    private String inDirectory(String example) {
        String prefix = directory.toString().replace("\\", "\\\\") + "/";
        return WRITTEN.matcher(example).replaceAll(found ->
                Matcher.quoteReplacement("\"" + prefix + found.group(1) + "\""));
    }

    /** Compiles a class named Example and calls it. */
    private void run(String source) throws Exception {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        JavaFileObject file = new SimpleJavaFileObject(URI.create("string:///Example.java"),
                JavaFileObject.Kind.SOURCE) {
            @Override
            public CharSequence getCharContent(boolean ignoreEncodingErrors) {
                return source;
            }
        };
        StringWriter errors = new StringWriter();
        List<String> options = List.of("-d", directory.toString(), "-classpath",
                System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")));
        assertTrue(compiler.getTask(errors, null, null, options, null, List.of(file)).call(), errors.toString());
        try (URLClassLoader loader = new URLClassLoader(new URL[] {directory.toUri().toURL()})) {
            Object example = loader.loadClass("Example").getDeclaredConstructor().newInstance();
            ((java.util.concurrent.Callable<?>) example).call();
        }
    }

    private static List<Path> documents() throws IOException {
        List<Path> documents = new ArrayList<>(List.of(Path.of("README.md"), Path.of("scenes/README.md")));
        try (Stream<Path> docs = Files.list(Path.of("docs"))) {
            docs.filter(p -> p.toString().endsWith(".md")).forEach(documents::add);
        }
        return documents;
    }
}
