package radiosity.cli.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.output.gltf.Handmade;
import radiosity.output.gltf.SceneFile;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.StopRule;
import radiosity.solution.SavedState;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.testkit.ColouredRoom;

/**
 * A state may take most of the memory: it is written without a copy of it, and read into one copy when it is needed.
 * Held by the number of bytes that a thread allocates.
 */
class StateCopiesTest {

    private static final int SIZE = 32 << 20;
    /** Bytes for all but the state: buffers, the scene. */
    private static final int REST = SIZE / 4;

    @TempDir
    Path directory;

    private interface Action {
        void run() throws IOException;
    }

    /** Bytes of the heap that this thread allocates meanwhile. */
    private static long allocated(Action action) throws IOException {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadAllocatedBytes();
        action.run();
        return threads.getCurrentThreadAllocatedBytes() - before;
    }

    private static void assertAllocated(long most, Action action) throws IOException {
        long got = allocated(action);
        assertTrue(got <= most, got + " bytes for a state of " + SIZE);
    }

    @Test
    void journal_isWrittenWithoutACopy_andReadIntoOne() throws IOException {
        RadiositySettings settings = RadiositySettings.defaults();
        SavedState state = SavedState.of(List.of(new byte[SIZE / 2], new byte[SIZE / 2]));
        List<String> notices = new ArrayList<>();
        try (JournalClaim claim = JournalClaim.of(directory.resolve("foobar.scene.journal"))) {
            Journal journal = new Journal(claim, settings.toString(), notices::add, () -> 0);
            assertAllocated(REST, () -> journal.keepNow(() -> state));
            assertTrue(Files.size(claim.journal()) > SIZE);
            assertEquals(List.of(), notices);

            ProgressiveRadiosity another = new ProgressiveRadiosity(new LocalWorld(ColouredRoom.SCENE, settings, 1),
                    new StopRule(1, 0));
            assertAllocated(SIZE + REST, () -> assertFalse(journal.resume(another)));
            assertEquals(1, notices.size(), "of a state that is only zeros: " + notices);
        }
    }

    @Test
    void sceneFile_isWrittenWithoutACopy_andReadIntoOneWhenTheStateIsNeeded() throws IOException {
        Path file = directory.resolve("foobar.scene");
        write(file, Handmade.litRoom(Vec3.ZERO)); // what is only made once is made here
        Handmade made = Handmade.litRoom(Vec3.ZERO);
        made.state = new byte[SIZE];
        assertAllocated(REST, () -> write(file, made));

        List<SavedCalculation> read = new ArrayList<>();
        assertAllocated(REST, () -> read.add(SavedCalculation.read(file)));
        assertAllocated(SIZE + REST, () -> assertEquals(SIZE, read.get(0).state().length()));
    }

    private static void write(Path file, Handmade made) throws IOException {
        Map<String, Object> extras = Map.of("settings", SavedCalculation.asJson(RadiositySettings.defaults()));
        SceneFile.write(file, made.solution(), extras, Optional.empty(),
                new ToneMapping(ToneMapping.Operator.REINHARD, 1));
    }
}
