package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The start script in a project of its own, with a java and an mvn that only say how they were called. */
@Tag("slow")
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "has the .cmd twins instead")
class ScriptsTest {

    /** Lets libraries load natives, of which JDKs from 24 on would warn. */
    private static final String NATIVES = "--enable-native-access=ALL-UNNAMED";

    @TempDir
    Path directory;

    private Path project;
    private final Map<String, String> environment = new TreeMap<>();

    @BeforeEach
    void makeProject() throws IOException {
        project = Files.createDirectories(directory.resolve("a project"));
        Files.createDirectories(project.resolve("scripts"));
        Files.createDirectories(project.resolve("target"));
        Files.createDirectories(project.resolve("src/main"));
        Files.writeString(project.resolve("pom.xml"), "");
        for (String script : new String[] {"RadiosityRenderer", "ViewSceneFile", "start.sh"}) {
            Files.copy(Path.of("scripts", script), project.resolve("scripts").resolve(script));
        }
        tool("java", "echo java \"$@\"");
        tool("mvn", "echo mvn \"$@\"; touch target/radiosity.jar");
        environment.put("PATH", directory.resolve("bin") + ":/usr/bin:/bin");
    }

    private void tool(String name, String does) throws IOException {
        tool("bin", name, does);
    }

    private void tool(String folder, String name, String does) throws IOException {
        Path tool = Files.createDirectories(directory.resolve(folder)).resolve(name);
        Files.writeString(tool, "#!/bin/sh\n" + does + "\n");
        assertTrue(tool.toFile().setExecutable(true));
    }

    /** A call would read per cent signs among the arguments again: "-pa 1%" would become "-pa 1". */
    @Test
    void windowsTwins_passArgumentsOnWithoutACall() throws IOException {
        for (String name : new String[] {"RadiosityRenderer", "PartitionServer", "ViewSceneFile"}) {
            List<String> lines = Files.readAllLines(Path.of("scripts", name + ".cmd"));
            assertEquals("\"%~dp0start.cmd\" %*", lines.get(lines.size() - 1), name);
        }
    }

    /** But for the archive of classes, which only start.sh makes. */
    @Test
    void windowsTwin_startsTheJvmWithTheSameOptions() throws IOException {
        String twin = Files.readString(Path.of("scripts", "start.cmd"));
        Matcher option = Pattern.compile("-XX:[+-]?\\w+").matcher(Files.readString(Path.of("scripts", "start.sh")));
        while (option.find()) {
            assertTrue(twin.contains(option.group()) || option.group().contains("Archive"), option.group());
        }
        for (String both : new String[] {NATIVES, "-Djansi.noreset=true", "-Dstyle.color=never"}) {
            assertTrue(twin.contains(both) && Files.readString(Path.of("scripts", "start.sh")).contains(both), both);
        }
        assertTrue(twin.contains("if not defined JAVA_OPTS"), "the JVM's own words are not shown with them");
        for (String name : new String[] {"RadiosityRenderer", "PartitionServer", "ViewSceneFile"}) {
            boolean ends = name.equals("RadiosityRenderer");
            assertEquals(ends, Files.readString(Path.of("scripts", name)).contains("directives=$here/compiler.json"),
                    name);
            assertEquals(ends, Files.readString(Path.of("scripts", name + ".cmd"))
                    .contains("set \"DIRECTIVES=%~dp0compiler.json\""), name);
        }
    }

