package radiosity.rmi;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Stream;

/** The identity of this program: master and hosts must run the same build, as only that computes the same bits. */
public final class Build {

    private static final int DIGITS = 16;
    private static final String DIGEST = digest();

    private Build() { }

    /** The version in the jar's manifest; ? where there is none. */
    public static String version() {
        String version = Build.class.getPackage().getImplementationVersion();
        return version == null ? "?" : version;
    }

    /** A digest of the program's classes, in hexadecimal. */
    public static String id() {
        return DIGEST;
    }

    private static String digest() {
        try {
            CodeSource source = Build.class.getProtectionDomain().getCodeSource();
            return source == null ? "" : digest(source.getLocation());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String digest(URL location) throws IOException {
        try {
            Path place = Path.of(location.toURI());
            if (Files.isDirectory(place)) {
                return digest(place);
            }
            try (FileSystem jar = FileSystems.newFileSystem(place)) {
                return digest(jar.getPath("/"));
            }
        } catch (URISyntaxException e) {
            throw new IOException(e);
        }
    }

    private static String digest(Path root) throws IOException {
        try (Stream<Path> files = Files.walk(root.resolve("radiosity"))) {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            List<Path> classes = files.filter(f -> f.toString().endsWith(".class"))
                    .sorted(Comparator.comparing(f -> f.toString().replace('\\', '/'))).toList();
            for (Path file : classes) {
                digest.update(Files.readAllBytes(file));
            }
            return HexFormat.of().formatHex(digest.digest()).substring(0, DIGITS);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
