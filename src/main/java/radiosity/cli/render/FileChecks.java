package radiosity.cli.render;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
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
 * Checks the files of a command line before any work: inputs must be readable, outputs must be writable, and no output
 * may overwrite an input, another output, or a file that the program writes without being asked to.
 */
public final class FileChecks {

    /** Names of OBJ files, material libraries, glTF buffers and luminaires, which their first bytes do not tell. */
    private static final Pattern OBJECTS = Pattern.compile("(?i).*\\.(obj|mtl|bin|ies|ldt)");

    private final List<Path> inputs = new ArrayList<>();
    /** Files that the program writes; the values end the message that refuses another output with that name. */
    private final Map<Path, String> taken = new LinkedHashMap<>();
    /** Scene file whose name, with a number, the pictures of {@code -sn} get; null without {@code -sn}. */
    private Path snapshots;

    /** Adds an input; fails unless the file can be read. */
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

    /** Adds a file that the scene refers to, like an image; fails where an output added so far would overwrite it. */
    public void partOfScene(Path file) {
        inputs.add(file);
        taken.keySet().forEach(output -> refuse(output, file));
        refuseSnapshots(file);
    }

    /**
     * Reserves a name for a file that the program writes without being asked to; fails where an input has this name.
     *
     * @param what description of the file for messages, with its article
     */
    public void reserve(Path file, String what) {
        refuseInputs(file);
        taken.put(file, what);
    }

    /** Reserves the names of the pictures of {@code -sn}, which derive from the name of the scene file. */
    public void reserveSnapshots(Path scene) {
        snapshots = scene;
    }

    /** Adds an output; fails unless the file can be created or replaced. An existing file is left unchanged. */
    public void output(Path file) {
        if (Files.exists(file) && !(Files.isRegularFile(file) && Files.isWritable(file))) {
            throw Failure.file(file, "expected a file that can be written, got "
                    + (Files.isDirectory(file) ? "a directory" : "one that cannot"), null);
        }
        refuseInputs(file);
        taken.forEach((other, what) -> {
            if (same(file, other)) {
                throw Failure.commandLine(file.toString(), "expected a file of its own for each output, got " + what);
            }
        });
        refuseSnapshots(file);
        refuseModels(file);
        tryPlace(file);
        taken.put(file, "one twice");
    }

    private void refuseInputs(Path file) {
        inputs.forEach(input -> refuse(file, input));
    }

    private static void refuse(Path output, Path input) {
        if (same(output, input)) {
            throw Failure.commandLine(output.toString(), "expected an output that is no input, got the same file as "
                    + input);
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

    /** Fails for an existing file that may be a model or a part of one: naming one as an output is a slip. */
    private static void refuseModels(Path file) {
        if (!Files.exists(file)) {
            return;
        }
        if (OBJECTS.matcher(String.valueOf(file.getFileName())).matches()) {
            throw Failure.commandLine(file.toString(), "expected a file to overwrite, got a part of a model");
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
     * Fails unless the directory takes a new file and the file system takes the file's name, which may be too long or
     * have forbidden characters. (An output is written under a temporary name in its directory and then renamed.) The
     * name is tried in a separate new directory, where no other program can have created a file with that name.
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
            return false; // the check of the path that cannot be resolved reports the error
        }
    }

    /** Reads a key file; fails unless the file can be read. */
    public static HostKey key(Path file) throws IOException {
        new FileChecks().input(file);
        return HostKey.read(file);
    }
}
