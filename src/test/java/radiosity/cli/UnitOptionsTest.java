package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.testkit.ProgramRun;

/** {@code --unit} and {@code --photometric}: the numbers and the names of their units in all that a render says. */
@Tag("slow")
class UnitOptionsTest {

    private static final Path BOX = Path.of("scenes/cornell-box.lws");
    private static final Pattern EMITTED = Pattern.compile("emitted (\\S+) (.*) = absorbed ");

    @TempDir
    Path folder;

    private Path output;

    @BeforeEach
    void nameOutput() {
        output = folder.resolve("box.scene");
    }

    private ProgramRun render(Object... options) {
        Object[] all = Arrays.copyOf(options, options.length + 7, Object[].class);
        System.arraycopy(new Object[] {"-q", "-pa", "20000", "-it", 5, BOX, output}, 0, all, options.length, 7);
        ProgramRun run = ProgramRun.of(all);
        assertEquals(0, run.exitCode(), run.err());
        return run;
    }

    /** The emitted flux of a summary: number and unit. */
    private static String[] emitted(ProgramRun run) {
        Matcher found = EMITTED.matcher(run.out());
        assertTrue(found.find(), run.out());
        return new String[] {found.group(1), found.group(2)};
    }

    private String info(String name) {
        ProgramRun run = ProgramRun.of("--info", output);
        assertEquals(0, run.exitCode(), run.err());
        return run.out().lines().filter(line -> line.startsWith(name + " ")).findFirst().orElseThrow()
                .substring(name.length()).strip();
    }

    private JsonNode report(Object... options) throws IOException {
        Path file = folder.resolve("report.json");
        Object[] all = Arrays.copyOf(options, options.length + 2, Object[].class);
        all[options.length] = "--report";
        all[options.length + 1] = file;
        render(all);
        return new ObjectMapper().readTree(file.toFile());
    }

    /** 1 m2 has 1e6 mm2. */
    @ParameterizedTest
    @CsvSource({"mm, 1e-6", "cm, 1e-4", "m, 1", "in, 6.4516e-4", "ft, 0.09290304"})
    void flux_isInWattsOfTheUnitThatIsSaid(String unit, double squareMetres) {
        String[] unknown = emitted(render());
        assertEquals("W/m2 x unit2", unknown[1]);
        String[] known = emitted(render("--unit", unit));
        assertEquals("W", known[1]);
        assertEquals(squareMetres, Double.parseDouble(known[0]) / Double.parseDouble(unknown[0]), 1e-5 * squareMetres);
    }

    /** The lamp's exitance, of red, green and blue, counts by the weights of ITU-R BT.709. */
    @Test
    void photometricFlux_isTheWeightedSumInLumens() throws IOException {
        String[] lumens = emitted(render("--unit", "mm", "--photometric"));
        assertEquals("lm", lumens[1]);
        JsonNode report = report("--unit", "mm", "--photometric");
        JsonNode channels = report.at("/ledger/emitted");
        double expected = 1e-6 * (.2126 * channels.get(0).doubleValue() + .7152 * channels.get(1).doubleValue()
                + .0722 * channels.get(2).doubleValue());
        assertEquals(expected, Double.parseDouble(lumens[0]), 1e-5 * expected);
        assertEquals("lm/m2 x unit2", emitted(render("--photometric"))[1]);
    }

    @Test
    void report_namesItsUnits() throws IOException {
        JsonNode report = report("--unit", "cm", "--photometric");
        assertEquals("lm", report.at("/flux/unit").textValue());
        assertTrue(report.get("photometric").booleanValue());
        assertEquals(.01, report.get("metresPerUnit").doubleValue());
        assertEquals("[0.2126,0.7152,0.0722]", report.get("luminanceWeights").toString());
        JsonNode plain = report();
        assertEquals("W/m2 x unit2", plain.at("/flux/unit").textValue());
        assertFalse(plain.get("photometric").booleanValue());
        assertFalse(plain.has("metresPerUnit") || plain.has("luminanceWeights"), plain.toString());
        assertEquals("W", report("--unit", "cm").at("/flux/unit").textValue());
    }

