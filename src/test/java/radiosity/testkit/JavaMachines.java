package radiosity.testkit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import java.util.stream.Stream;

/** The Java virtual machines at hand that can run the program. */
public final class JavaMachines {

    /** The oldest that runs the program. */
    private static final int OLDEST = 17;

    private JavaMachines() { }

    /**
     * Homes by feature version: the running machine's own, the oldest and the newest that are found beside it, in the
     * usual places and in environment variables like {@code JAVA_HOME} and {@code JAVA_HOME_25_X64}.
     */
    public static Map<Integer, Path> homes() throws IOException {
        TreeMap<Integer, Path> found = new TreeMap<>();
        for (Path home : candidates()) {
            int version = version(home);
            if (version >= OLDEST) {
                found.putIfAbsent(version, home);
            }
        }
        Path own = Path.of(System.getProperty("java.home"));
        found.put(Runtime.version().feature(), own);
        Map<Integer, Path> homes = new TreeMap<>(Map.of(Runtime.version().feature(), own));
        homes.put(found.firstKey(), found.firstEntry().getValue());
        homes.put(found.lastKey(), found.lastEntry().getValue());
        return homes;
    }

    private static List<Path> candidates() throws IOException {
        List<Path> homes = new ArrayList<>();
        System.getenv().forEach((name, value) -> {
            if (name.startsWith("JAVA_HOME") && !value.isBlank()) {
                homes.add(Path.of(value));
            }
        });
        Path user = Path.of(System.getProperty("user.home"));
        List<Path> folders = new ArrayList<>(List.of(Path.of("/usr/lib/jvm"), Path.of("/opt/java"),
                Path.of("/Library/Java/JavaVirtualMachines"), Path.of("C:/Program Files/Java"), user.resolve(".jdks"),
                user.resolve(".sdkman/candidates/java")));
        Path beside = Path.of(System.getProperty("java.home")).getParent();
        if (beside != null) {
            folders.add(beside);
        }
        for (Path folder : folders) {
            if (Files.isDirectory(folder)) {
                try (Stream<Path> entries = Files.list(folder)) {
                    entries.sorted().flatMap(entry -> Stream.of(entry, entry.resolve("Contents/Home")))
                            .forEach(homes::add);
                }
            }
        }
        return homes;
    }

    /** Feature version of a home as its file {@code release} has it; 0 if it is none. */
    private static int version(Path home) {
        Path release = home.resolve("release");
        if (!Files.isRegularFile(release) || !Files.isExecutable(java(home))) {
            return 0;
        }
        Properties properties = new Properties();
        try (var in = Files.newBufferedReader(release)) {
            properties.load(in);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        String version = properties.getProperty("JAVA_VERSION", "").replace("\"", "");
        return version.matches("[1-9]\\d*(\\.\\d+)*") ? Runtime.Version.parse(version).feature() : 0;
    }

    /** Command that starts the machine of a home. */
    public static Path java(Path home) {
        Path command = home.resolve("bin").resolve("java");
        return Files.exists(command) ? command : home.resolve("bin").resolve("java.exe");
    }
}
