package radiosity.lightwave;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * The files below some directories by their names without case. Directories that are links and those whose names begin
 * with a dot are not entered; a bounded number of entries is looked at.
 */
final class FileIndex {

    private static final int MOST_ENTRIES = 200_000;
    private static final int DEEPEST = 32;

    private final Map<String, List<Path>> byName = new HashMap<>();
    private int entries;

    FileIndex(List<Path> roots, Notes notes) {
        Set<Path> entered = new HashSet<>();
        for (Path root : roots) {
            Deque<Path> ahead = new ArrayDeque<>(List.of(root));
            while (!ahead.isEmpty() && entries < MOST_ENTRIES) {
                Path directory = ahead.removeFirst();
                if (entered.add(directory) && directory.getNameCount() - root.getNameCount() < DEEPEST) {
                    list(directory).forEach(entry -> take(entry, ahead));
                }
            }
        }
        if (entries >= MOST_ENTRIES) {
            notes.note("", "the search for objects ended after " + MOST_ENTRIES + " files");
        }
    }

    private List<Path> list(Path directory) {
        List<Path> found = new ArrayList<>();
        try (DirectoryStream<Path> stream = Files.newDirectoryStream(directory)) {
            for (Path entry : stream) {
                found.add(entry);
                if (++entries >= MOST_ENTRIES) {
                    break;
                }
            }
        } catch (IOException | DirectoryIteratorException e) {
            return List.of();
        }
        Collections.sort(found);
        return found;
    }

    private void take(Path entry, Deque<Path> ahead) {
        String name = entry.getFileName().toString();
        if (Files.isDirectory(entry, LinkOption.NOFOLLOW_LINKS)) {
            if (!name.startsWith(".")) {
                ahead.addLast(entry);
            }
        } else if (!name.startsWith("._")) {
            byName.computeIfAbsent(name.toLowerCase(Locale.ROOT), n -> new ArrayList<>(1)).add(entry);
        }
    }

    /** Files of a name, in the order of directories. */
    List<Path> named(String name) {
        return byName.getOrDefault(name.toLowerCase(Locale.ROOT), List.of());
    }

    Collection<String> names() {
        return byName.keySet();
    }
}
