package radiosity.output;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import radiosity.world.Solution;

/** A test that writes scene files: a folder for them, and one with a space in its name. */
abstract class WrittenScene {

    static final ToneMapping TONES = new ToneMapping(ToneMapping.Operator.REINHARD, 1);

    @TempDir
    Path folder;
    Path file;

    @BeforeEach
    void file() {
        file = folder.resolve("a b.scene");
    }

    void write(Solution solution) throws IOException {
        SceneFile.write(file, solution, Map.of(), Optional.empty(), TONES);
    }
}
