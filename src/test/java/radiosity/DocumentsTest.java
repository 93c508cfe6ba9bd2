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
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import radiosity.worker.PartitionPort;

/** What the documents say is there, and what they show works. */
class DocumentsTest {

    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#:]+)(#[^)]*)?\\)");
    private static final Pattern EXAMPLE = Pattern.compile("```java\\R(.*?)```", Pattern.DOTALL);
    private static final Pattern WRITTEN = Pattern.compile("\"([\\w-]+\\.(?:scene|png))\"");
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

    /** The first block of docs/API.md holds the imports of all examples. */
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
        try (ServerSocket free = new ServerSocket(0, 1, loopback)) {
            int port = free.getLocalPort();
            free.close();
            return PartitionPort.open(new PartitionPort.Options(port, 0, loopback, null, 1), line -> { });
        }
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
