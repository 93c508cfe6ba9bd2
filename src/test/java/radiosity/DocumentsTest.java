package radiosity;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.net.URI;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.output.SceneFile;

/** What the documents say is there, and what they show works. */
class DocumentsTest {

    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#:]+)(#[^)]*)?\\)");
    private static final Pattern EXAMPLE = Pattern.compile("```java\\R(.*?)```", Pattern.DOTALL);
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

    @Test
    void readmesExample_writesASceneFile() throws Exception {
        Matcher example = EXAMPLE.matcher(Files.readString(Path.of("README.md")));
        assertTrue(example.find());
        Path scene = directory.resolve("cornell.scene");
        String body = example.group(1).replace("\"cornell.scene\"", '"' + scene.toString().replace("\\", "\\\\") + '"');
        run("""
                import java.nio.file.Path;
                import java.util.Map;
                import radiosity.lightwave.*;
                import radiosity.output.*;
                import radiosity.scene.*;
                import radiosity.world.*;
                public class Example implements java.util.concurrent.Callable<Void> {
                    public Void call() throws Exception {
                %s
                        return null;
                    }
                }
                """.formatted(body));
        try (SceneFile written = SceneFile.open(scene)) {
            assertTrue(written.ledger().absorbed()[0] > 0);
        }
    }

    /** Compiles a class named Example and calls it. */
    private void run(String source) throws Exception {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        JavaFileObject file = new SimpleJavaFileObject(URI.create("string:///Example.java"), JavaFileObject.Kind.SOURCE) {
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
