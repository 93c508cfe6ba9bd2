package radiosity.cli;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Map;
import radiosity.output.SceneFile;

/** What {@code --info} prints: what a scene file holds. */
final class SceneInfo {

    private SceneInfo() { }

    static void print(Path file, PrintStream out) throws IOException {
        new FileChecks().input(file);
        try (SceneFile scene = SceneFile.open(file)) {
            for (Map.Entry<String, Object> entry : scene.extras().entrySet()) {
                out.println(entry.getKey() + ": " + entry.getValue());
            }
        }
    }
}
