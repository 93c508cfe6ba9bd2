package radiosity.input.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Finds the files that a scene names, on a disk where the files may no longer lie where the scene says.
 *
 * <p>Tries in this order: a directory given for the beginning of the path; the path relative to the scene; the path
 * relative to each content root; the file below the roots whose path has the longest end in common with the path in the
 * scene, without case, and among equals the nearest to the scene; all of this with ".lwo" added or removed; a name
 * shortened to 8.3. Never finds a file that is outside the roots when links are followed.
 */
public final class FileSearch {

    private static final Pattern SHORT_NAME = Pattern.compile("([^~]{1,6})~\\d+(\\.[^.]{0,3})?",
            Pattern.CASE_INSENSITIVE);

    private final Path sceneFolder;
    private final List<Path> roots = new ArrayList<>();
    private final Map<String, Path> map = new HashMap<>();
    private final Predicate<byte[]> isObject;
    private final Diagnostics notes;
    private final Map<String, Optional<Path>> found = new HashMap<>();
    private FileIndex index;

    /**
     * @param scene    the scene's file, whose folder is searched first
     * @param content  further directories to search
     * @param prefixes directories by the beginning of the paths that lie in them
     * @param isObject says by the first 12 bytes of a file whether the file is an object
     */
    public FileSearch(Path scene, List<Path> content, Map<String, Path> prefixes, Predicate<byte[]> isObject,
            Diagnostics notes)
            throws IOException {
        this.isObject = isObject;
        this.notes = notes;
        sceneFolder = scene.toAbsolutePath().getParent().toRealPath();
        roots.add(sceneFolder);
        Path linked = scene.toRealPath().getParent();
        if (!linked.equals(sceneFolder)) {
            roots.add(linked);
        }
        Path above = aboveScenes(sceneFolder);
        if (above != null) {
            roots.add(above);
        }
        for (Path directory : content) {
            addRoot(directory);
        }
        for (Map.Entry<String, Path> entry : prefixes.entrySet()) {
            addRoot(entry.getValue()).ifPresent(p -> map.put(slashes(entry.getKey()), p));
        }
    }

    private Optional<Path> addRoot(Path directory) {
        try {
            Path real = directory.toRealPath();
            if (Files.isDirectory(real)) {
                roots.add(real);
                return Optional.of(real);
            }
        } catch (IOException e) {
            // reported below, whatever the reason
        }
        notes.note("", "a directory of objects cannot be used", directory.toString());
        return Optional.empty();
    }

    /** The directory that contains the folder "Scenes" in which the scene lies; null if there is none. */
    private static Path aboveScenes(Path folder) {
        for (Path p = folder; p != null && p.getFileName() != null; p = p.getParent()) {
            if (p.getFileName().toString().equalsIgnoreCase("scenes")) {
                return p.getParent();
            }
        }
        return null;
    }

    private static String slashes(String path) {
        return path.replace('\\', '/');
    }

    /** The object file for a path in a scene; empty where there is none. */
    public Optional<Path> object(String written) {
        return found.computeIfAbsent("object " + written, w -> search(written, this::isObject));
    }

    /** A file of any other kind (image, materials, bytes) for a path in a scene or object; empty if there is none. */
    public Optional<Path> file(String written) {
        return found.computeIfAbsent("file " + written, w -> search(written, p -> true));
    }

    private Optional<Path> search(String written, Predicate<Path> wanted) {
        String path = slashes(written);
        List<String> parts = parts(path);
        if (parts.isEmpty()) {
            return Optional.empty();
        }
        return mapped(path, wanted)
                .or(() -> asWritten(path, wanted))
                .or(() -> bySuffix(parts, wanted))
                .or(() -> otherEnding(path, parts, wanted))
                .or(() -> byShortName(parts, wanted));
    }

    /** The names in a path without drive, volume, "." and "..". */
    private static List<String> parts(String path) {
        String plain = path.substring(path.lastIndexOf(':') + 1);
        List<String> parts = new ArrayList<>();
        for (String part : plain.split("/")) {
            if (!part.isBlank() && !part.equals(".") && !part.equals("..")) {
                parts.add(part.trim());
            }
        }
        return parts;
    }

    private Optional<Path> mapped(String path, Predicate<Path> wanted) {
        String lower = path.toLowerCase(Locale.ROOT);
        return map.keySet().stream().filter(prefix -> beginsWith(lower, prefix.toLowerCase(Locale.ROOT)))
                .sorted(Comparator.comparingInt(String::length).reversed().thenComparing(Comparator.naturalOrder()))
                .map(prefix -> below(map.get(prefix), path.substring(prefix.length()).replaceFirst("^/+", "")))
                .flatMap(Optional::stream).filter(wanted).findFirst();
    }

    /** Whether a path begins with a prefix that ends between two names. */
    private static boolean beginsWith(String path, String prefix) {
        int end = prefix.length();
        return path.startsWith(prefix) && (end == 0 || end == path.length() || path.charAt(end) == '/'
                || prefix.endsWith("/") || prefix.endsWith(":"));
    }

