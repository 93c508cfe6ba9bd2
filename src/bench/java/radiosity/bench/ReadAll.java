package radiosity.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import radiosity.input.lightwave.HostileCase;
import radiosity.input.lightwave.HostileFilesTest;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.settings.ReadOptions;

/** A program of its own that reads scenes, to see what a virtual machine needs for it. */
public final class ReadAll {

    private ReadAll() {
    }

    /**
     * Reads either all hostile inputs or the files named.
     *
     * @param args a folder to write into, then files
     */
    public static void main(String[] args) throws IOException {
        int triangles = 0;
        if (args.length == 1) {
            for (HostileCase hostile : (Iterable<HostileCase>) HostileFilesTest.cases()::iterator) {
                Path folder = Files.createTempDirectory(Path.of(args[0]), "case");
                triangles += read(hostile.write(folder));
                delete(folder);
            }
        }
        for (String file : List.of(args).subList(1, args.length)) {
            triangles += read(Path.of(file));
        }
        System.out.println(triangles + " triangles");
    }

    private static int read(Path file) throws IOException {
        try {
            Scene scene = LightWaveReader.read(file, ReadOptions.defaults(), w -> { });
            return scene.triangles();
        } catch (SceneFormatException e) {
            return 0;
        }
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            for (Path path : all.sorted(java.util.Comparator.reverseOrder()).toList()) {
                Files.delete(path);
            }
        }
    }
}
