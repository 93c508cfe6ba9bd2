package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.testkit.JavaMachines;
import radiosity.testkit.NeedsProgram;
import radiosity.testkit.Program;
import radiosity.testkit.Xvfb;

/**
 * No JDK at hand adds a warning to what the programs print. JDKs from 24 on warn of the natives of the key listener and
 * of Java 3D unless the start script lets these load them.
 */
@Tag("slow")
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "has the .cmd twins instead")
class JdkWarningsTest {

    /** The first version that warns of natives. */
    private static final int WARNS = 24;

    @TempDir
    Path directory;

    private Path scripts;
    private Path scene;

    /** The scripts beside a jar that names the classes of the tests. */
    @BeforeEach
    void copyScripts() throws IOException {
        scene = directory.resolve("box.scene");
        scripts = Files.createDirectory(directory.resolve("scripts"));
        for (String script : new String[] {"RadiosityRenderer", "ViewSceneFile", "start.sh"}) {
            Files.copy(Path.of("scripts", script), scripts.resolve(script));
        }
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        manifest.getMainAttributes().put(Attributes.Name.CLASS_PATH, Stream.of(System.getProperty(
                "surefire.test.class.path", System.getProperty("java.class.path")).split(File.pathSeparator))
                .map(entry -> Path.of(entry).toUri().toString()).collect(Collectors.joining(" ")));
        try (OutputStream file = Files.newOutputStream(scripts.resolve("radiosity.jar"))) {
            new JarOutputStream(file, manifest).close();
        }
    }

    static Stream<Arguments> jdks() throws IOException {
        return JavaMachines.homes().entrySet().stream().map(jdk -> Arguments.of(jdk.getKey(), jdk.getValue()));
    }

    private ProcessBuilder onJdk(Path home, ProcessBuilder program) {
        program.environment().put("JAVA_HOME", home.toString());
        program.environment().remove("JAVA_OPTS");
        return program.redirectErrorStream(true);
    }

    /** On a pseudo terminal: only there is a key listened for. */
    @ParameterizedTest(name = "JDK {0}")
    @MethodSource("jdks")
    @NeedsProgram("python3")
    void renderer_printsNoWarning(int version, Path home) throws Exception {
        List<String> command = new ArrayList<>(List.of("python3", "-c", "import pty,sys; pty.spawn(sys.argv[1:])"));
        Collections.addAll(command, scripts.resolve("RadiosityRenderer").toString(), "-q", "-pa", "20000", "-it", "1",
                "scenes/cornell-box.lws", scene.toString());
        Process process = onJdk(home, new ProcessBuilder(command)).start();
        process.getOutputStream().close();
        String output = Program.rest(process);
        assertTrue(output.contains("1 shot in 1 round"), output);
        assertFalse(output.contains("WARNING"), output);
    }

    @ParameterizedTest(name = "JDK {0}")
    @MethodSource("jdks")
    @NeedsProgram("Xvfb")
    void viewer_printsNothing(int version, Path home) throws Exception {
        assertEquals(0, RadiosityRenderer.run("-q", "-dr", "-pa", "20000", "scenes/cornell-box.lws", scene.toString()));
        Path shot = directory.resolve("shot.png");
        try (Xvfb display = new Xvfb()) {
            ProcessBuilder program = display.command(List.of(scripts.resolve("ViewSceneFile").toString(),
                    "--screenshot", shot.toString(), "--size", "100x100", scene.toString()));
            Process process = onJdk(home, program).start();
            assertEquals("", Program.rest(process));
            assertEquals(0, process.waitFor());
        }
        assertEquals(100, ImageIO.read(shot.toFile()).getHeight());
    }

    @Test
    void jdkThatWarns_isAtHand() throws IOException {
        int newest = Collections.max(JavaMachines.homes().keySet());
        assumeTrue(newest >= WARNS, "needs a JDK of version " + WARNS + " or later, named by an environment variable"
                + " that begins with JAVA_HOME; warnings are looked for on JDK " + newest + " at most");
    }
}
