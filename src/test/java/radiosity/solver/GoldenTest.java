package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.testkit.JavaMachines;

/**
 * The law of the house between machines: four small renders give the light whose hashes stand in the repository, with
 * every compiler of the oldest and of the newest JDK at hand, in any locale, and on any number of threads and
 * partitions.
 *
 * <p>{@code mvn -q test -Dtest=GoldenTest -Dgolden.renew=true} writes the hashes anew.
 */
@Tag("slow")
class GoldenTest {

    private static final Path HASHES = Path.of("src/test/resources/radiosity/solver/golden.txt");
    /** Whether the first render writes the hashes, which the others then have to meet. */
    private static final boolean RENEW = Boolean.getBoolean("golden.renew");

    /** Options of Java virtual machines that must not matter. */
    private static final Map<String, List<String>> MACHINES = Map.of(
            "as usual", List.of(),
            "C1", List.of("-XX:TieredStopAtLevel=1"),
            "C2", List.of("-XX:-TieredCompilation"),
            "interpreter", List.of("-Xint"),
            "elsewhere", List.of("-Duser.language=tr", "-Duser.country=TR", "-Duser.timezone=Pacific/Apia",
                    "-Dfile.encoding=ISO-8859-1"));

    /** One of each schedule: an interpreter takes a minute for all. */
    private static final List<String> INTERPRETED = List.of("PAPER", "WHOLE");

    @TempDir
    Path folder;

    @ParameterizedTest(name = "{0} threads, {1} partitions")
    @CsvSource({"1, 1", "2, 1", "1, 3", "2, 7"})
    void renders_haveTheHashesOfTheRepository(int threads, int parts) throws IOException {
        List<String> lines = GoldenRenders.lines(folder, List.of(GoldenRenders.Render.values()), threads, parts);
        if (RENEW && threads == 1 && parts == 1) {
            Files.createDirectories(HASHES.getParent());
            Files.write(HASHES, lines);
        }
        assertEquals(hashes(), lines);
    }

    static Stream<Arguments> machines() throws IOException {
        List<Arguments> all = new ArrayList<>();
        Map<Integer, Path> homes = JavaMachines.homes();
        int oldest = Collections.min(homes.keySet());
        // one interpreter is enough: it takes longer than all compilers together
        homes.forEach((version, home) -> MACHINES.keySet().stream().sorted()
                .filter(name -> version == oldest || !name.equals("interpreter"))
                .forEach(name -> all.add(Arguments.of(version, name, home))));
        return all.stream();
    }

    @ParameterizedTest(name = "JDK {0}, {1}")
    @MethodSource("machines")
    void otherMachines_giveTheSameHashes(int version, String name, Path home) throws Exception {
        assumeTrue(!RENEW, "the hashes are being renewed");
        List<String> command = new ArrayList<>(List.of(JavaMachines.java(home).toString()));
        command.addAll(MACHINES.get(name));
        command.addAll(List.of("-cp",
                System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
                GoldenRenders.class.getName(), folder.toString()));
        List<String> renders = Arrays.stream(GoldenRenders.Render.values()).map(Enum::name)
                .filter(render -> !name.equals("interpreter") || INTERPRETED.contains(render)).toList();
        command.addAll(renders);
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), said);
        assertEquals(hashes().stream().filter(line -> renders.contains(line.split(" ")[0])).toList(),
                said.lines().toList(), "JDK " + version + " of " + home);
    }

    @Test
    void secondJdk_isAtHand() throws IOException {
        Map<Integer, Path> homes = JavaMachines.homes();
        assumeTrue(homes.size() > 1, "needs a second JDK, named by an environment variable that begins with JAVA_HOME;"
                + " compared on JDK " + homes.keySet() + " only");
        assertTrue(homes.containsKey(Runtime.version().feature()));
    }

    private static List<String> hashes() throws IOException {
        return Files.readAllLines(HASHES);
    }
}
