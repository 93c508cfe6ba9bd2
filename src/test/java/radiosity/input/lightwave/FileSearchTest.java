package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileIndex;
import radiosity.scene.SceneFormatException;
import radiosity.settings.ReadOptions;

/** Objects are found where they lie now, and nothing is found that lies elsewhere. */
class FileSearchTest {

    @TempDir
    Path disk;

    private Path scene;
    private final List<String> told = new ArrayList<>();

    @BeforeEach
    void layOut() throws IOException {
        scene = put("project/Scenes/deep/a.lws", new byte[0]);
        put("project/Objects/Room.lwo", Objects.square());
        put("project/Objects/rooms/kitchen/chair.lwo", Objects.square());
        put("project/Objects/rooms/hall/chair.lwo", Objects.square());
        put("project/Objects/amiga", Objects.square());
        put("project/Scenes/deep/near.lwo", Objects.square());
        put("project/Scenes/deep/text.lwo", Iff.text("no object"));
        put("elsewhere/secret.lwo", Objects.square());
        put("library/LAMP.LWO", Objects.square());
    }

    private Path put(String path, byte[] bytes) throws IOException {
        Path file = disk.resolve(path);
        Files.createDirectories(file.getParent());
        return Files.write(file, bytes);
    }

    private Optional<String> find(String written, ReadOptions options) throws IOException {
        Diagnostics notes = new Diagnostics("a.lws", told::add, false);
        Optional<Path> found = SceneAssembly.search(scene, options, notes).object(written);
        notes.flush();
        return found.map(p -> disk.toAbsolutePath().normalize().relativize(p).toString().replace('\\', '/'));
    }

    @ParameterizedTest
    @CsvSource({
        "near.lwo,                             project/Scenes/deep/near.lwo",
        "NEAR.LWO,                             project/Scenes/deep/near.lwo",
        "near,                                 project/Scenes/deep/near.lwo",
        "../../Objects/Room.lwo,               project/Objects/Room.lwo",
        "Objects/Room.lwo,                     project/Objects/Room.lwo",
        "objects/room.LWO,                     project/Objects/Room.lwo",
        "C:\\NewTek\\Objects\\ROOM.LWO,        project/Objects/Room.lwo",
        "HD1:Lightwave/Objects/room,           project/Objects/Room.lwo",
        "Work:room.lwo,                        project/Objects/Room.lwo",
        "\\\\server\\share\\hall\\chair.lwo,   project/Objects/rooms/hall/chair.lwo",
        "D:/old/kitchen/chair.lwo,             project/Objects/rooms/kitchen/chair.lwo",
        "http://example.org/room.lwo,          project/Objects/Room.lwo",
        "amiga.lwo,                            project/Objects/amiga",
        "F:fra/Objects/Amiga,                  project/Objects/amiga",
        "D:\\OBJ\\ROO~1.LWO,                   project/Objects/Room.lwo"})
    void objectsAreFound_howeverTheirPathsAreWritten(String written, String found) throws IOException {
        assertEquals(Optional.of(found), find(written, ReadOptions.defaults()));
        assertEquals(List.of(), told);
    }

    @ParameterizedTest
    @CsvSource({"secret.lwo", "../../../elsewhere/secret.lwo", "text.lwo", "gone.lwo", ".", "/", "C:", "chair.lwo/x"})
    void filesOutsideOfTheRoots_andThoseThatAreNoObjects_areNotFound(String written) throws IOException {
        assertEquals(Optional.empty(), find(written, ReadOptions.defaults()));
    }

    /** Whatever order a file system lists its files in. */
    @Test
    void crowdedDirectory_isCutByName(@TempDir Path crowd) throws IOException {
        for (int i = 59; i >= 0; i--) {
            Files.createFile(crowd.resolve("file" + (100 + i * 37 % 60)));
        }
        FileIndex index = new FileIndex(List.of(crowd), new Diagnostics("crowd", told::add, false), 20);
        assertEquals(IntStream.range(100, 120).mapToObj(i -> "file" + i).toList(),
                index.names().stream().sorted().toList());
    }

