package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.testkit.NeedsProgram;

/** The .cmd twins beside a jar, run by Windows' or Wine's cmd.exe with a java that only says how it was called. */
@Tag("slow")
@NeedsProgram({"wine", "cmd.exe"})
@Timeout(600)
class WindowsTwinsTest {

    private static final boolean WINDOWS = File.separatorChar == '\\';

    /** Wine's own files, made once: they have links to what must not be deleted with a temporary directory. */
    private static final Path WINE = Path.of("target", "wine").toAbsolutePath();

    /** What every program gives to the JVM, in any order and between any others. */
    private static final List<String> FLAGS = List.of("--enable-native-access=ALL-UNNAMED", "-XX:+UseParallelGC",
            "-XX:MaxRAMPercentage=75");

    @TempDir
    static Path directory;

    private static Path host;
    private final Map<String, String> environment = new TreeMap<>();

    @BeforeAll
    static void layOut() throws IOException {
        Files.createDirectories(WINE.getParent());
        host = Files.createDirectories(directory.resolve("a host"));
        for (String name : List.of("RadiosityRenderer.cmd", "PartitionServer.cmd", "ViewSceneFile.cmd", "start.cmd",
                "compiler.json")) {
            Files.copy(Path.of("scripts", name), host.resolve(name));
        }
        Files.writeString(host.resolve("radiosity.jar"), "");
        Path bin = Files.createDirectories(directory.resolve("a jdk").resolve("bin"));
        Files.writeString(bin.resolve("java.cmd"), "@echo off\r\necho java %*\r\nexit /b 3\r\n");
    }

    private static String windows(Path path) {
        return WINDOWS ? path.toString() : "Z:" + path.toAbsolutePath().toString().replace('/', '\\');
    }

    /**
     * Runs a line of a batch file, without per cent signs: Wine reads those among arguments again, which Windows does
     * not.
     *
     * @return what it prints, and its exit code as the last line
     */
    private List<String> run(String line) throws Exception {
        Path batch = Files.writeString(directory.resolve("run.cmd"), "@echo off\r\n" + line + "\r\n");
        List<String> command = new ArrayList<>(WINDOWS ? List.of() : List.of("wine"));
        command.addAll(List.of("cmd", "/c", windows(batch)));
        ProcessBuilder builder = new ProcessBuilder(command).directory(directory.toFile());
        builder.environment().remove("JAVA_OPTS");
        builder.environment().put("JAVA_HOME", windows(directory.resolve("a jdk")));
        builder.environment().put("WINEPREFIX", WINE.toString());
        builder.environment().put("WINEDEBUG", "-all");
        builder.environment().putAll(environment);
        builder.redirectError(directory.resolve("errors").toFile());
        Process process = builder.start();
        process.getOutputStream().close();
        List<String> lines = new ArrayList<>(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)
                .lines().toList());
        assertTrue(process.waitFor(1, TimeUnit.MINUTES));
        lines.add("exit " + process.exitValue());
        return lines;
    }

    private static String script(String name) {
        return "\"" + windows(host.resolve(name + ".cmd")) + "\"";
    }

    @ParameterizedTest
    @CsvSource({"RadiosityRenderer", "PartitionServer", "ViewSceneFile"})
    void argumentsAndExitCode_passThrough(String name) throws Exception {
        List<String> lines = run(script(name) + " -pa 50 \"a b.lws\" --map=P:\\x \"c d.scene\"");
        assertEquals(2, lines.size(), lines::toString);
        String own = " -cp \"" + windows(host) + "\\radiosity.jar\" radiosity.cli." + name;
        assertTrue(lines.get(0).startsWith("java ") && lines.get(0).endsWith(own
                + " -pa 50 \"a b.lws\" --map=P:\\x \"c d.scene\""), lines::toString);
        String flags = lines.get(0).substring(0, lines.get(0).indexOf(own));
        assertTrue(List.of(flags.split(" +")).containsAll(FLAGS), lines::toString);
        assertEquals("exit 3", lines.get(1));
    }

    @Test
    void whatIsCompiledSlowly_isNamedToTheJvm_butNotToOneWithItsOwnOptions() throws Exception {
        String named = "-XX:CompilerDirectivesFile=\"" + windows(host) + "\\compiler.json\"";
        assertTrue(run(script("RadiosityRenderer")).get(0).contains(named));
        environment.put("JAVA_OPTS", "-Xmx8g -Dx=y");
        String own = run(script("RadiosityRenderer")).get(0);
        assertTrue(own.contains(" -Xmx8g -Dx=y -cp ") && !own.contains("Directives"), own);
    }
}
