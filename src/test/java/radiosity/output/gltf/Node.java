package radiosity.output.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Runs JavaScript with packages from npm, which are installed below target/; skips the test where that cannot be. One
 * script runs at a time: the JVMs that Surefire starts share the packages and the files that are printed to.
 */
final class Node {

    private static final Path HOME = Path.of("target", "node").toAbsolutePath();

    private static final int ABSENT = -1;

    private Node() {
    }

    /**
     * What a script among the test resources prints as JSON.
     *
     * @param npm the package that it needs, with its version
     */
    static synchronized JsonNode run(String script, String npm, Path file) throws IOException, InterruptedException {
        Files.createDirectories(HOME);
        try (FileChannel channel = FileChannel.open(HOME.resolve("lock"), StandardOpenOption.CREATE,
                StandardOpenOption.WRITE); FileLock others = channel.lock()) {
            return runAlone(script, npm, file);
        }
    }

    private static JsonNode runAlone(String script, String npm, Path file) throws IOException, InterruptedException {
        install(npm);
        Path copy = HOME.resolve(script);
        try (InputStream in = Node.class.getResourceAsStream(script)) {
            Files.copy(in, copy, StandardCopyOption.REPLACE_EXISTING);
        }
        Path out = HOME.resolve(script + ".json");
        int code = start(out, "node", copy.toString(), file.toString());
        assumeTrue(code != ABSENT, "skipped: node is not there");
        assertEquals(0, code, () -> script + " failed, see " + out);
        return new ObjectMapper().readTree(out.toFile());
    }

    private static void install(String npm) throws IOException, InterruptedException {
        String name = npm.substring(0, npm.lastIndexOf('@'));
        if (Files.exists(HOME.resolve("node_modules").resolve(name).resolve("package.json"))) {
            return;
        }
        if (Files.notExists(HOME.resolve("package.json"))) {
            Files.writeString(HOME.resolve("package.json"), "{\"private\":true}");
        }
        String command = System.getProperty("os.name").startsWith("Windows") ? "npm.cmd" : "npm";
        int code = start(HOME.resolve("npm.log"), command, "install", "--no-audit", "--no-fund", "--ignore-scripts",
                npm);
        assumeTrue(code == 0, "skipped: node and npm could not install " + npm);
    }

    /** The exit code, or {@link #ABSENT} where there is no such program or it takes too long. */
    private static int start(Path out, String... command) throws IOException, InterruptedException {
        Process process;
        try {
            process = new ProcessBuilder(List.of(command)).directory(HOME.toFile()).redirectErrorStream(true)
                    .redirectOutput(out.toFile()).start();
        } catch (IOException absent) {
            return ABSENT;
        }
        if (!process.waitFor(2, TimeUnit.MINUTES)) {
            process.destroyForcibly();
            return ABSENT;
        }
        return process.exitValue();
    }
}
