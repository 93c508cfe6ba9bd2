package radiosity.input.obj;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSearch;
import radiosity.scene.SceneFormatException;
import radiosity.settings.ReadOptions;
import radiosity.testkit.Mutation;

/** Mutants of sound files end in a scene or in the one exception; nothing else is thrown and nothing hangs. */
@Tag("slow")
@Timeout(value = 120, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class ObjFuzzTest {

    private static final int MUTANTS = 4000;
    private static final String ROOM = """
            mtllib m.mtl
            o room
            v 0 0 0
            v 2 0 0
            v 2 1 0
            v 1 1 0
            v 1 2 0
            v 0 2 0
            vt 0 0
            vt 1 0
            vt 1 1
            usemtl wood
            f 1/1 2/2 3/3 4/1 5/2 6/3
            g part
            usemtl glow
            f -1/-1/1 -2/-2/1 -3//
            """;
    private static final String LIBRARY = """
            newmtl wood
            Kd .5 .6 .7
            map_Kd -s 2 3 1 -o .5 0 -clamp on wood.png
            newmtl glow
            Kd 0
            Ke 1e3 2 3
            d .5
            """;

    @TempDir
    Path folder;

    @Test
    void mutants_endInASceneOrTheOneException() throws IOException {
        Path place = Files.writeString(folder.resolve("a.obj"), ROOM);
        Files.writeString(folder.resolve("wood.png"), "");
        ReadOptions options = ReadOptions.defaults().withMaxTriangles(1_000_000);
        FileSearch search = new FileSearch(place, List.of(), options.map(), start -> false,
                new Diagnostics("a.obj", w -> { }, false));
        Random random = new Random(5);
        for (int i = 0; i < MUTANTS; i++) {
            Files.write(folder.resolve("m.mtl"), mutant(LIBRARY, i % 2 == 0, random));
            List<String> told = new ArrayList<>();
            try {
                ObjReader.read(mutant(ROOM, i % 2 == 1, random), "a.obj", search, options,
                        new Diagnostics("a.obj", told::add, false));
            } catch (SceneFormatException e) {
                told.add(e.getMessage());
            }
            assertTrue(told.stream().allMatch(line -> line.chars().noneMatch(Character::isISOControl)));
        }
    }

    private static byte[] mutant(String sound, boolean changed, Random random) {
        byte[] bytes = sound.getBytes(StandardCharsets.UTF_8);
        return changed ? Mutation.of(bytes, random) : bytes;
    }
}
