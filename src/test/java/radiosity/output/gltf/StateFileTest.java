package radiosity.output.gltf;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Vec3;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;

/** A state for which a glTF binary has no room stands in a file beside it; the limit is lowered here. */
class StateFileTest extends WrittenScene {

    private static final int STATE = 300_000;

    /** Bytes of the scene file without a state. */
    private long bare;

    @BeforeEach
    void bare() throws IOException {
        write(Handmade.litRoom(Vec3.ZERO).solution());
        bare = Files.size(file);
    }

    private static Solution with(int seed) {
        Handmade made = Handmade.litRoom(Vec3.ZERO);
        made.state = new byte[STATE];
        new Random(seed).nextBytes(made.state);
        return made.solution();
    }

    private void write(Solution solution, long most) throws IOException {
        SceneFile.write(file, solution, Map.of(), Optional.empty(), TONES, OptionalDouble.empty(), most);
    }

    private SavedState read() throws IOException {
        try (SceneFile scene = SceneFile.open(file)) {
            assertTrue(scene.hasState());
            return scene.state();
        }
    }

    private List<Path> beside() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(path -> !path.equals(file)).toList();
        }
    }

    @Test
    void stateWithoutRoom_standsBesideTheSceneFile() throws IOException {
        write(with(1), bare + STATE);
        assertEquals(1, beside().size());
        assertTrue(beside().get(0).getFileName().toString().matches("a b\\.scene\\.[0-9a-f]{16}\\.state"));
        assertEquals(STATE, Files.size(beside().get(0)));
        assertTrue(Files.size(file) < bare + 1000, "the scene file has no state inside");
        assertEquals(with(1).state(), read());
    }

    @Test
    void stateWithRoom_standsInside() throws IOException {
        write(with(1), bare + STATE + 2000);
        assertEquals(List.of(), beside());
        assertEquals(with(1).state(), read());
    }

    @Test
    void nextSceneFile_takesAwayWhatWasBesideTheOneBefore() throws IOException {
        Path other = folder.resolve("a b.scene.mine.state");
        Files.writeString(other, "not written by this program");
        write(with(1), bare + STATE);
        write(with(2), bare + STATE);
        assertEquals(with(2).state(), read());
        assertEquals(2, beside().size());
        write(with(3));
        assertEquals(with(3).state(), read());
        assertEquals(List.of(other), beside());
    }

    /** As where the program is killed between the state and the scene file. */
    @Test
    void newStateBesideTheOldSceneFile_leavesTheOldOneWhole() throws IOException {
        write(with(1), bare + STATE);
        StateFile.write(file, with(2).state());
        assertEquals(with(1).state(), read());
    }

    @Test
    void missingOrDamagedState_isRefusedInOneLine() throws IOException {
        write(with(1), bare + STATE);
        Path state = beside().get(0);
        byte[] bytes = Files.readAllBytes(state);
        bytes[7] ^= 1;
        Files.write(state, bytes);
        assertRefused(file + ", state: expected SHA-256 ");
        Files.write(state, new byte[5]);
        assertRefused(state + ": expected the " + STATE + " bytes of state of " + file + ", got 5 bytes");
        Files.delete(state);
        assertRefused(file + ", state: expected the file " + state.getFileName() + " beside it, got none");
    }

    private void assertRefused(String line) {
        String message = assertThrows(SceneFormatException.class, this::read).getMessage();
        assertTrue(message.startsWith(line), message);
        assertEquals(1, message.lines().count());
    }

    @Test
    void meshesWithoutRoom_leaveTheOldFilesAsTheyWere() throws IOException {
        write(with(1));
        byte[] before = Files.readAllBytes(file);
        String message = assertThrows(IOException.class, () -> write(with(2), bare - 1)).getMessage();
        assertTrue(message.matches("meshes and textures of \\d+ bytes, which are more than the \\d+ of a glTF binary"),
                message);
        assertArrayEquals(before, Files.readAllBytes(file));
        assertEquals(List.of(), beside());
    }
}
