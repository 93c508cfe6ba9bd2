package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.common.jimfs.Configuration;
import com.google.common.jimfs.Jimfs;
import java.io.IOException;
import java.nio.file.FileSystem;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.input.file.Diagnostics;
import radiosity.scene.Scene;
import radiosity.settings.ReadOptions;

/** A scene on one drive of Windows, its objects on another one and on a share: in memory, on every system. */
class WindowsDrivesTest {

    private FileSystem windows;
    private Path scene;
    private ReadOptions options;
    private final List<String> warnings = new ArrayList<>();

    @BeforeEach
    void layOut() throws IOException {
        windows = Jimfs.newFileSystem(Configuration.windows().toBuilder()
                .setRoots("C:\\", "D:\\", "\\\\server\\share\\").setWorkingDirectory("C:\\work").build());
        scene = put("C:\\project\\Scenes\\a.lws", Iff.text("LWSC\n1\n"));
        put("C:\\project\\Objects\\room.lwo", Objects.square());
        put("C:\\project\\Objects\\lamp.lwo", Objects.square());
        put("D:\\library\\Objects\\chair.lwo", Objects.square());
        put("D:\\library\\Objects\\lamp.lwo", Objects.square());
        put("D:\\library\\Objects\\a\\table.lwo", Objects.square());
        put("D:\\library\\Objects\\a0\\table.lwo", Objects.square());
        put("D:\\library\\Objects\\broken.lwo", java.util.Arrays.copyOf(Objects.square(), 40));
        put("\\\\server\\share\\Objects\\vase.lwo", Objects.square());
        options = ReadOptions.defaults().withContent(List.of(windows.getPath("D:\\library"),
                windows.getPath("\\\\server\\share\\Objects")));
    }

    @AfterEach
    void close() throws IOException {
        windows.close();
    }

    private Path put(String path, byte[] bytes) throws IOException {
        Path file = windows.getPath(path);
        Files.createDirectories(file.getParent());
        return Files.write(file, bytes);
    }

    private Optional<String> find(String written) throws IOException {
        Diagnostics notes = new Diagnostics("a.lws", warnings::add, false);
        Optional<Path> found = SceneAssembly.search(scene, options, notes).object(written);
        notes.flush();
        return found.map(Path::toString);
    }

    @ParameterizedTest
    @CsvSource({
        "Objects/room.lwo,                C:\\project\\Objects\\room.lwo",
        "Objects/chair.lwo,               D:\\library\\Objects\\chair.lwo",
        "D:\\library\\objects\\CHAIR.LWO,  D:\\library\\Objects\\chair.lwo",
        "E:\\gone\\chair.lwo,             D:\\library\\Objects\\chair.lwo",
        "D:\\OBJ\\CHA~1.LWO,              D:\\library\\Objects\\chair.lwo",
        "\\\\server\\share\\vase.lwo,     \\\\server\\share\\Objects\\vase.lwo"})
    void objectsAreFound_onEveryDrive(String written, String found) throws IOException {
        assertEquals(Optional.of(found), find(written));
        assertEquals(List.of(), warnings);
    }

    @Test
    void sameDrive_isNearerThanAnotherOne() throws IOException {
        assertEquals(Optional.of("C:\\project\\Objects\\lamp.lwo"), find("X:\\lamp.lwo"));
        assertEquals(List.of(), warnings);
    }

    /** The same of two as on a system that separates names by a slash, which sorts before digits. */
    @Test
    void equallyGoodFiles_areNamedInFull_andTheFirstIsTakenAsElsewhere() throws IOException {
        assertEquals(Optional.of("D:\\library\\Objects\\a\\table.lwo"), find("X:\\table.lwo"));
        assertTrue(warnings.get(0).contains("D:/library/Objects/a0/table.lwo"), warnings::toString);
    }

    @ParameterizedTest
    @CsvSource({"C:", "D:\\", "nul?.lwo", "a|b.lwo", "'\"chair\".lwo'", "D:chair.lwo:stream"})
    void namesThatWindowsDoesNotTake_areNotFound(String written) throws IOException {
        assertEquals(Optional.empty(), find(written));
    }

    @Test
    void mapToAnotherDrive_isFollowed() throws IOException {
        options = ReadOptions.defaults().withMap(Map.of("P:\\", windows.getPath("D:\\library\\Objects")));
        assertEquals(Optional.of("D:\\library\\Objects\\chair.lwo"), find("p:/chair.lwo"));
    }

    @Test
    void wholeScene_isReadFromTwoDrives_andWarningsNameFilesInFull() throws IOException {
        Files.writeString(scene, "LWSC\n1\nLoadObject D:\\library\\Objects\\chair.lwo\nLoadObject Objects/room.lwo\n"
                + "LoadObject D:\\library\\Objects\\broken.lwo\n");
        Scene read = LightWaveReader.read(scene, options, warnings::add);
        assertEquals(4, read.triangles());
        assertTrue(warnings.stream().anyMatch(line -> line.contains("D:/library/Objects/broken.lwo")),
                warnings::toString);
    }
}
