package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.options.ExitCode;
import radiosity.cli.render.SavedCalculation;
import radiosity.output.file.LockedFile;
import radiosity.testkit.Program;

/**
 * Every output of a render is the old file or the new one, whole, whatever ends the render or keeps it from writing.
 */
@Tag("slow")
@Timeout(value = 3, unit = TimeUnit.MINUTES, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class WholeOutputsTest {

    private static final String OLD = "the old file";
    private static final int POINTS = 100;
    /** Options that write each kind of output; %s is the directory for them. */
    private static final String OUTPUTS = "--size 40x30 --picture %1$s/a.png --points in.csv %1$s/out.csv"
            + " --report %1$s/report.json foobar.lws %1$s/foobar.scene";
    private static final String QUICK = "-q -pa 20000 -it 5 ";

    /** What reads an output of each name, and fails where it is not whole. */
    private interface Reader {
        void read(Path file) throws IOException;
    }

    private static final Map<String, Reader> READERS = Map.of(
            "foobar.scene", file -> SavedCalculation.read(file).shots(),
            "a.png", file -> assertEquals(40, ImageIO.read(file.toFile()).getWidth()),
            "out.csv", file -> assertEquals(1 + POINTS, Files.readString(file).lines()
                    .filter(l -> l.split(",").length == 12)
                    .count()),
            "report.json", file -> assertTrue(new ObjectMapper().readTree(file.toFile()).has("certificate")));

    @TempDir
    Path directory;

    private Program program;
    private Path outputs;

    @BeforeEach
    void makeDirectory() throws IOException {
        program = new Program(directory);
        Files.writeString(program.file("in.csv"), "278,0,-280,0,1,0\n".repeat(POINTS));
        outputs = Files.createDirectory(program.file("outputs"));
    }

    private void writeOld(Path to) throws IOException {
        for (String name : READERS.keySet()) {
            Files.writeString(to.resolve(name), OLD);
        }
    }

    private static void assertOld(Path in) throws IOException {
        for (String name : READERS.keySet()) {
            assertEquals(OLD, Files.readString(in.resolve(name)), name);
        }
    }

    /** Whether a file is the new one. */
    private static boolean isNewAndWhole(Path file) throws IOException {
        if (Files.size(file) == OLD.length() && Files.readString(file).equals(OLD)) {
            return false;
        }
        READERS.get(file.getFileName().toString()).read(file);
        return true;
    }

    private static Set<String> names(Path in) throws IOException {
        Set<String> names = new TreeSet<>();
        try (Stream<Path> files = Files.list(in)) {
            files.forEach(file -> names.add(file.getFileName().toString()));
        }
        return names;
    }

    private int ended(String command) throws Exception {
        Process render = program.start(command);
        String printed = Program.rest(render);
        assertTrue(printed.lines().noneMatch(line -> line.startsWith("\tat ")), printed);
        return render.waitFor();
    }

    /** Killed when it begins a file; the first four only try whether the outputs can be written. */
    @Test
    void killedRender_leavesEveryFileOldOrNew_andTheNextOneClearsUp() throws Exception {
        for (int file : new int[] {1, 4, 5, 6, 7, 8}) {
            writeOld(outputs);
            Process render = program.start(QUICK + OUTPUTS.formatted("outputs"));
            killAtFile(render, file);
            for (String name : READERS.keySet()) {
                isNewAndWhole(outputs.resolve(name));
            }
        }
        assertEquals(ExitCode.DONE, ended(QUICK + OUTPUTS.formatted("outputs")));
        assertEquals(READERS.keySet(), names(outputs));
        for (String name : READERS.keySet()) {
            assertTrue(isNewAndWhole(outputs.resolve(name)), name);
        }
    }

    private void killAtFile(Process render, int number) throws Exception {
        Set<String> begun = new HashSet<>();
        while (render.isAlive() && begun.size() < number) {
            names(outputs).stream().filter(name -> name.startsWith(".radiosity")).forEach(begun::add);
        }
        render.destroyForcibly().waitFor();
    }

    @Test
    void filesOfKilledRenders_areTakenAway_butNotThoseOfLiveOnes() throws Exception {
        Path dead = outputs.resolve(".radiosity-1-0.part");
        Files.writeString(dead, "half");
        Files.writeString(Files.createDirectory(outputs.resolve(".radiosity-1-0.part.d")).resolve("foobar.scene"), "");
        Path others = Files.writeString(outputs.resolve(".radiosity.notes"), "of somebody else");
        try (LockedFile live = LockedFile.create(outputs.toRealPath(), "part")) {
            assertEquals(ExitCode.DONE, ended(QUICK + "foobar.lws outputs/foobar.scene"));
            assertEquals(Set.of("foobar.scene", others.getFileName().toString(), live.path().getFileName().toString()),
                    names(outputs));
        }
    }

    @Test
    void fullDisk_keepsEveryOldFile_andEachOneIsNamed() throws Exception {
        String script = mounted() + "cat /dev/zero >full/filler 2>/dev/null; \"$@\" >printed 2>&1; code=$?;"
                + " rm full/filler; cp -a full/. outputs; exit $code";
        assertEquals(ExitCode.FILE, inNamespace(script, QUICK + OUTPUTS.formatted("full")));
        assertOld(outputs);
        assertEquals(READERS.keySet(), names(outputs));
        String printed = Files.readString(program.file("printed"));
        for (String name : READERS.keySet()) {
            assertTrue(printed.contains("full/" + name + ": expected to be written, got No space left on device\n"),
                    printed);
        }
    }

    /** A read-only one is mounted over it while the render is held up; saving may take as long as it likes. */
    @Test
    void diskThatMayNotBeWrittenAnyMore_keepsEveryOldFile() throws Exception {
        String script = mounted() + "\"$@\" >printed 2>&1 & until grep -q distributing printed; do sleep .05; done;"
                + " kill -STOP $!; mount -t tmpfs -o ro none full; kill -TERM $!; kill -CONT $!; wait $!; code=$?;"
                + " umount full; cp -a full/. outputs; exit $code";
        assertEquals(143, inNamespace(script, RendererWithPatience.command(RendererWithPatience.ENDLESS,
                "--schedule paper -pa 3000 -se 0 " + OUTPUTS.formatted("full"))));
        assertOld(outputs);
        String printed = Files.readString(program.file("printed"));
        assertTrue(printed.contains("full/foobar.scene: expected to be written, got "), printed);
    }

    @Test
    void directoryThatMayNotBeWritten_isRefusedBeforeAnyWork() throws Exception {
        String script = mounted()
                + "mount -o remount,ro full; \"$@\" >printed 2>&1; code=$?; cp -a full/. outputs; exit $code";
        assertEquals(ExitCode.FILE, inNamespace(script, QUICK + OUTPUTS.formatted("full")));
        assertOld(outputs);
        String printed = Files.readString(program.file("printed"));
        assertTrue(printed.matches("full/foobar.scene: expected a (file|directory) that can be written, got .*\n"),
                printed);
    }

    /** Shell commands that make a file system of its own in the directory "full", with the old files. */
    private String mounted() throws IOException {
        writeOld(outputs);
        Files.createDirectory(program.file("full"));
        return "mount -t tmpfs -o size=256k none full && cp outputs/* full && rm outputs/* || exit 99; ";
    }

    /** Exit code of a script in a mount namespace, which needs Linux and either root or user namespaces. */
    private int inNamespace(String script, String arguments) throws Exception {
        return inNamespace(script, Program.command(arguments));
    }

    private int inNamespace(String script, List<String> command) throws Exception {
        List<String> unshare = new ArrayList<>(List.of("unshare", "-rm", "sh", "-c"));
        assumeTrue(worksHere(unshare),
                "needs a mount namespace (unshare -rm): full and read-only disks are not tested");
        unshare.addAll(List.of(script, "sh"));
        unshare.addAll(command);
        return program.start(unshare).waitFor();
    }

    private static boolean worksHere(List<String> unshare) throws InterruptedException {
        List<String> command = new ArrayList<>(unshare);
        command.add("mount -t tmpfs none /tmp");
        try {
            return new ProcessBuilder(command).start().waitFor() == 0;
        } catch (IOException e) {
            return false;
        }
    }

    @Test
    @EnabledOnOs({OS.LINUX, OS.MAC})
    void linkToNoFileYet_isFollowed() throws Exception {
        Files.createSymbolicLink(program.file("link.scene"), Path.of("outputs/target.scene"));
        assertEquals(ExitCode.DONE, ended(QUICK + "foobar.lws link.scene"));
        assertTrue(Files.isSymbolicLink(program.file("link.scene")));
        assertEquals(5, SavedCalculation.read(outputs.resolve("target.scene")).shots());
    }
}