    /** The same number and unit after the render as at its end. */
    @ParameterizedTest
    @CsvSource({"--unit=mm --photometric", "--unit=mm", "--photometric", "-q"})
    void info_saysTheFluxOfTheSummary(String options) {
        String[] words = options.equals("-q") ? new String[0] : options.split(" ");
        String[] summary = emitted(render((Object[]) words));
        String info = info("emitted");
        assertTrue(info.contains(" " + summary[1] + " ("), info);
        double inFile = Double.parseDouble(info.substring(0, info.indexOf(' ')));
        assertEquals(Double.parseDouble(summary[0]), inFile, 1e-4 * inFile);
        assertTrue(info("radiosity").endsWith(options.contains("photometric") ? " lm/m2" : " W/m2"));
    }

    /** E is the weighted irradiance, L the weighted radiosity by pi. */
    @Test
    void points_haveIlluminanceAndLuminance() throws IOException {
        Path in = Files.writeString(folder.resolve("in.csv"), "278,0,-280,0,1,0\n100,548.8,-280,0,-1,0\n");
        Path out = folder.resolve("out.csv");
        render("--photometric", "--points", in, out);
        List<String> rows = Files.readAllLines(out);
        assertEquals("x,y,z,nx,ny,nz,H_r,H_g,H_b,B_r,B_g,B_b,E_lx,L_cd_m2", rows.get(0));
        double[] of = Arrays.stream(rows.get(1).split(",")).mapToDouble(Double::parseDouble).toArray();
        assertEquals(14, of.length);
        assertTrue(of[12] > 0 && of[13] > 0, rows.get(1));
        assertEquals(.2126 * of[6] + .7152 * of[7] + .0722 * of[8], of[12], 1e-12 * of[12]);
        assertEquals((.2126 * of[9] + .7152 * of[10] + .0722 * of[11]) / Math.PI, of[13], 1e-12 * of[13]);
        render("--points", in, out);
        assertEquals("x,y,z,nx,ny,nz,H_r,H_g,H_b,B_r,B_g,B_b", Files.readAllLines(out).get(0));
        assertArrayEquals(Arrays.copyOf(of, 12), Arrays.stream(Files.readAllLines(out).get(1).split(","))
                .mapToDouble(Double::parseDouble).toArray(), 0, "the light itself is the same");
    }

    /** As of a table in another unit. */
    @Test
    void pointsOnNoSurface_areCounted() throws IOException {
        Path in = Files.writeString(folder.resolve("in.csv"), "278,0,-280,0,1,0\n.278,0,-.280,9,1,0\n");
        ProgramRun run = render("--points", in, folder.resolve("out.csv"));
        assertTrue((run.out() + run.err()).contains(in + ": 1 point lies on no surface, and has no light"),
                run.out() + run.err());
    }

    /** The room has lights in candela: photometric and in metres without any option. */
    @Test
    void gltfWithLights_isPhotometricAndInMetres() {
        ProgramRun run = ProgramRun.of("-q", "-it", 3, "src/test/resources/radiosity/input/room.glb", output);
        assertEquals(0, run.exitCode(), run.err());
        assertEquals("lm", emitted(run)[1]);
        assertEquals("a scene unit is 1.0 m, light photometric: lm, lx, cd/m2", info("units"));
    }

    @ParameterizedTest
    @CsvSource({"--photometric, lx, lm/m2", "--lights=ignore, W/m2, W/m2"})
    void lightmapAndPicture_nameTheirUnit(String option, String arriving, String leaving) throws IOException {
        Path glb = folder.resolve("lit.glb");
        Path hdr = folder.resolve("box.hdr");
        render(option, "--lightmap", glb, "--lightmap-texels", "0.05", "--picture", hdr, "--size", "16x16");
        String json = Files.readString(glb, StandardCharsets.ISO_8859_1);
        assertTrue(json.contains("\"unit\":\"" + arriving + "\""), json.substring(0, 2000));
        String header = Files.readString(hdr, StandardCharsets.ISO_8859_1);
        assertTrue(header.startsWith("#?RADIANCE\n# radiosity, " + leaving + "\n"), header.substring(0, 40));
    }
}