    private String run(Path script, String... arguments) {
        try {
            Process process = start(script, arguments);
            String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            process.waitFor();
            return output;
        } catch (IOException | InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    private Process start(Path script, String... arguments) throws IOException {
        String[] command = new String[arguments.length + 2];
        command[0] = "/bin/sh";
        command[1] = script.toString();
        System.arraycopy(arguments, 0, command, 2, arguments.length);
        ProcessBuilder builder = new ProcessBuilder(command).directory(directory.toFile()).redirectErrorStream(true);
        builder.environment().remove("JAVA_HOME");
        builder.environment().remove("JAVA_OPTS");
        builder.environment().putAll(environment);
        return builder.start();
    }

    private Path script() {
        return project.resolve("scripts/RadiosityRenderer");
    }

    /** In the locale C, Java cannot open files whose names have letters beyond ASCII. */
    @Test
    void localeWithoutLetters_isReplaced() throws IOException {
        tool("java", "echo $LC_ALL");
        environment.put("LC_ALL", "C");
        assertTrue(run(script()).endsWith("C.UTF-8\n"), run(script()));
        environment.put("LC_ALL", "C.UTF-8");
        assertTrue(run(script()).endsWith("C.UTF-8\n"), run(script()));
    }

    /** What JogAmp's native code prints where the display goes away, and how it ends. */
    @Test
    void abortOfTheWindow_isOneLine() throws Exception {
        Files.writeString(project.resolve("scripts/radiosity.jar"), "");
        tool("java", "echo to the user: $*; echo a warning >&2\n"
                + "echo 'Nativewindow X11 IOError: Display 0x7f (:0): Resource temporarily unavailable' >&2\n"
                + "echo 'FATAL ERROR in native method: Nativewindow X11 IOError: Display 0x7f' >&2\n"
                + "echo '\tat sun.awt.X11.XToolkit.run(XToolkit.java:686)' >&2\nexit 134");
        Process aborted = start(project.resolve("scripts/ViewSceneFile"), "a.scene");
        String output = new String(aborted.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(1, aborted.waitFor());
        assertTrue(output.contains("a warning\n") && output.contains("to the user: "), output);
        assertTrue(output.contains(" -XX:+DisplayVMOutputToStderr "), "else the JVM's part would be on standard output");
        assertTrue(output.endsWith("display: expected it to stay, got none any more\n"), output);
        assertFalse(output.contains("Nativewindow") || output.contains("XToolkit"), output);
    }

    @Test
    void window_isEndedWithItsScriptAndKeepsItsExitCode() throws Exception {
        Files.writeString(project.resolve("scripts/radiosity.jar"), "");
        tool("java", "case $* in *wait.scene) trap 'echo ended; exit 143' TERM; echo begun;"
                + " while :; do sleep 0.1; done ;; *a.scene) cat; exit 3 ;; esac");
        Process process = start(project.resolve("scripts/ViewSceneFile"), "wait.scene");
        assertEquals('b', process.getInputStream().read());
        process.toHandle().destroy();
        assertTrue(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).contains("ended"));
        assertEquals(143, process.waitFor());
        Process other = start(project.resolve("scripts/ViewSceneFile"), "a.scene");
        other.getOutputStream().write("input".getBytes(StandardCharsets.UTF_8));
        other.getOutputStream().close();
        assertTrue(new String(other.getInputStream().readAllBytes(), StandardCharsets.UTF_8).endsWith("input"));
        assertEquals(3, other.waitFor());
    }

    @Test
    void missingJar_isBuiltOnce() throws Exception {
        String first = run(script(), "--version");
        assertTrue(first.contains("mvn ") && first.endsWith("radiosity.cli.RadiosityRenderer --version\n"), first);
        String second = run(script(), "--version");
        assertTrue(second.startsWith("java "), second);
    }

    @Test
    void jarOlderThanTheSources_isBuiltAgain() throws Exception {
        run(script());
        Path source = Files.writeString(project.resolve("src/main/Some.java"), "");
        Files.setLastModifiedTime(source, FileTime.fromMillis(
                Files.getLastModifiedTime(project.resolve("target/radiosity.jar")).toMillis() + 5000));
        String again = run(script());
        assertTrue(again.startsWith("building "), again);
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void programsStartedAtOnce_buildOnce(boolean flock) throws Exception {
        tool("mvn", "echo mvn; touch target/radiosity.jar; sleep 1");
        choose(flock);
        CompletableFuture<String> first = CompletableFuture.supplyAsync(() -> run(script()));
        await(project.resolve("target/build.unfinished"));
        String second = run(script());
        assertTrue(first.get().contains("mvn\njava "), first.get());
        assertTrue(second.matches("waiting for another program, which is building \\S.*\njava .*\n"), second);
        assertTrue(run(script()).startsWith("java "));
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void buildThatWasKilled_isDoneAgain(boolean flock) throws Exception {
        tool("mvn", "touch target/radiosity.jar; sleep 1");
        choose(flock);
        Process killed = start(script());
        await(project.resolve("target/radiosity.jar"));
        killed.destroyForcibly().waitFor();
        tool("mvn", "echo mvn; touch target/radiosity.jar");
        assertTrue(run(script()).contains("mvn\njava "));
    }

    @Test
    void timeOfTheBuild_isNotTheProgramsOwn() {
        assertTrue(run(script()).contains(" -Dradiosity.built=true "));
        assertFalse(run(script()).contains("radiosity.built"));
    }

    @Test
    void jarBuiltByHand_hasItsClassesKeptOnce() throws Exception {
        tool("java", "case \"$*\" in *ArchiveClassesAtExit*) echo kept >>kept;; esac");
        Files.writeString(project.resolve("target/radiosity.jar"), "");
        run(script());
        run(script());
        assertEquals(List.of("kept"), Files.readAllLines(directory.resolve("kept")));
    }

    private void choose(boolean flock) throws IOException {
        assumeTrue(!flock || Files.exists(Path.of("/usr/bin/flock")), "needs flock");
        onlyTools("touch", "sleep", flock ? "flock" : "ln");
    }

    private static void await(Path file) throws Exception {
        for (int i = 0; i < 500 && Files.notExists(file); i++) {
            Thread.sleep(10);
        }
    }

    @Test
    void jarBesideTheScript_needsNoMaven() throws Exception {
        Path host = Files.createDirectories(directory.resolve("host"));
        Files.copy(project.resolve("scripts/start.sh"), host.resolve("start.sh"));
        Files.copy(script(), host.resolve("RadiosityRenderer"));
        Files.writeString(host.resolve("radiosity.jar"), "");
        Files.delete(directory.resolve("bin/mvn"));
        String output = run(host.resolve("RadiosityRenderer"), "a", "b c");
        assertTrue(output.startsWith("java ") && output.endsWith(" -cp " + host.toRealPath()
                + "/radiosity.jar radiosity.cli.RadiosityRenderer a b c\n"), output);
    }

    @Test
    void whatIsCompiledSlowly_isNamedToTheJvm_butNotToOneWithItsOwnOptions() throws Exception {
        Files.copy(Path.of("scripts", "compiler.json"), project.resolve("scripts/compiler.json"));
        String named = "-XX:CompilerDirectivesFile=" + project.toRealPath() + "/scripts/compiler.json";
        run(script());
        assertTrue(run(script()).contains(named));
        environment.put("JAVA_OPTS", "-Xmx1g");
        assertFalse(run(script()).contains("Directives"));
    }

    @Test
    void whatIsCompiledSlowly_isUnderstoodByThisJvm_withoutAWord() throws Exception {
        Process java = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UnlockDiagnosticVMOptions", "-XX:-DisplayVMOutput",
                "-XX:CompilerDirectivesFile=" + Path.of("scripts", "compiler.json"), "--version").start();
        String output = new String(java.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals("", new String(java.getErrorStream().readAllBytes(), StandardCharsets.UTF_8));
        assertEquals(0, java.waitFor());
        assertFalse(output.contains("directive"), output);
    }

    /** A pattern left behind by a class that was moved would give it to the quick compiler for good. */
    @Test
    void whatIsCompiledSlowly_isThere() throws IOException {
        Matcher pattern = Pattern.compile("\"(radiosity/[^\"]+)\\.\\*\"")
                .matcher(Files.readString(Path.of("scripts", "compiler.json")));
        int patterns = 0;
        while (pattern.find()) {
            patterns++;
            Path source = Path.of("src", "main", "java", pattern.group(1).replaceAll("/\\*$", ""));
            assertTrue(Files.isDirectory(source) || Files.isRegularFile(Path.of(source + ".java")), source.toString());
        }
        assertTrue(patterns >= 3, "rays, visibility and pictures");
    }

    @Test
    void neitherJarNorMaven_isToldInOneLine() throws Exception {
        Files.delete(directory.resolve("bin/mvn"));
        onlyTools();
        assertEquals("mvn: expected Maven or " + project.toRealPath() + "/scripts/radiosity.jar, got neither\n",
                run(script()));
    }

    /** A directory of what the script needs, and these: so no other tool of the machine is found. */
    private void onlyTools(String... more) throws IOException {
        List<String> tools = new ArrayList<>(List.of("dirname", "readlink", "find", "head", "rm", "mkdir"));
        tools.addAll(List.of(more));
        for (String tool : tools) {
            tool("tools", tool, "PATH=/usr/bin:/bin exec " + tool + " \"$@\"");
        }
        environment.put("PATH", directory.resolve("bin") + ":" + directory.resolve("tools"));
    }

    @Test
    void linkToTheScript_findsItsProject() throws Exception {
        run(script());
        Path link = Files.createSymbolicLink(directory.resolve("rr"), script());
        assertTrue(run(link, "--version").startsWith("java "));
    }

    @Test
    void javaOptions_comeLast() throws Exception {
        run(script());
        environment.put("JAVA_OPTS", "-Xmx8g -Dx=y");
        assertTrue(run(script()).contains(" -XX:MaxRAMPercentage=75 -Xmx8g -Dx=y -cp "));
    }

    @Test
    void build_printsNoEscapeCodes() throws Exception {
        tool("mvn", "echo mvn $MAVEN_OPTS; touch target/radiosity.jar");
        environment.put("MAVEN_OPTS", "-Xmx1g");
        assertTrue(run(script()).contains("mvn -Xmx1g -Djansi.noreset=true\n"));
    }
}
