package radiosity.scenes;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MakeScenesTest {

    private static final Path SHIPPED = Path.of("scenes");

    @Test
    void theProgram_writesTheShippedFilesToTheByte(@TempDir Path folder) throws IOException {
        MakeScenes.main(new String[] {folder.toString()});
        Map<String, byte[]> written = lightWaveFiles(folder);
        Map<String, byte[]> shipped = lightWaveFiles(SHIPPED);
        assertEquals(written.keySet(), shipped.keySet());
        written.forEach((name, bytes) -> assertArrayEquals(bytes, shipped.get(name), name));
    }

    private static Map<String, byte[]> lightWaveFiles(Path folder) throws IOException {
        try (Stream<Path> paths = Files.walk(folder)) {
            Set<Path> files = paths.filter(path -> path.toString().matches(".*\\.lw[os]")).collect(Collectors.toSet());
            Map<String, byte[]> contents = new TreeMap<>();
            files.forEach(file -> contents.put(folder.relativize(file).toString(), content(file)));
            return contents;
        }
    }

    private static byte[] content(Path file) {
        try {
            return Files.readAllBytes(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
