package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import radiosity.cli.options.ExitCode;
import radiosity.cli.render.SavedCalculation;
import radiosity.output.file.LockedFile;
import radiosity.testkit.DirectoryChanges;
import radiosity.testkit.MountNamespace;
import radiosity.testkit.Program;

/**
 * Every output of a render is the old file or the new one, whole, whatever ends the render or keeps it from writing.
 */
@Tag("slow")
@Timeout(value = 3, unit = TimeUnit.MINUTES, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class WholeOutputsTest {

    private static final String OLD = "the old file";
    private static final int POINTS = 100;
    private static final String QUICK = "-q -pa 20000 -it 5 --size 40x30 --spacing 100 -sn 5 ";
    /** Shots after which {@link #QUICK} writes its snapshot. */
    private static final int SHOTS = 5;
    /** Changes of the directory that the second killed render may make, and that each further one may make more. */
    private static final int SECOND = 8;
    private static final int STEP = 3;
    /** Rows of kills at most. */
    private static final int ROWS = 4;
    private static final int EXR = 20000630;

    /** What reads an output, and fails where it is not whole. */
    private interface Reader {
        void read(Path file) throws IOException;
    }

    /** Every file that a render writes and keeps. */
    private enum Output {
        SCENE("foobar.scene", "foobar.lws %s", file -> assertEquals(SHOTS, SavedCalculation.read(file).shots())),
        SNAPSHOT("foobar.scene-5.jpg", "", Output::assertPicture),
        PICTURE("a.png", "--picture %s", Output::assertPicture),
        FALSE_COLOURS("colours.png", "--false-colour %s", Output::assertPicture),
        POINTS("out.csv", "--points in.csv %s", file -> assertEquals(1 + WholeOutputsTest.POINTS,
                Files.readString(file).lines().filter(line -> line.split(",").length == 12).count())),
        GRID("grid.csv", "--grid y=100 %s", Output::assertGrid),
        MODEL("room.glb", "--lightmap %s", file -> {
            ByteBuffer bytes = littleEndian(file);
            assertEquals(bytes.capacity(), bytes.getInt(8));
        }),
        LIGHTMAP("room-lightmap.exr", "", Output::assertLightmap),
        REPORT("report.json", "--report %s",
                file -> assertTrue(new ObjectMapper().readTree(file.toFile()).has("certificate")));

        private final String file;
        /** The words of the command line that name the file; none where the name follows from another output's. */
        private final String words;
        private final Reader reader;

        Output(String file, String words, Reader reader) {
            this.file = file;
            this.words = words;
            this.reader = reader;
        }

        private static ByteBuffer littleEndian(Path file) throws IOException {
            return ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN);
        }

        private static void assertPicture(Path file) throws IOException {
            assertNotNull(ImageIO.read(file.toFile()), file + " is no picture");
            byte[] bytes = Files.readAllBytes(file);
            // decoders show the upper part of a picture that is cut off
            String end = new String(bytes, bytes.length - 8, 8, StandardCharsets.ISO_8859_1);
            assertTrue(end.startsWith("IEND") || end.endsWith("\u00ff\u00d9"), end);
        }

        /** As many points as the table says. */
        private static void assertGrid(Path file) throws IOException {
            String table = Files.readString(file);
            Matcher points = Pattern.compile("# points,(\\d+)\n").matcher(table);
            assertTrue(points.find() && table.endsWith("\n"), table);
            assertEquals(Long.parseLong(points.group(1)),
                    table.lines().filter(line -> line.matches("[-0-9].*") && line.split(",").length == 7).count());
        }

        /** The last block, to which the list before the first one points, ends at the end of the file. */
        private static void assertLightmap(Path file) throws IOException {
            ByteBuffer bytes = littleEndian(file);
            assertEquals(EXR, bytes.getInt(0));
            int list = new String(bytes.array(), StandardCharsets.ISO_8859_1).indexOf("screenWindowWidth")
                    + "screenWindowWidth\0float\0".length() + 2 * Integer.BYTES + 1;
            int first = (int) bytes.getLong(list);
            int last = (int) bytes.getLong(first - Long.BYTES);
            assertEquals(bytes.capacity(), last + 2 * Integer.BYTES + bytes.getInt(last + Integer.BYTES));
        }

        /** The words of a command line that writes every output into a directory. */
        static String all(String directory) {
            return Stream.of(values()).map(output -> output.words.formatted(directory + "/" + output.file))
                    .filter(words -> !words.isEmpty()).collect(Collectors.joining(" "));
        }

        static Set<String> names() {
            return Stream.of(values()).map(output -> output.file).collect(Collectors.toSet());
        }
    }

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
        for (Output output : Output.values()) {
            Files.writeString(to.resolve(output.file), OLD);
        }
    }

    private static void assertOld(Path in) {
        assertAll(Stream.of(Output.values()).map(output -> () -> assertArrayEquals(OLD.getBytes(),
                Files.readAllBytes(in.resolve(output.file)), output.file)));
    }

    /** Whether an output is the new one, which must be whole then. */
    private boolean isNew(Output output) throws IOException {
        Path file = outputs.resolve(output.file);
        if (Arrays.equals(OLD.getBytes(), Files.readAllBytes(file))) {
            return false;
        }
        output.reader.read(file);
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

    /**
     * Killed after the first change of the directory, then after more and more, until a render comes to its end. The
     * first changes only try whether the outputs can be written. On a busy machine changes are seen late, so that kills
     * may miss the moments between two outputs: then there is another row of kills.
     */
    @Test
    void killedRender_leavesEveryFileOldOrNew_andTheNextOneClearsUp() throws Exception {
        Set<Output> everOld = EnumSet.noneOf(Output.class);
        Set<Output> everNew = EnumSet.noneOf(Output.class);
        int half = Output.values().length / 2;
        for (int row = 0; row < ROWS && everNew.size() < half; row++) {
            for (int changes = 1; killed(changes); changes = Math.max(SECOND, changes + STEP)) {
                for (Output output : Output.values()) {
                    (isNew(output) ? everNew : everOld).add(output);
                }
            }
        }
        assertEquals(EnumSet.allOf(Output.class), everOld);
        assertTrue(everNew.size() >= half, "written before a kill: " + everNew);
        assertEquals(Output.names(), names(outputs));
        for (Output output : Output.values()) {
            assertTrue(isNew(output), output.file);
        }
    }

    /** Starts a render over the old files and kills it after some changes; returns false where it ends before. */
    private boolean killed(int changes) throws Exception {
        writeOld(outputs);
        List<String> command = Program.command(QUICK + Output.all("outputs"));
        command.add(1, "-XX:TieredStopAtLevel=1"); // so short a render is quicker so
        DirectoryChanges watched = new DirectoryChanges(outputs);
        Process render = program.start(command);
        boolean killed = watched.killAfter(changes, render);
        assertTrue(killed || render.exitValue() == ExitCode.DONE, Program.rest(render));
        return killed;
    }

    @Test
    void filesOfKilledRenders_areTakenAway_butNotThoseOfLiveOnes() throws Exception {
        Path dead = outputs.resolve(".radiosity-1-0.part");
        Files.writeString(dead, "half");
        Files.writeString(Files.createDirectory(outputs.resolve(".radiosity-1-0.part.d")).resolve("foobar.scene"), "");
        Path others = Files.writeString(outputs.resolve(".radiosity.notes"), "of somebody else");
        try (LockedFile live = LockedFile.create(outputs.toRealPath(), "part")) {
            assertEquals(ExitCode.DONE, ended("-q -pa 20000 -it 5 foobar.lws outputs/foobar.scene"));
            assertEquals(Set.of("foobar.scene", others.getFileName().toString(), live.path().getFileName().toString()),
                    names(outputs));
        }
    }

    @Test
    void fullDisk_keepsEveryOldFile_andEachOneIsNamed() throws Exception {
        String script = mounted() + "cat /dev/zero >full/filler 2>/dev/null; \"$@\" >printed 2>&1; code=$?;"
                + " rm full/filler; cp -a full/. outputs; exit $code";
        assertEquals(ExitCode.FILE, inNamespace(script, QUICK + Output.all("full")));
        assertOld(outputs);
        assertEquals(Output.names(), names(outputs));
        String printed = Files.readString(program.file("printed"));
        for (String name : Output.names()) {
            String named = name.equals(Output.LIGHTMAP.file) ? Output.MODEL.file : name;
            String kept = name.equals(Output.SCENE.file) ? "; nothing was kept" : "";
            assertTrue(printed.contains("full/" + named + ": expected to be written, got No space left on device"
                    + kept + "\n"), printed);
        }
    }

    /** The scene file needs more space than the journal, so that there is enough for the journal only. */
    @Test
    void almostFullDisk_keepsTheJournal_fromWhichTheSameCommandGoesOn() throws Exception {
        String script = mounted() + "rm full/*; cat /dev/zero >full/filler 2>/dev/null; truncate -s -%d full/filler;"
                + " \"$@\" >printed 2>&1; code=$?; rm full/filler; \"$@\" >again 2>&1; exit $code";
        String command = "-q -pa 20000 -it 5 foobar.lws ";
        assertEquals(ExitCode.DONE, ended(command + "outputs/foobar.scene"));
        long most = Files.size(outputs.resolve("foobar.scene")) / 4096 * 4096;
        assertEquals(ExitCode.FILE, inNamespace(script.formatted(most), command + "full/foobar.scene"));
        String printed = Files.readString(program.file("printed"));
        assertTrue(printed.contains("; the same command goes on from full/foobar.scene.journal\n"), printed);
        String again = Files.readString(program.file("again"));
        assertTrue(again.contains("full/foobar.scene.journal: going on after 5 shots"), again);
    }

    /** A read-only one is mounted over it while the render is held up; saving may take as long as it likes. */
    @Test
    void diskThatMayNotBeWrittenAnyMore_keepsEveryOldFile() throws Exception {
        String script = mounted() + "\"$@\" >printed 2>&1 & until grep -q distributing printed; do sleep .05; done;"
                + " kill -STOP $!; mount -t tmpfs -o ro none full; kill -TERM $!; kill -CONT $!; wait $!; code=$?;"
                + " umount full; cp -a full/. outputs; exit $code";
        assertEquals(143, inNamespace(script, RendererWithPatience.command(RendererWithPatience.ENDLESS,
                "--schedule paper -pa 3000 -se 0 --size 40x30 --spacing 100 " + Output.all("full"))));
        assertOld(outputs);
        String printed = Files.readString(program.file("printed"));
        assertTrue(printed.contains("full/foobar.scene: expected to be written, got "), printed);
    }

    @Test
    void directoryThatMayNotBeWritten_isRefusedBeforeAnyWork() throws Exception {
        String script = mounted()
                + "mount -o remount,ro full; \"$@\" >printed 2>&1; code=$?; cp -a full/. outputs; exit $code";
        assertEquals(ExitCode.FILE, inNamespace(script, QUICK + Output.all("full")));
        assertOld(outputs);
        String printed = Files.readString(program.file("printed"));
        assertTrue(printed.matches("full/foobar.scene: expected a (file|directory) that can be written, got .*\n"),
                printed);
    }

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "SNAPSHOT")
    void fileThatMayNotBeWritten_isRefusedBeforeAnyWork(Output output) throws Exception {
        assertEquals(ExitCode.FILE, withReadOnly(output));
        assertOld(outputs);
        assertEquals("full/" + output.file + ": expected a file that can be written, got one that cannot\n",
                Files.readString(program.file("printed")));
    }

    /** Its name depends on the number of shots, so nothing is known of it before. */
    @Test
    void snapshotThatMayNotBeWritten_staysAndIsNamed_andAllElseIsWritten() throws Exception {
        int exitCode = withReadOnly(Output.SNAPSHOT);
        String printed = Files.readString(program.file("printed"));
        assertEquals(ExitCode.DONE, exitCode, printed);
        for (Output output : Output.values()) {
            assertEquals(output != Output.SNAPSHOT, isNew(output), output.file);
        }
        assertTrue(printed.startsWith("full/foobar.scene-5.jpg: expected to be written, got "), printed);
    }

    private int withReadOnly(Output output) throws Exception {
        String file = "full/" + output.file;
        String script = mounted() + MountNamespace.readOnly(file) + "\"$@\" >printed 2>&1; code=$?; umount " + file
                + "; cp -a full/. outputs; exit $code";
        return inNamespace(script, QUICK + Output.all("full"));
    }

    /** Shell commands that make a file system of its own in the directory "full", with the old files. */
    private String mounted() throws IOException {
        writeOld(outputs);
        Files.createDirectory(program.file("full"));
        return MountNamespace.disk("full", "outputs");
    }

    /** Exit code of a script that renders where it says {@code "$@"}. */
    private int inNamespace(String script, String arguments) throws Exception {
        return inNamespace(script, Program.command(arguments));
    }

    private int inNamespace(String script, List<String> command) throws Exception {
        return program.start(MountNamespace.command(script, command)).waitFor();
    }

    @Test
    @EnabledOnOs({OS.LINUX, OS.MAC})
    void linkToNoFileYet_isFollowed() throws Exception {
        Files.createSymbolicLink(program.file("link.scene"), Path.of("outputs/target.scene"));
        assertEquals(ExitCode.DONE, ended("-q -pa 20000 -it 5 foobar.lws link.scene"));
        assertTrue(Files.isSymbolicLink(program.file("link.scene")));
        assertEquals(SHOTS, SavedCalculation.read(outputs.resolve("target.scene")).shots());
    }
}
