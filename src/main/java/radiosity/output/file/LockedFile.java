package radiosity.output.file;

import java.io.Closeable;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadLocalRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A file with a unique name that one process has made for itself and holds locked until it closes it.
 *
 * <p>The lock ends with the process, however that ends. So other processes can tell a file in use from one that a
 * killed process left behind, and delete the latter. Where the file system has no locks, files of others are left
 * alone.
 */
public final class LockedFile implements Closeable {

    private static final String PREFIX = ".radiosity-";
    private static final Pattern OWNER = Pattern.compile(Pattern.quote(PREFIX) + "(\\d{1,18})-.*");
    /** Added to the file's name for {@link #folder}. */
    private static final String FOLDER = ".d";
    /** Position of the byte that is locked: behind all content, since Windows lets nobody else read locked bytes. */
    private static final long LOCKED_BYTE = Long.MAX_VALUE - 1;

    /**
     * Files of this process. It never opens one of them a second time: under POSIX, closing any descriptor of a file
     * ends all locks that the process has on it.
     */
    private static final Set<Path> OWN = ConcurrentHashMap.newKeySet();

    private final Path path;
    private final FileChannel channel;

    private LockedFile(Path path, FileChannel channel) {
        this.path = path;
        this.channel = channel;
    }

    /**
     * Makes a file, empty and locked.
     *
     * @param directory of it; a real path
     * @param kind      end of its name, of letters, digits and hyphens
     * @throws IOException where the directory does not exist or takes no new files
     */
    public static LockedFile create(Path directory, String kind) throws IOException {
        while (true) {
            Path path = directory.resolve(PREFIX + ProcessHandle.current().pid() + "-"
                    + Long.toHexString(ThreadLocalRandom.current().nextLong()) + "." + kind);
            OWN.add(path);
            LockedFile file = null;
            try {
                FileChannel channel = FileChannel.open(path, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
                file = new LockedFile(path, channel);
                lock(channel);
            } finally {
                if (file == null) {
                    OWN.remove(path);
                }
            }
            if (Files.exists(path)) {
                return file;
            }
            file.close(); // another process took it for abandoned before it was locked
        }
    }

    private static void lock(FileChannel channel) {
        try {
            channel.lock(LOCKED_BYTE, 1, false);
        } catch (IOException noLocks) {
            return; // nobody else gets a lock there either, and so nobody deletes the file
        }
    }

    /**
     * Deletes the files of a kind that processes left in a directory when they were killed.
     *
     * @param directory a real path; one that must not be listed counts as empty
     * @param kind      end of the names
     * @return process numbers of the owners of those that are in use, this process among them
     */
    public static List<Long> sweep(Path directory, String kind) throws IOException {
        List<Long> owners = new ArrayList<>();
        try (DirectoryStream<Path> files = Files.newDirectoryStream(directory, PREFIX + "*." + kind)) {
            for (Path file : files) {
                Matcher owner = OWNER.matcher(file.getFileName().toString());
                if (owner.matches() && isInUse(file)) {
                    owners.add(Long.parseLong(owner.group(1)));
                }
            }
        } catch (DirectoryIteratorException e) {
            throw e.getCause();
        } catch (AccessDeniedException notListed) {
            return owners;
        }
        return owners;
    }

    /** Whether a file is locked; deletes it where it is not. */
    private static boolean isInUse(Path file) {
        if (OWN.contains(file)) {
            return true;
        }
        if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
            return false;
        }
        try (FileChannel other = FileChannel.open(file, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS)) {
            FileLock lock = other.tryLock(LOCKED_BYTE, 1, false);
            if (lock != null) {
                delete(file);
            }
            return lock == null;
        } catch (IOException e) {
            return false; // deleted meanwhile, of another user, or without locks: nothing is known of it
        }
    }

    private static void delete(Path file) throws IOException {
        Path folder = file.resolveSibling(file.getFileName() + FOLDER);
        if (Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
            try (DirectoryStream<Path> content = Files.newDirectoryStream(folder)) {
                for (Path child : content) {
                    Files.deleteIfExists(child);
                }
            }
            Files.deleteIfExists(folder);
        }
        Files.deleteIfExists(file);
    }

    public Path path() {
        return path;
    }

    /** For its content; closed with the file. */
    public FileChannel channel() {
        return channel;
    }

    /** Makes a directory beside the file, which is deleted with it. It may hold files, but no directories. */
    public Path folder() throws IOException {
        return Files.createDirectory(path.resolveSibling(path.getFileName() + FOLDER));
    }

    /** Deletes the file where it still has its name, and ends the lock. */
    @Override
    public void close() throws IOException {
        try (channel) {
            delete(path);
        } finally {
            OWN.remove(path);
        }
    }
}
