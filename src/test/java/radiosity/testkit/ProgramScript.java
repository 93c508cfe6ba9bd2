package radiosity.testkit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A script as in scripts/ that starts a program as it was compiled for the tests, for commands of documents. */
public final class ProgramScript {

    private ProgramScript() { }

    /** Writes {@code scripts/<name of the program>} in a folder. */
    public static void write(Path folder, Class<?> program) throws IOException {
        write(folder.resolve("scripts").resolve(program.getSimpleName()),
                "'" + Path.of(System.getProperty("java.home"), "bin", "java") + "' -cp '"
                + System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")) + "' "
                + program.getName());
    }

    /** Writes a script that starts a command with the script's arguments after the command's own. */
    public static void write(Path script, String command) throws IOException {
        Files.createDirectories(script.getParent());
        Files.writeString(script, "#!/bin/sh\nexec " + command + " \"$@\"\n");
        if (!script.toFile().setExecutable(true)) {
            throw new IOException(script + ": expected to become executable");
        }
    }
}