    private Optional<Path> asWritten(String path, Predicate<Path> wanted) {
        if (path.contains(":") || path.startsWith("//")) {
            return Optional.empty();
        }
        return roots.stream().map(root -> below(root, path)).flatMap(Optional::stream).filter(wanted).findFirst();
    }

    /** The regular file at a path relative to a directory, if its real path lies below any of the roots. */
    private Optional<Path> below(Path directory, String path) {
        try {
            return inRoots(directory.resolve(path));
        } catch (InvalidPathException e) {
            return Optional.empty();
        }
    }

    private Optional<Path> inRoots(Path file) {
        try {
            Path real = file.toRealPath();
            boolean allowed = Files.isRegularFile(real) && roots.stream().anyMatch(real::startsWith);
            return allowed ? Optional.of(real) : Optional.empty();
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    private Optional<Path> bySuffix(List<String> parts, Predicate<Path> wanted) {
        List<Path> candidates = index().named(parts.get(parts.size() - 1)).stream().map(this::inRoots)
                .flatMap(Optional::stream).distinct().filter(wanted).toList();
        return best(candidates, Comparator.<Path>comparingInt(p -> -commonSuffix(p, parts))
                .thenComparingInt(this::distance), String.join("/", parts));
    }

    private Optional<Path> best(List<Path> candidates, Comparator<Path> order, String written) {
        List<Path> sorted = candidates.stream().sorted(order.thenComparing(p -> slashes(p.toString()))).toList();
        if (sorted.size() > 1 && order.compare(sorted.get(0), sorted.get(1)) == 0) {
            List<Path> equal = sorted.stream().filter(p -> order.compare(sorted.get(0), p) == 0).toList();
            notes.note("", "files match a path equally well, the first is taken", written + " is " + equal.stream()
                    .map(this::shown).toList());
        }
        return sorted.stream().findFirst();
    }

    private static int commonSuffix(Path file, List<String> parts) {
        int n = 0;
        while (n < parts.size() && n < file.getNameCount() && file.getName(file.getNameCount() - 1 - n).toString()
                .equalsIgnoreCase(parts.get(parts.size() - 1 - n))) {
            n++;
        }
        return n;
    }

    /** Number of steps from the scene's folder to a file's folder; through both roots where their drives differ. */
    private int distance(Path file) {
        Path folder = file.getParent();
        if (!hasSameRoot(folder)) {
            return sceneFolder.getNameCount() + 1 + folder.getNameCount();
        }
        Path way = sceneFolder.relativize(folder);
        return way.toString().isEmpty() ? 0 : way.getNameCount();
    }

    /** Whether a file can have a path relative to the scene, which Windows does not have between drives or shares. */
    private boolean hasSameRoot(Path file) {
        return sceneFolder.getRoot().equals(file.getRoot());
    }

    private Optional<Path> otherEnding(String path, List<String> parts, Predicate<Path> wanted) {
        boolean has = path.toLowerCase(Locale.ROOT).endsWith(".lwo");
        String other = has ? path.substring(0, path.length() - 4) : path + ".lwo";
        List<String> otherParts = parts(other);
        if (otherParts.size() != parts.size()) {
            return Optional.empty();
        }
        return mapped(other, wanted).or(() -> asWritten(other, wanted)).or(() -> bySuffix(otherParts, wanted));
    }

    private Optional<Path> byShortName(List<String> parts, Predicate<Path> wanted) {
        Matcher shortName = SHORT_NAME.matcher(parts.get(parts.size() - 1));
        if (!shortName.matches()) {
            return Optional.empty();
        }
        String start = shortName.group(1).toLowerCase(Locale.ROOT);
        String ending = shortName.group(2) == null ? "" : shortName.group(2).toLowerCase(Locale.ROOT);
        List<Path> candidates = index().names().stream()
                .filter(n -> n.replace(" ", "").startsWith(start) && ending(n).startsWith(ending)).sorted()
                .flatMap(n -> index().named(n).stream()).map(this::inRoots).flatMap(Optional::stream).filter(wanted)
                .toList();
        return best(candidates, Comparator.comparingInt(this::distance), String.join("/", parts));
    }

    private static String ending(String name) {
        int dot = name.lastIndexOf('.');
        return dot < 0 ? "" : name.substring(dot);
    }

    private FileIndex index() {
        if (index == null) {
            index = new FileIndex(roots, notes);
        }
        return index;
    }

    /** Whether a file is an object, by its first bytes; files of Mac attributes (._name) are not read. */
    private boolean isObject(Path file) {
        if (file.getFileName().toString().startsWith("._")) {
            return false;
        }
        try (var in = Files.newInputStream(file)) {
            return isObject.test(in.readNBytes(12));
        } catch (IOException e) {
            return false;
        }
    }

    /** The name of a found file in messages: relative to the scene's folder, or absolute on another drive. */
    public String shown(Path file) {
        return slashes((hasSameRoot(file) ? sceneFolder.relativize(file) : file).toString());
    }
}
