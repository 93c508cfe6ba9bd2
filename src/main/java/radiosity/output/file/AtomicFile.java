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
 * Writes a file wholly or not at all: into a new file beside it, through to the disk, then renamed onto it.
 *
 * <p>Whatever ends the program, the old file or the new one is there under its name. The new files that killed programs
 * left in a directory are deleted when the next one is written there.
 */
public final class AtomicFile {

    /** End of the names of files that are being written. */
    private static final String PART = "part";
    /** A chain of more symbolic links counts as a circle, as in Linux. */
    private static final int MOST_LINKS = 40;

    /** What writes the content. */
    public interface Content {
        void writeTo(FileChannel channel) throws IOException;
    }

    private AtomicFile() {
    }

    /** Replaces a file, or makes it. */
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

    /** Replaces a file by one with this content, or makes it; the content is not modified. */
    public static void write(Path file, byte[] bytes) throws IOException {
        write(file, channel -> {
            for (ByteBuffer rest = ByteBuffer.wrap(bytes); rest.hasRemaining();) {
                channel.write(rest);
            }
        });
    }

    /**
     * A new file in the directory of a target, whose own name may be as long as names can be.
     *
     * @param target see {@link #target}
     */
    public static LockedFile beside(Path target) throws IOException {
        LockedFile.sweep(target.getParent(), PART);
        return LockedFile.create(target.getParent(), PART);
    }

    /**
     * Where a file is, or will be made: symbolic links are followed, also those to files that do not exist yet.
     *
     * @return a real path, but for its last name where there is no such file
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

    /** So that the new name survives a power failure; Windows knows no such thing and needs none. */
    private static void syncDirectory(Path directory) {
        try (FileChannel channel = FileChannel.open(directory, StandardOpenOption.READ)) {
            channel.force(true);
        } catch (IOException notSupported) {
            return;
        }
    }
}
