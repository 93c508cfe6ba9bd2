package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.testkit.PointSet;
import radiosity.testkit.Score;
import radiosity.testkit.SharedData;
import radiosity.testkit.TruthFile;

/** {@link Score} against {@code score.py} itself, on the truth with errors of 5 % and one missing value. */
class ScoreTest {

    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"cornell_blocks", "thin_wall", "bright_ratio"})
    void score_isThatOfTheScript(String scene) throws Exception {
        Path file = SharedData.truth("truth", scene + ".csv");
        TruthFile truth = TruthFile.read(file);
        double[] found = disturbed(truth);
        JsonNode script = script(file, candidate(found));
        for (PointSet set : PointSet.values()) {
            JsonNode rows = script.get(set.name().toLowerCase(Locale.ROOT));
            if (rows == null) {
                assertEquals(Score.NONE, Score.rgb(truth, set, found));
                continue;
            }
            check(rows.get("rgb"), Score.rgb(truth, set, found));
            check(rows.get("r"), Score.channel(truth, set, 0, found));
            check(rows.get("b"), Score.channel(truth, set, 2, found));
        }
    }

    private static void check(JsonNode expected, Score score) {
        assertEquals(expected.get("n").asInt(), score.points());
        assertEquals(1, score.mean() / expected.get("mean").asDouble(), 1e-12);
        assertEquals(1, score.rmse() / expected.get("rmse").asDouble(), 1e-10);
        assertEquals(expected.get("bias").asDouble(), score.bias(), 1e-12);
        assertEquals(1, score.max() / expected.get("max").asDouble(), 1e-10);
        assertEquals(1, score.noise() / expected.get("noise").asDouble(), 1e-10);
    }

    private static double[] disturbed(TruthFile truth) {
        Random random = new Random(1);
        double[] found = new double[3 * truth.size()];
        for (int i = 0; i < found.length; i++) {
            found[i] = truth.radiosity(i / 3, i % 3) * (1 + 0.05 * random.nextGaussian());
        }
        found[30] = Double.NaN;
        return found;
    }

    private Path candidate(double[] found) throws IOException {
        Path file = folder.resolve("candidate.csv");
        try (PrintWriter out = new PrintWriter(Files.newBufferedWriter(file))) {
            out.println("B_r,B_g,B_b");
            for (int i = 0; i < found.length; i += 3) {
                out.println((found[i] + "," + found[i + 1] + "," + found[i + 2]).replace("NaN", "nan"));
            }
        }
        return file;
    }

    private JsonNode script(Path truth, Path candidate) throws Exception {
        Path answer = folder.resolve("answer.json");
        Process process;
        try {
            process = new ProcessBuilder("python3", SharedData.truth("score.py").toString(), truth.toString(),
                    candidate.toString(), "--json").redirectOutput(answer.toFile()).start();
        } catch (IOException e) {
            Assumptions.abort("no python3 to compare with: " + e.getMessage());
            throw e;
        }
        Assumptions.assumeTrue(process.waitFor() == 0, "python3 has no numpy, or the script failed");
        String text = Files.readString(answer);
        return new ObjectMapper().readTree(text.substring(text.indexOf('{')));
    }
}
