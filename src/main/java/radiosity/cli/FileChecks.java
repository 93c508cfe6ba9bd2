package radiosity.cli;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The files of a command line, looked at before any work: that inputs can be read, that outputs can be written, and
 * that no output would overwrite an input.
 */
final class FileChecks {

    private final List<Path> inputs = new ArrayList<>();
    private final List<Path> outputs = new ArrayList<>();

    /** Fails unless the file can be read. */
    void input(Path file) {
        if (Files.isDirectory(file)) {
            throw Failure.file(file, "expected a file, got a directory", null);
        }
        try (InputStream in = Files.newInputStream(file)) {
            in.read();
        } catch (IOException e) {
            throw Failure.file(file, "expected a readable file, got " + reason(e), e);
        }
        inputs.add(file);
    }

    /** Fails unless the file can be written, or replaced where it exists; leaves it as it is. */
    void output(Path file) {
        if (Files.exists(file) && !(Files.isRegularFile(file) && Files.isWritable(file))) {
            throw Failure.file(file, "expected a file that can be written, got "
                    + (Files.isDirectory(file) ? "a directory" : "one that cannot"), null);
        }
        for (Path input : inputs) {
            if (same(file, input)) {
                throw Failure.commandLine(file.toString(), "expected an output that is no input, got the same file as "
                        + input);
            }
        }
        for (Path other : outputs) {
            if (same(file, other)) {
                throw Failure.commandLine(file.toString(), "expected a file of its own for each output, got one twice");
            }
        }
        refuseLightWave(file);
        tryDirectory(file);
        tryName(file);
        outputs.add(file);
    }

    /** What is overwritten by a slip of the hand: an object of the scene, or another scene. */
    private static void refuseLightWave(Path file) {
        if (!Files.exists(file)) {
            return;
        }
        try (InputStream in = Files.newInputStream(file)) {
            String magic = new String(in.readNBytes(4), StandardCharsets.ISO_8859_1);
            if (magic.equals("FORM") || magic.equals("LWSC")) {
                throw Failure.commandLine(file.toString(), "expected a file to overwrite, got a LightWave file");
            }
        } catch (IOException e) {
            throw Failure.file(file, "expected a readable file, got " + reason(e), e);
        }
    }

    /** An output is written beside its place and then renamed, so its directory must take a new file. */
    private static void tryDirectory(Path file) {
        try {
            Files.delete(Files.createTempFile(directory(file), ".radiosity", ".tmp"));
        } catch (IOException e) {
            throw Failure.file(file, "expected a directory that can be written, got " + reason(e), e);
        }
    }

    /** A name may be too long, or have characters that the file system does not take. */
    private static void tryName(Path file) {
        if (Files.exists(file, LinkOption.NOFOLLOW_LINKS)) {
            return;
        }
        try {
            Files.delete(Files.createFile(file));
        } catch (IOException e) {
            throw Failure.file(file, "expected a name that can be written, got " + reason(e), e);
        }
    }

    private static Path directory(Path file) {
        Path parent = file.toAbsolutePath().getParent();
        return parent == null ? file.toAbsolutePath() : parent;
    }

    private static boolean same(Path a, Path b) {
        try {
            return Files.exists(a) && Files.exists(b) ? Files.isSameFile(a, b) : place(a).equals(place(b));
        } catch (IOException e) {
            return false;
        }
    }

    private static Path place(Path file) throws IOException {
        return directory(file).toRealPath().resolve(file.getFileName());
    }

    /** Why a file cannot be used, without its name. */
    static String reason(IOException e) {
        if (e instanceof NoSuchFileException) {
            return "none";
        }
        String reason = e instanceof FileSystemException problem ? problem.getReason() : e.getMessage();
        return reason == null ? e.getClass().getSimpleName() : reason;
    }
}
