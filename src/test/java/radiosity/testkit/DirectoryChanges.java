package radiosity.testkit;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** What a program changes in a directory: new files, and files of another size; and a kill in the midst of it. */
public final class DirectoryChanges {

    /** Exit code of a process that SIGKILL ended. */
    private static final int KILLED = 128 + 9;
    /** First letters of the names of files that are being written. */
    private static final String TEMPORARY = ".radiosity-";

    private final Path directory;
    private final Map<String, Long> before;
    private final Set<String> changed = new HashSet<>();

    /** Called before the program starts. */
    public DirectoryChanges(Path directory) throws IOException {
        this.directory = directory;
        before = sizes();
    }

    private Map<String, Long> sizes() throws IOException {
        Map<String, Long> sizes = new HashMap<>();
        try (DirectoryStream<Path> files = Files.newDirectoryStream(directory)) {
            for (Path file : files) {
                try {
                    sizes.put(file.getFileName().toString(), Files.size(file));
                } catch (IOException deletedMeanwhile) {
                    continue;
                }
            }
        }
        return sizes;
    }

    /**
     * Kills the program after a number of changes.
     *
     * @return whether it was killed; false where it came to its end before
     */
    public boolean killAfter(int number, Process program) throws IOException, InterruptedException {
        while (program.isAlive() && changed.size() < number) {
            Map<String, Long> now = sizes();
            now.forEach((name, size) -> {
                // files of programs killed before are taken away, which is no change
                if (!size.equals(before.get(name))) {
                    changed.add(name);
                }
            });
            before.keySet().stream().filter(name -> !name.startsWith(TEMPORARY) && !now.containsKey(name))
                    .forEach(changed::add);
        }
        program.toHandle().destroyForcibly(); // leaves the stream of what was printed open
        return program.waitFor() == KILLED;
    }
}
