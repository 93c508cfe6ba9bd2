package radiosity.output.gltf;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import radiosity.output.image.ToneMapping;
import radiosity.solution.Solution;

/** A test that writes scene files: a folder for them, and one with a space in its name. */
public abstract class WrittenScene {

    static final ToneMapping TONES = new ToneMapping(ToneMapping.Operator.REINHARD, 1);

    @TempDir
    public Path folder;
    public Path file;

    @BeforeEach
    void file() {
        file = folder.resolve("a b.scene");
    }

    public void write(Solution solution) throws IOException {
        SceneFile.write(file, solution, Map.of(), Optional.empty(), TONES);
    }
}
