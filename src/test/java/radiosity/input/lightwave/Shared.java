package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;

/** Files that lie beside the project and not in it; tests that need them are skipped, visibly, without them. */
final class Shared {

    private static final Path FOLDER = Path.of("..", "shared");

    private Shared() {
    }

    static Path path(String name) {
        Path path = FOLDER.resolve(name);
        assumeTrue(Files.exists(path), "skipped: " + path + " is not there");
        return path;
    }
}
