package radiosity.input.photometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import radiosity.scene.LuminousIntensity;

/** Luminaires' files out of public packages have the intensities that other readers find in them. */
class RealLuminairesTest {

    private static final Path FOLDER = Path.of("target", "luminaires");
    private static final int LEAST_FILES = 10;

    @Test
    void intensities_areThoseOfOtherReaders() throws IOException {
        Path table = FOLDER.resolve("reference.csv");
        assumeTrue(Files.exists(table), "no " + table + ": scripts/luminaires makes it");
        Map<String, LuminousIntensity> webs = new HashMap<>();
        for (String line : Files.readAllLines(table)) {
            int comma = line.indexOf(',', line.lastIndexOf("."  + (line.contains(".ies,") ? "ies" : "ldt")));
            String name = line.substring(0, comma);
            String[] numbers = line.substring(comma + 1).split(",");
            if (!webs.containsKey(name)) {
                webs.put(name, Photometry.read(FOLDER.resolve(name), 1 << 20).intensity());
            }
            LuminousIntensity web = webs.get(name);
            double expected = Double.parseDouble(numbers[2]);
            if (Double.parseDouble(numbers[1]) <= web.vertical()[web.vertical().length - 1]) {
                assertEquals(expected, web.at(Double.parseDouble(numbers[0]), Double.parseDouble(numbers[1])),
                        1e-4 * web.max(), line);
            } else {
                assertEquals(0, expected, line);
            }
        }
        assertTrue(webs.size() >= LEAST_FILES, webs.keySet().toString());
    }
}
