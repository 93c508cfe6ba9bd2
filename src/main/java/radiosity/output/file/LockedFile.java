package radiosity.output.file;

import java.io.Closeable;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
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
 * A file with a unique name that one process creates for itself and keeps locked until it closes the file.
 *
 * <p>The lock ends with the process, whatever ends the process. Other processes can thereby distinguish a file in use
 * from a file that a killed process left, and delete the latter. Where the file system has no locks, processes leave
 * the files of others alone.
 */
public final class LockedFile implements Closeable {

    private static final String PREFIX = ".radiosity-";
    private static final Pattern OWNER = Pattern.compile(Pattern.quote(PREFIX) + "(\\d{1,18})-.*");
    /** Added to the file's name to name its {@link #folder}. */
    private static final String FOLDER = ".d";
    /** Position of the locked byte: behind all content, because on Windows no other process can read locked bytes. */
    private static final long LOCKED_BYTE = Long.MAX_VALUE - 1;

    /**
     * Files of this process. The process never opens one of them a second time: under POSIX, closing any descriptor of
     * a file ends all locks that the process has on the file.
     */
    private static final Set<Path> OWN = ConcurrentHashMap.newKeySet();

    private final Path path;
    private final FileChannel channel;

    private LockedFile(Path path, FileChannel channel) {
        this.path = path;
        this.channel = channel;
    }

    /**
     * Creates an empty file and locks it.
     *
     * @param directory of the file; a real path
     * @param kind      extension of the name, of letters, digits and hyphens
     * @throws IOException if the directory does not exist or takes no new files
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
            } finally {
                if (file == null) {
                    OWN.remove(path);
                }
            }
            try {
                lock(file.channel);
            } catch (ClosedByInterruptException e) {
                file.close();
                throw e;
            }
            if (Files.exists(path)) {
                return file;
            }
            file.close(); // another process took the file for abandoned, and deleted it, before it was locked
        }
    }

    private static void lock(FileChannel channel) throws ClosedByInterruptException {
        try {
            channel.lock(LOCKED_BYTE, 1, false);
        } catch (IOException noLocks) {
            if (!channel.isOpen()) { // as the thread is interrupted
                throw new ClosedByInterruptException();
            }
            return; // no other process gets a lock there either, and so none deletes the file
        }
    }

    /**
     * Deletes the files of a kind that killed processes left in a directory.
     *
     * @param directory a real path; a directory that must not be listed counts as empty
     * @param kind      extension of the names
     * @return ids of the processes whose files are in use, this process among them if it has files there
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

    /** Whether a file is locked; a file that is not locked is deleted. */
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
            return false; // the file was deleted meanwhile or belongs to another user, or there are no locks
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

    /** The channel for the file's content, which is closed with the file. */
    public FileChannel channel() {
        return channel;
    }

    /** Creates a directory beside the file, for files only, which is deleted with the file. */
    public Path folder() throws IOException {
        return Files.createDirectory(path.resolveSibling(path.getFileName() + FOLDER));
    }

    /** Deletes the file, if it still has its name, with its folder, and releases the lock. */
    @Override
    public void close() throws IOException {
        try (channel) {
            delete(path);
        } finally {
            OWN.remove(path);
        }
    }
}
