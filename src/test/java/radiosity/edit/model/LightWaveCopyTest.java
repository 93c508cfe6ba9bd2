package radiosity.edit.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitOption;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.Radiosity;
import radiosity.edit.Edit;
import radiosity.edit.EditHistory;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;

/** Edits of a LightWave scene come back from the copy in which they were saved. */
class LightWaveCopyTest {

    @TempDir
    Path folder;

    private Path copied(String scene, String... files) throws IOException {
        for (String file : files) {
            Files.createDirectories(folder.resolve(file).getParent());
            Files.copy(Path.of("scenes", file), folder.resolve(file));
        }
        return Files.copy(Path.of("scenes", scene), folder.resolve(scene));
    }

    private Path box() throws IOException {
        return copied("cornell-box.lws", "cornell-box.lwo");
    }

    private static Scene read(Path file) throws IOException {
        return Radiosity.read(file, line -> { });
    }

    private List<Path> save(Path source, EditHistory history) throws IOException {
        return ModelCopy.write(source, ReadOptions.defaults(), history.original(), history.scene(),
                folder.resolve("copy.lws"));
    }

    private static void assertSame(Scene expected, Scene got, double size) {
        assertEquals(expected.triangles(), got.triangles());
        for (int i = 0; i < 3 * got.triangles(); i++) {
            Vec3 p = got.corner(i / 3, i % 3);
            assertTrue(p.minus(expected.corner(i / 3, i % 3)).length() < 1e-9 * size, "corner " + i + " at " + p);
        }
        for (int s = 0; s < got.surfaces().size(); s++) {
            assertEquals(expected.surfaces().get(s).reflectance(), got.surfaces().get(s).reflectance());
            assertEquals(expected.surfaces().get(s).exitance(), got.surfaces().get(s).exitance());
        }
    }

    private static int differences(Path a, Path b) throws IOException {
        List<String> before = Files.readAllLines(a, StandardCharsets.ISO_8859_1);
        List<String> after = Files.readAllLines(b, StandardCharsets.ISO_8859_1);
        assertEquals(before.size(), after.size());
        return (int) IntStream.range(0, before.size()).filter(i -> !before.get(i).equals(after.get(i))).count();
    }

    @Test
    void movedAndTurnedBlock_comesBackInThreeLines() throws IOException {
        Path source = box();
        EditHistory history = new EditHistory(read(source));
        history.add(new Edit.Moved(1, new Vec3(370, 0, -350), 0.3, new Vec3(-60, 0, 40)));
        assertEquals(List.of(folder.resolve("copy.lws")), save(source, history));
        assertSame(history.scene(), read(folder.resolve("copy.lws")), 550);
        assertEquals(3, differences(source, folder.resolve("copy.lws")), "x, z and heading");
    }

    @Test
    void paintedWall_isInACopyOfItsObject() throws IOException {
        Path source = box();
        EditHistory history = new EditHistory(read(source));
        int green = IntStream.range(0, 4).filter(s -> history.original().surfaces().get(s).name().equals("green"))
                .findFirst().orElseThrow();
        history.add(new Edit.Painted(green, new Rgb(.3, .5, .6)));
        List<Path> written = save(source, history);
        assertEquals(List.of(folder.resolve("cornell-box-copy.lwo"), folder.resolve("copy.lws")), written);
        assertSame(history.scene(), read(folder.resolve("copy.lws")), 550);
        assertEquals(3, differences(source, folder.resolve("copy.lws")), "an object per line");
        byte[] before = Files.readAllBytes(folder.resolve("cornell-box.lwo"));
        byte[] after = Files.readAllBytes(folder.resolve("cornell-box-copy.lwo"));
        assertEquals(before.length, after.length);
        long others = IntStream.range(0, before.length).filter(i -> before[i] != after[i]).count();
        assertTrue(others <= 16, "three colours and a share, each of 4 bytes: " + others);
    }

    /** A sofa with what belongs to it, of that a pillow, and a chair. */
    @Test
    void objectsOfTheStudy_comeBack() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("scenes/study"), FileVisitOption.FOLLOW_LINKS)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Path to = folder.resolve(Path.of("scenes").relativize(file));
                Files.createDirectories(to.getParent());
                Files.copy(file, to);
            }
        }
        Path source = copied("study.lws");
        EditHistory history = new EditHistory(read(source));
        List<String> names = history.original().hierarchy().nodes().stream().map(n -> n.name()).toList();
        history.add(new Edit.Moved(names.indexOf("sofa"), new Vec3(1, 0, -1), -0.4, new Vec3(.2, 0, -.1)));
        history.add(new Edit.Moved(names.indexOf("pillow-teal"), Vec3.ZERO, 0, new Vec3(0, .3, 0)));
        history.add(new Edit.Moved(names.indexOf("chair"), new Vec3(2, 0, -2), 1, new Vec3(-.1, 0, .3)));
        save(source, history);
        assertSame(history.scene(), read(folder.resolve("copy.lws")), 10);
    }

    @Test
    void lampThatIsPainted_isRefusedAndLeavesNothing() throws IOException {
        Path source = box();
        EditHistory history = new EditHistory(read(source));
        int light = IntStream.range(0, 4).filter(s -> history.original().surfaces().get(s).emits()).findFirst()
                .orElseThrow();
        history.add(new Edit.Painted(light, new Rgb(.3, .5, .6)));
        SceneFormatException refused = assertThrows(SceneFormatException.class, () -> save(source, history));
        assertTrue(refused.getMessage().contains("light"), refused.getMessage());
        assertFalse(Files.exists(folder.resolve("copy.lws")));
    }

    /** As LightWave wrote numbers on computers whose language has decimal commas; the reader reads them. */
    @Test
    void decimalCommas_areReadAndWritten() throws IOException {
        Path source = box();
        Files.writeString(source, Files.readString(source).replaceAll("(Key -?\\d+)(\\.\\d+)? ", "$1,5 "));
        EditHistory history = new EditHistory(read(source));
        history.add(new Edit.Moved(1, Vec3.ZERO, 0, new Vec3(-60, 0, 40)));
        save(source, history);
        assertSame(history.scene(), read(folder.resolve("copy.lws")), 550);
        assertEquals(2, differences(source, folder.resolve("copy.lws")), "x and z");
        assertFalse(Files.readString(folder.resolve("copy.lws")).matches("(?s).*Key \\S*\\d\\.\\d.*"));
    }

    /** LWSC 1, as the paper's scenes are: all channels of a key in a line, angles in degrees. */
    @Test
    void oldScene_comesBack() throws IOException {
        Files.copy(Path.of("scenes/cornell-box.lwo"), folder.resolve("cornell-box.lwo"));
        Path source = Files.writeString(folder.resolve("old.lws"), "LWSC\r\n1\r\n\r\nLoadObject cornell-box.lwo\r\n"
                + "ObjectMotion (unnamed)\r\n  9\r\n  1\r\n  1 2 3 40 5 6 1 1 1\r\n  0 0 0 0 0\r\n"
                + "EndBehavior 1\r\n");
        EditHistory history = new EditHistory(read(source));
        history.add(new Edit.Moved(0, new Vec3(1, 1, 1), 0.5, new Vec3(-6, 1, 4)));
        save(source, history);
        assertSame(history.scene(), read(folder.resolve("copy.lws")), 550);
        assertEquals(1, differences(source, folder.resolve("copy.lws")));
    }
}
