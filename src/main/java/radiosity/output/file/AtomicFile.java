package radiosity.output.file;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

/**
 * Writes a file whole or not at all: into a new file in the same directory, forced to the disk, then renamed.
 *
 * <p>Whatever ends the program, its name then stands for the old file or the new one. New files that killed programs
 * left in a directory are deleted when the next file is written there.
 */
public final class AtomicFile {

    /** Extension of the names of files that are being written. */
    private static final String PART = "part";
    /** A chain of more symbolic links counts as a circle, as in Linux. */
    private static final int MOST_LINKS = 40;

    /** Writes the content of a file. */
    public interface Content {
        void writeTo(FileChannel channel) throws IOException;
    }

    private AtomicFile() {
    }

    /**
     * Replaces a file, or creates it if there is none.
     *
     * @throws IOException if there is something else than a regular file, or the content cannot be written
     */
    public static void write(Path file, Content content) throws IOException {
        Path target = target(file);
        if (Files.exists(target) && !Files.isRegularFile(target)) {
            throw new IOException(file + ": expected a file that can be replaced, got something else");
        }
        try (LockedFile fresh = beside(target)) {
            content.writeTo(fresh.channel());
            fresh.channel().force(true);
            Files.move(fresh.path(), target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        }
        syncDirectory(target.getParent());
    }

    /** Replaces a file by a file with the given bytes, or creates it; the bytes are not modified. */
    public static void write(Path file, byte[] bytes) throws IOException {
        write(file, channel -> {
            for (ByteBuffer rest = ByteBuffer.wrap(bytes); rest.hasRemaining();) {
                channel.write(rest);
            }
        });
    }

    /**
     * Creates a new file in the directory of a target; the target's name may be as long as names can be.
     *
     * @param target as {@link #target} returns it
     */
    public static LockedFile beside(Path target) throws IOException {
        LockedFile.sweep(target.getParent(), PART);
        return LockedFile.create(target.getParent(), PART);
    }

    /**
     * The path at which a file is, or will be created. Symbolic links are followed, even to files that do not exist
     * yet.
     *
     * @return a real path, except for its last name if there is no file
     * @throws IOException for a directory that does not exist, and for links that lead to themselves
     */
    public static Path target(Path file) throws IOException {
        Path place = file;
        for (int links = 0; Files.isSymbolicLink(place); links++) {
            if (links == MOST_LINKS) {
                throw new FileSystemException(file.toString(), null, "a circle of symbolic links");
            }
            place = place.resolveSibling(Files.readSymbolicLink(place));
        }
        if (Files.exists(place)) {
            return place.toRealPath();
        }
        Path absolute = place.toAbsolutePath();
        return absolute.getParent().toRealPath().resolve(absolute.getFileName());
    }

    /**
     * Forces a directory to the disk, so that a new name survives a power failure. Windows cannot do so and need not.
     */
    private static void syncDirectory(Path directory) {
        try (FileChannel channel = FileChannel.open(directory, StandardOpenOption.READ)) {
            channel.force(true);
        } catch (IOException notSupported) {
            return;
        }
    }
}
