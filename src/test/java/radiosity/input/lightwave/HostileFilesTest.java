package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSearch;
import radiosity.scene.SceneFormatException;
import radiosity.settings.ReadOptions;

/** Every kind of broken and hostile input ends in what is sound of it, or in one clear line. */
@Tag("slow")
@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
public class HostileFilesTest {

    @TempDir
    Path folder;

    public static Stream<HostileCase> cases() {
        return Stream.of(HostileObjects.containers(), HostileObjects.points(), HostileObjects.indices(),
                HostileObjects.surfaces(), HostilePolygons.all(), HostileScenes.all()).flatMap(List::stream);
    }

    @ParameterizedTest
    @MethodSource("cases")
    void hostileInput_endsInASceneOrOneLine(HostileCase hostile) throws IOException {
        Path file = hostile.write(folder);
        List<String> told = new ArrayList<>();
        int triangles = HostileCase.ERROR;
        try {
            triangles = LightWaveReader.read(file, ReadOptions.defaults(), told::add).triangles();
        } catch (SceneFormatException e) {
            assertTrue(e.getMessage().matches("(?s).*: expected .*, got .*"), e.getMessage());
            told.add(e.getMessage());
        }
        assertTrue(hostile.triangles() == HostileCase.EITHER || hostile.triangles() == triangles,
                triangles + " triangles, " + told);
        assertTrue(hostile.says().isEmpty() || told.stream().anyMatch(t -> t.contains(hostile.says())),
                told.toString());
        assertTrue(!hostile.says().isEmpty() || hostile.triangles() < 0 || told.isEmpty(), told.toString());
        for (String line : told) {
            assertTrue(line.chars().noneMatch(Character::isISOControl), line);
            assertTrue(line.length() < 1000, line);
            assertTrue(line.contains(".lw"), line);
        }
    }

    @ParameterizedTest
    @MethodSource("soundObjects")
    void objectCutAnywhere_endsInASceneOrOneLine(byte[] sound) throws IOException {
        ReadOptions options = ReadOptions.defaults();
        FileSearch search = SceneAssembly.search(Files.write(folder.resolve("cut.lwo"), sound), options,
                new Diagnostics("cut.lwo", w -> { }, false));
        for (int length = 0; length < sound.length; length++) {
            List<String> told = new ArrayList<>();
            try {
                SceneAssembly.read(Arrays.copyOf(sound, length), "cut.lwo", search, options,
                        new Diagnostics("cut.lwo", told::add, false));
            } catch (SceneFormatException e) {
                told.add(e.getMessage());
            }
            assertEquals(false, told.isEmpty(), "nothing told of a file cut at " + length);
        }
    }

    static Stream<byte[]> soundObjects() {
        return Stream.of(Objects.square(), Objects.lwo2(Objects.lwo2Surface("white", "", Objects.share("DIFF", .5))));
    }
}
