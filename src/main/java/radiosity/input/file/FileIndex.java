package radiosity.input.file;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableSet;
import java.util.Set;
import java.util.TreeSet;

/**
 * Index of the files below some directories, by their names without case. Directories that are links or whose names
 * begin with a dot are not entered; the number of entries that are examined is limited.
 */
public final class FileIndex {

    private static final int MOST_ENTRIES = 200_000;
    private static final int DEEPEST = 32;

    /** Orders paths by Unicode, independently of the operating system and the file system. */
    private static final Comparator<Path> ORDER = Comparator.comparing(path -> path.toString().replace('\\', '/'));

    private final Map<String, List<Path>> byName = new HashMap<>();
    private final int most;
    private int entries;

    FileIndex(List<Path> roots, Diagnostics notes) {
        this(roots, notes, MOST_ENTRIES);
    }

    /** @param most largest number of directory entries that are examined, in the order of directories and names */
    public FileIndex(List<Path> roots, Diagnostics notes, int most) {
        this.most = most;
        Set<Path> entered = new HashSet<>();
        for (Path root : roots) {
            Deque<Path> ahead = new ArrayDeque<>(List.of(root));
            while (!ahead.isEmpty() && entries < most) {
                Path directory = ahead.removeFirst();
                if (entered.add(directory) && directory.getNameCount() - root.getNameCount() < DEEPEST) {
                    list(directory).forEach(entry -> take(entry, ahead));
                }
            }
        }
        if (entries >= most) {
            notes.note("", "the search for objects ended after " + most + " files");
        }
    }

    /** Entries of a directory, sorted; where there are too many, the first ones by name. */
    private Collection<Path> list(Path directory) {
        NavigableSet<Path> found = new TreeSet<>(ORDER);
        try (DirectoryStream<Path> stream = Files.newDirectoryStream(directory)) {
            for (Path entry : stream) {
                found.add(entry);
                if (found.size() > most - entries) {
                    found.pollLast();
                }
            }
        } catch (IOException | DirectoryIteratorException e) {
            return List.of();
        }
        entries += found.size();
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

    /** Files with a name, without case, in the order of directories. */
    List<Path> named(String name) {
        return byName.getOrDefault(name.toLowerCase(Locale.ROOT), List.of());
    }

    public Collection<String> names() {
        return byName.keySet();
    }
}
