package radiosity.cli.render;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import radiosity.cli.options.ErrorReport;
import radiosity.cli.options.Failure;
import radiosity.output.file.AtomicFile;
import radiosity.output.file.LockedFile;
import radiosity.rmi.HostKey;

/**
 * The files of a command line, looked at before any work: that inputs can be read, that outputs can be written, and
 * that no output would overwrite an input, another output, or a file that the program writes besides.
 */
public final class FileChecks {

    /** Of formats that do not tell by their first bytes. */
    private static final Pattern OBJECTS = Pattern.compile("(?i).*\\.(obj|mtl)");

    private final List<Path> inputs = new ArrayList<>();
    private final List<Path> outputs = new ArrayList<>();
    /** Files that the program writes besides, each with what it is. */
    private final Map<Path, String> reserved = new LinkedHashMap<>();
    /** Pictures of {@code -sn} are called as this and their number; null without. */
    private Path snapshots;

    /** Fails unless the file can be read. */
    public void input(Path file) {
        if (Files.isDirectory(file)) {
            throw Failure.file(file, "expected a file, got a directory", null);
        }
        try (InputStream in = Files.newInputStream(file)) {
            in.read();
        } catch (IOException e) {
            throw Failure.file(file, "expected a readable file, got " + ErrorReport.reason(e), e);
        }
        inputs.add(file);
    }

    /** Fails where a file that the scene is made of, like an image, would be overwritten by what is known by now. */
    public void partOfScene(Path file) {
        inputs.add(file);
        outputs.forEach(this::refuseInputs);
        reserved.keySet().forEach(this::refuseInputs);
        refuseSnapshots(file);
    }

    /**
     * Keeps a name for a file that the program writes without being asked to. Fails where that would overwrite an
     * input.
     *
     * @param what it is, with its article
     */
    public void reserve(Path file, String what) {
        refuseInputs(file);
        reserved.put(file, what);
    }

    /** Keeps the names of the pictures of {@code -sn}. */
    public void reserveSnapshots(Path scene) {
        snapshots = scene;
    }

    /** Fails unless the file can be written, or replaced where it exists; leaves it as it is. */
    public void output(Path file) {
        if (Files.exists(file) && !(Files.isRegularFile(file) && Files.isWritable(file))) {
            throw Failure.file(file, "expected a file that can be written, got "
                    + (Files.isDirectory(file) ? "a directory" : "one that cannot"), null);
        }
        refuseInputs(file);
        for (Path other : outputs) {
            if (same(file, other)) {
                throw Failure.commandLine(file.toString(), "expected a file of its own for each output, got one twice");
            }
        }
        reserved.forEach((other, what) -> {
            if (same(file, other)) {
                throw Failure.commandLine(file.toString(), "expected a file of its own for each output, got " + what);
            }
        });
        refuseSnapshots(file);
        refuseModels(file);
        tryPlace(file);
        outputs.add(file);
    }

    private void refuseInputs(Path file) {
        for (Path input : inputs) {
            if (same(file, input)) {
                throw Failure.commandLine(file.toString(), "expected an output that is no input, got the same file as "
                        + input);
            }
        }
    }

    private void refuseSnapshots(Path file) {
        if (snapshots == null) {
            return;
        }
        Matcher name = Pattern.compile("(.*)-[1-9]\\d*\\.jpg").matcher(String.valueOf(file.getFileName()));
        if (name.matches() && same(file.resolveSibling(name.group(1)), snapshots)) {
            throw Failure.commandLine(file.toString(),
                    "expected a file of its own for each output, got a snapshot (-sn) of "
                    + snapshots);
        }
    }

    /** What is overwritten by a slip of the hand: an object of the scene, its materials, or another scene. */
    private static void refuseModels(Path file) {
        if (!Files.exists(file)) {
            return;
        }
        if (OBJECTS.matcher(String.valueOf(file.getFileName())).matches()) {
            throw Failure.commandLine(file.toString(), "expected a file to overwrite, got an object or its materials");
        }
        try (InputStream in = Files.newInputStream(file)) {
            String magic = new String(in.readNBytes(4), StandardCharsets.ISO_8859_1);
            if (magic.equals("FORM") || magic.equals("LWSC")) {
                throw Failure.commandLine(file.toString(), "expected a file to overwrite, got a LightWave file");
            }
        } catch (IOException e) {
            throw Failure.file(file, "expected a readable file, got " + ErrorReport.reason(e), e);
        }
    }

    /**
     * An output is written beside its place and then renamed, so its directory must take a new file, and the file
     * system its name: that may be too long, or have characters that are not allowed. The name is tried in a directory
     * apart, where another program cannot have put a file of that name meanwhile.
     */
    private static void tryPlace(Path file) {
        try {
            Path target = AtomicFile.target(file);
            try (LockedFile probe = AtomicFile.beside(target)) {
                tryName(file, probe.folder().resolve(target.getFileName()));
            }
        } catch (IOException e) {
            throw Failure.file(file, "expected a directory that can be written, got " + ErrorReport.reason(e), e);
        }
    }

    private static void tryName(Path file, Path elsewhere) {
        try {
            Files.delete(Files.createFile(elsewhere));
        } catch (IOException e) {
            throw Failure.file(file, "expected a name that can be written, got " + ErrorReport.reason(e), e);
        }
    }

    private static boolean same(Path a, Path b) {
        try {
            return Files.exists(a) && Files.exists(b) ? Files.isSameFile(a, b)
                    : AtomicFile.target(a).equals(AtomicFile.target(b));
        } catch (IOException e) {
            return false; // one of them can be neither read nor written, which is found where that is tried
        }
    }

    /** Reads a key file that is there. */
    public static HostKey key(Path file) throws IOException {
        new FileChecks().input(file);
        return HostKey.read(file);
    }
}
