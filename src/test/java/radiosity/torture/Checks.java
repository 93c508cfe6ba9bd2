package radiosity.torture;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** What must hold after every process of a run; collects what does not. */
final class Checks {

    /** Content of an output file before a run. */
    static final String OLD = "what was there before";
    /** Documented in --help and in the design; what a signal ends itself is none of the program's. */
    static final Set<Integer> DOCUMENTED = Set.of(0, 1, 2, 3, 4, 5, 130, 143);
    private static final Pattern TRACE = Pattern.compile("(?m)^\\s+at [\\w.$/<>]+\\([^)]*\\)|Exception in thread.*"
            + "|.*nested exception.*|\\bjava(x)?\\.[\\w.]+(Exception|Error)\\b|\\bsun\\.[\\w.]+Exception\\b"
            + "|A fatal error has been detected");
    /** The terminal's library unpacks itself into a temporary file, which a limit for files stops. */
    private static final Pattern LIBRARY = Pattern.compile("(?m)^WARNING: Unable to load JLine's native library.*$");
    /** What Java itself may say where a signal ends it before it has begun. */
    private static final Pattern BEGINNING = Pattern.compile("Error occurred during initialization of VM\\R"
            + "java\\.lang\\.InternalError.*\\R(\\s+at .*\\R?)*");
    /** Exit codes after a signal. */
    private static final Set<Integer> SIGNALLED = Set.of(130, 143);
    private static final Pattern INTERNAL = Pattern.compile("(?m)^.*(expected no error, got|internal error).*$");
    private static final Pattern LEFT_OVER = Pattern.compile(".*(\\.part|\\.tmp|\\.journal).*");

    private final List<String> failures = new ArrayList<>();

    List<String> failures() {
        return failures;
    }

    void fail(String what) {
        failures.add(what);
    }

    /**
     * A process that has ended: its exit code, and that what it printed was meant for a user.
     *
     * @param allowed exit codes
     */
    void ended(String what, Running.Ended ended, boolean debug, Set<Integer> allowed) {
        if (!allowed.contains(ended.exitCode())) {
            fail(what + ": exit code " + ended.exitCode() + ", expected one of " + new TreeSet<>(allowed)
                    + lastLines(ended.printed()));
        } else if (!DOCUMENTED.contains(ended.exitCode())) {
            fail(what + ": exit code " + ended.exitCode() + ", which is not documented");
        }
        String printed = LIBRARY.matcher(ended.printed()).replaceAll("");
        Matcher trace = TRACE.matcher(!SIGNALLED.contains(ended.exitCode()) ? printed
                : BEGINNING.matcher(printed).replaceAll(""));
        Matcher internal = INTERNAL.matcher(ended.printed());
        if (internal.find()) {
            fail(what + ": internal error: " + internal.group());
        } else if (trace.find() && !(debug && ended.exitCode() != 0)) {
            fail(what + ": Java's words: " + trace.group());
        }
    }

    private static String lastLines(String text) {
        List<String> lines = text.lines().toList();
        return ": " + String.join(" | ", lines.subList(Math.max(0, lines.size() - 3), lines.size()));
    }

    /** The scene file is what it was before, or a whole one; null unless it is a whole one. */
    LightFile oldOrWhole(String what, Path file) throws IOException {
        if (Files.notExists(file)
                || Arrays.equals(Files.readAllBytes(file), OLD.getBytes(StandardCharsets.UTF_8))) {
            return null;
        }
        return whole(what, file);
    }

    /** A scene file that must be there: whole, and made of numbers. Null where it is not. */
    LightFile whole(String what, Path file) {
        try {
            LightFile light = LightFile.read(file);
            String wrong = light.notFinite();
            if (wrong != null) {
                fail(what + ": not a number: " + wrong);
                return null;
            }
            return light;
        } catch (IOException e) {
            fail(what + ": torn file: " + e.getMessage());
            return null;
        }
    }

    void same(String what, LightFile expected, LightFile got) {
        String difference = expected.difference(got);
        if (difference != null) {
            fail(what + ": other light than undisturbed: " + difference);
        }
    }

    void sameBytes(String what, Path expected, Path got) throws IOException {
        if (Files.notExists(got)) {
            fail(what + ": " + got.getFileName() + " was not written");
        } else if (Files.mismatch(expected, got) >= 0) {
            fail(what + ": " + got.getFileName() + " is not what it is undisturbed");
        }
    }

    /** Radiosity is what a surface emits and reflects, at every vertex. */
    void reflected(String what, LightFile light) {
        for (LightFile.Mesh mesh : light.meshes) {
            if (mesh.attributes().containsKey("_REFLECTANCE")) {
                continue;
            }
            for (int i = 0; i < mesh.radiosity().length; i++) {
                double reflected = mesh.reflectance()[i % 3] * mesh.irradiance()[i];
                double expected = mesh.exitance()[i % 3] + reflected;
                double unit = mesh.exitance()[i % 3] + Math.abs(reflected);
                if (Math.abs(mesh.radiosity()[i] - expected) > 1e-5 * unit + 1e-30) {
                    fail(what + ": radiosity[" + i / 3 + "] of " + mesh.name() + " is " + mesh.radiosity()[i]
                            + ", emitted + reflected is " + expected);
                    return;
                }
            }
        }
    }

    /** No temporary file is left. */
    void tidy(String what, Path directory) throws IOException {
        try (Stream<Path> files = Files.list(directory)) {
            files.map(file -> file.getFileName().toString()).filter(name -> LEFT_OVER.matcher(name).matches())
                    .forEach(name -> fail(what + ": " + name + " is left"));
        }
    }
}
