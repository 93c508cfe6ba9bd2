package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSearch;
import radiosity.scene.SceneFormatException;
import radiosity.settings.ReadOptions;
import radiosity.testkit.Mutation;

/** Mutants of sound files end in a scene or in the one exception; nothing else is thrown and nothing hangs. */
@Tag("slow")
@Timeout(value = 120, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class FuzzTest {

    private static final int MUTANTS = 4000;
    private static final int LARGEST = 60_000;

    @TempDir
    Path folder;

    private final ReadOptions options = ReadOptions.defaults().withMaxTriangles(1_000_000);

    @ParameterizedTest
    @MethodSource("sound")
    void mutantsOfOwnFiles_endInASceneOrTheOneException(byte[] sound, String name) throws IOException {
        Files.write(folder.resolve("room.lwo"), Objects.square());
        mutate(sound, Files.write(folder.resolve(name), sound), MUTANTS, new Random(sound.length));
    }

    static Stream<Arguments> sound() {
        return Stream.of(
                Arguments.of(Objects.square(), "a.lwo"),
                Arguments.of(SoundFiles.texturedLwo2(), "a.lwo"),
                Arguments.of(SoundFiles.lwo3(), "a.lwo"),
                Arguments.of(Iff.text(SoundFiles.scene1()), "a.lws"),
                Arguments.of(Iff.text(SoundFiles.scene5()), "a.lws"));
    }

    @Test
    void mutantsOfRealFiles_endInASceneOrTheOneException() throws IOException {
        List<Path> files;
        try (Stream<Path> all = Files.walk(Shared.path("lightwave"))) {
            files = all.filter(p -> p.toString().toLowerCase(java.util.Locale.ROOT).matches(".*\\.lw[os]"))
                    .filter(p -> p.toFile().length() < LARGEST).sorted().toList();
        }
        assertTrue(files.size() > 50, files.size() + " files");
        Random random = new Random(11);
        for (Path file : files) {
            mutate(Files.readAllBytes(file), file, 40, random);
        }
    }

    /** @param place a file in the folder where objects are searched */
    private void mutate(byte[] sound, Path place, int times, Random random) throws IOException {
        String name = place.getFileName().toString();
        FileSearch search = SceneAssembly.search(place, options, new Diagnostics(name, w -> { }, false));
        for (int i = 0; i < times; i++) {
            List<String> told = new ArrayList<>();
            try {
                SceneAssembly.read(Mutation.of(sound, random), name, search, options,
                        new Diagnostics(name, told::add, false));
            } catch (SceneFormatException e) {
                told.add(e.getMessage());
            }
            for (String line : told) {
                assertTrue(line.chars().noneMatch(Character::isISOControl), line);
            }
        }
    }
}
