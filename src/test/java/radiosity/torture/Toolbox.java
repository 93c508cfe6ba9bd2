package radiosity.torture;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** What a campaign makes once: a key file, a terminal's program; and small disks, where that can be had. */
final class Toolbox {

    private final Path directory;
    private final Set<String> options;
    private final boolean terminal;

    /** @param options of the program */
    Toolbox(Path directory, Set<String> options) throws IOException, InterruptedException {
        this.directory = directory;
        this.options = options;
        terminal = succeeds("python3", "-c", "import pty");
        try (InputStream in = Toolbox.class.getResourceAsStream("on-terminal.py")) {
            Files.copy(in, directory.resolve("on-terminal.py"), StandardCopyOption.REPLACE_EXISTING);
        }
        succeeds(Path.of(System.getProperty("java.home"), "bin", "keytool").toString(), "-genkeypair", "-keyalg", "EC",
                "-groupname", "secp256r1", "-validity", "3650", "-alias", "radiosity", "-dname", "CN=radiosity",
                "-storetype", "PKCS12", "-storepass", "radiosity", "-keystore", key().toString());
    }

    private static boolean succeeds(String... command) throws InterruptedException {
        try {
            return new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start().waitFor() == 0;
        } catch (IOException absent) {
            return false;
        }
    }

    /** The options of the program's --help. */
    Set<String> options() {
        return options;
    }

    /** A key file, as scripts/make-key makes it. */
    Path key() {
        return directory.resolve("radiosity.key");
    }

    boolean hasTerminal() {
        return terminal;
    }

    /** A command on a terminal of its own, on which a key is pressed after a time. */
    List<String> onTerminal(double seconds, int key, List<String> command) {
        List<String> words = new ArrayList<>(List.of("python3", directory.resolve("on-terminal.py").toString(),
                String.format(Locale.ROOT, "%.3f", seconds), "" + key));
        words.addAll(command);
        return words;
    }

    /** A small disk over an empty directory. */
    static final class Disk implements AutoCloseable {

        private final Path directory;

        private Disk(Path directory) {
            this.directory = directory;
        }

        void enlarge() throws IOException, InterruptedException {
            if (!succeeds("mount", "-o", "remount,size=512m", directory.toString())) {
                throw new IOException(directory + ": expected a disk that can be enlarged, got none");
            }
        }

        @Override
        public void close() throws InterruptedException {
            succeeds("umount", "-l", directory.toString());
        }
    }

    /**
     * Puts a small disk over a directory.
     *
     * @return null where that cannot be had
     */
    Disk disk(Path over, long bytes) throws InterruptedException {
        boolean mounted = succeeds("mount", "-t", "tmpfs", "-o", "size=" + bytes, "tmpfs", over.toString());
        return mounted ? new Disk(over) : null;
    }
}
