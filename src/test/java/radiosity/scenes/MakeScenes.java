package radiosity.scenes;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;

/**
 * Writes the shipped scenes: {@code mvn -q test-compile}, then {@code java -cp target/test-classes
 * radiosity.scenes.MakeScenes scenes}.
 */
public final class MakeScenes {

    private MakeScenes() {
    }

    /** Writes the files into the folder that the only argument names. */
    public static void main(String[] arguments) throws IOException {
        Path folder = Path.of(arguments[0]);
        for (Map.Entry<String, byte[]> file : files().entrySet()) {
            Path path = folder.resolve(file.getKey());
            Files.createDirectories(path.getParent());
            Files.write(path, file.getValue());
        }
    }

    /** Content of each file by its path below {@code scenes}. */
    static Map<String, byte[]> files() {
        Map<String, byte[]> files = new TreeMap<>();
        files.put("cornell-box.lwo", CornellBox.object());
        files.put("cornell-box.lws", CornellBox.scene(3, false));
        files.put("cornell-box-empty.lws", CornellBox.scene(1, false));
        files.put("cornell-mirror.lwo", CornellBox.mirrors());
        files.put("cornell-mirror.lws", CornellBox.scene(2, true));
        files.putAll(Study.files());
        return files;
    }
}