    @Test
    void absolutePathOutside_isNotFound_butInsideItIs() throws IOException {
        assertEquals(Optional.empty(), find(disk.resolve("elsewhere/secret.lwo").toAbsolutePath().toString(),
                ReadOptions.defaults()));
        assertEquals(Optional.of("project/Objects/amiga"), find(disk.resolve("project/Objects/amiga").toAbsolutePath()
                .toString(), ReadOptions.defaults()));
    }

    @Test
    void contentDirectory_isSearchedToo() throws IOException {
        ReadOptions options = ReadOptions.defaults().withContent(List.of(disk.resolve("library")));
        assertEquals(Optional.of("library/LAMP.LWO"), find("Lamps/lamp.lwo", options));
        assertEquals(Optional.empty(), find("Lamps/lamp.lwo", ReadOptions.defaults()));
    }

    @Test
    void map_winsOverEverything() throws IOException {
        put("mapped/rooms/near.lwo", Objects.square());
        ReadOptions options = ReadOptions.defaults().withMap(Map.of("P:\\Projects", disk.resolve("mapped")));
        assertEquals(Optional.of("mapped/rooms/near.lwo"), find("p:/projects/rooms/near.lwo", options));
        assertEquals(Optional.of("project/Scenes/deep/near.lwo"), find("near.lwo", options));
    }

    @Test
    void linksOutOfTheRoots_areNotFollowed() throws IOException {
        try {
            Files.createSymbolicLink(disk.resolve("project/Objects/link.lwo"), disk.resolve("elsewhere/secret.lwo"));
            Files.createSymbolicLink(disk.resolve("project/Objects/folder"), disk.resolve("elsewhere"));
        } catch (UnsupportedOperationException | IOException e) {
            assumeTrue(false, "skipped: this system makes no links");
        }
        assertEquals(Optional.empty(), find("link.lwo", ReadOptions.defaults()));
        assertEquals(Optional.empty(), find("folder/secret.lwo", ReadOptions.defaults()));
    }

    @Test
    void sceneThatIsALink_findsWhatLiesBesideTheLinkAndBesideItself() throws IOException {
        Path link = disk.resolve("project/Objects/rooms/hall/link.lws");
        try {
            Files.createSymbolicLink(link, scene.toAbsolutePath());
        } catch (UnsupportedOperationException | IOException e) {
            assumeTrue(false, "skipped: this system makes no links");
        }
        scene = link;
        assertEquals(Optional.of("project/Objects/rooms/hall/chair.lwo"),
                find("chair.lwo", ReadOptions.defaults()));
        assertEquals(Optional.of("project/Scenes/deep/near.lwo"), find("near.lwo", ReadOptions.defaults()));
    }

    @Test
    void twoThatFitEqually_areToldAndTheFirstTaken() throws IOException {
        assertEquals(Optional.of("project/Objects/rooms/hall/chair.lwo"), find("X:chair.lwo",
                ReadOptions.defaults()));
        assertEquals(1, told.size());
        assertTrue(told.get(0).contains("kitchen"), told.toString());
    }

    @Test
    void contentDirectoryThatIsNone_isTold() throws IOException {
        find("near.lwo", ReadOptions.defaults().withContent(List.of(disk.resolve("nowhere"))));
        assertTrue(told.get(0).contains("nowhere"), told.toString());
    }

    @Test
    void missingObjects_areOneWarningWithACount_andAnErrorUnderStrict() throws IOException {
        String text = "LWSC\n1\nLoadObject near.lwo\nLoadObject gone.lwo\nLoadObject gone2.lwo\n";
        Files.writeString(scene, text);
        LightWaveReader.read(scene, ReadOptions.defaults(), told::add);
        assertEquals(List.of("a.lws, line 4: objects that are not found are left out: gone.lwo, gone2.lwo"
                + " (2 times)"), told);
        ReadOptions strict = ReadOptions.defaults().withStrict(true);
        SceneFormatException error = assertThrows(SceneFormatException.class,
                () -> LightWaveReader.read(scene, strict, told::add));
        assertTrue(error.getMessage().startsWith("a.lws, line 4: expected"), error.getMessage());
    }
}
