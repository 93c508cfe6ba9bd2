package radiosity.output.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.output.image.ToneMapping;
import radiosity.output.mesh.TJunctions;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.solution.Certificate;
import radiosity.solution.EnergyLedger;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;

class SceneInfoTest {

    @TempDir
    Path folder;

    private List<String> lines(Solution solution, Optional<Camera> camera) throws IOException {
        Path file = folder.resolve("x.scene");
        SceneFile.write(file, solution, Map.of("commandLine", "RadiosityRenderer x.lws x.scene\u001b[2J"), camera,
                ToneMapping.automatic(solution));
        return SceneInfo.lines(file);
    }

    private static void assertHas(List<String> lines, String line) {
        assertTrue(lines.contains(line), line + " is not in:\n" + String.join("\n", lines));
    }

    @Test
    void lines_sayWhatTheFileHolds() throws IOException {
        Handmade room = Handmade.room(new Vec3(1, 2, 3), 2, p -> new Rgb(10, 20, 30));
        room.grid(room.surface("lamp", new Rgb(99, 98, 97), Rgb.grey(.1), false), new Vec3(2, 3, 4),
                new Vec3(.1, 0, 0), new Vec3(0, 0, .1), 1, 1, p -> new Rgb(10, 20, 30));
        room.state = new byte[1];
        Solution solution = room.solution();
        Camera camera = new Camera(new Vec3(2, 3, 9), new Vec3(0, 0, -1), new Vec3(0, 1, 0), Math.PI / 8, 1.5);
        List<String> lines = lines(solution, Optional.of(camera));
        assertHas(lines, "format                      1");
        assertHas(lines, "shots                       7 in 5 rounds");
        assertHas(lines, "state                       kept, the render can go on");
        assertHas(lines, "surfaces                    7: floor, ceiling, left, right, back, front, lamp");
        assertHas(lines, "triangles                   " + TJunctions.close(solution).elements()
                + ": mesh elements, and what closes the cracks between them");
        assertHas(lines, "vertices                    " + TJunctions.close(solution).vertices());
        assertHas(lines, "box                         1, 2, 3 to 3, 4, 5");
        assertHas(lines, "radiosity                   1, 2, 3 to 100, 100, 100 W/m2");
        assertHas(lines, "units                       length of a scene unit not known, light radiometric: W/m2 x unit2,"
                + " W/m2");
        assertHas(lines, "absorbed                    0.6 W/m2 x unit2 (R, G, B: 0.5, 0.6, 0.7)");
        assertHas(lines, "escaped or lost             1 W/m2 x unit2 (R, G, B: 1, 1, 1)");
        assertHas(lines, "camera                      at 2, 3, 9 towards 0, 0, -1, 45.0 degrees high, aspect 1.500");
        assertHas(lines, "commandLine                 RadiosityRenderer x.lws x.scene\\u001b[2J");
        lines.forEach(line -> assertEquals(1, line.lines().count()));
    }

    @Test
    void lostLight_isThatWhichHasNotEscaped() throws IOException {
        Handmade room = Handmade.room(Vec3.ZERO, 1, p -> Rgb.grey(1));
        Solution open = room.solution();
        EnergyLedger all = open.ledger();
        EnergyLedger known = new EnergyLedger(all.emitted(), all.shot(), all.received(), all.absorbed(), all.unshot(),
                new double[] {.75, .5, 1.25});
        List<String> lines = lines(new Solution(open.scene(), open.channels(), open.positions(), open.irradiance(),
                open.corners(), open.faceOf(), 7, 5, .25, known, SavedState.NONE), Optional.empty());
        assertHas(lines, "escaped                     0.83333 W/m2 x unit2 (R, G, B: 0.75, 0.5, 1.25), found by rays");
        assertHas(lines, "lost                        0.16667 W/m2 x unit2 (R, G, B: 0.25, 0.5, -0.25)");
    }

    private List<String> lines(Units units) throws IOException {
        Solution room = Handmade.room(Vec3.ZERO, 1, p -> new Rgb(10, 20, 30)).solution();
        return lines(new Solution(room.scene().with(units), room.channels(), room.positions(), room.irradiance(),
                room.corners(), room.faceOf(), 7, 5, .25, room.ledger(), SavedState.NONE), Optional.empty());
    }

    /** The mean of the channels: a scene that is nearly grey has nearly the flux of one that is grey. */
    @Test
    void fluxIsInWatts_whereTheLengthOfAUnitIsKnown() throws IOException {
        List<String> lines = lines(new Units(.1, false));
        assertHas(lines, "units                       a scene unit is 0.1 m, light radiometric: W, W/m2");
        assertHas(lines, "emitted                     0.02 W (R, G, B: 0.01, 0.02, 0.03)");
        assertHas(lines, "not yet distributed         0.00066667 W (R, G, B: 0.001, -0.002, 0.003) net, what was shot too much"
                + " subtracted; 0.00083333 W absolute");
    }

    /** Luminous flux is the sum of the channels with the weights of ITU-R BT.709. */
    @Test
    void photometricScene_isInLumens() throws IOException {
        List<String> lines = lines(new Units(.1, true));
        assertHas(lines, "units                       a scene unit is 0.1 m, light photometric: lm, lx, cd/m2");
        assertHas(lines, "emitted                     0.018596 lm (R, G, B: 0.01, 0.02, 0.03)");
        assertHas(lines, "radiosity                   1, 2, 3 to 7, 14, 21 lm/m2");
        assertTrue(lines.stream().noneMatch(line -> line.contains("W")), String.join("\n", lines));
    }

    @Test
    void photometricSceneOfUnknownLength_isInLumensPerSquareMetreTimesSquareUnits() throws IOException {
        assertHas(lines(Units.UNKNOWN.withPhotometric(true)),
                "emitted                     1.8596 lm/m2 x unit2 (R, G, B: 1, 2, 3)");
    }

    /** The words are those of the summary. */
    @Test
    void certificate_isInTheSummarysWords() throws IOException {
        Solution room = Handmade.room(Vec3.ZERO, 1, p -> Rgb.grey(1)).solution();
        Solution metric = new Solution(room.scene().with(new Units(.1, false)), room.channels(), room.positions(),
                room.irradiance(), room.corners(), room.faceOf(), 7, 5, .25, room.ledger(), SavedState.NONE);
        Path file = folder.resolve("x.scene");
        SceneFile.write(file, metric, Map.of("certificate", new Certificate(190, 2032., .9987, 1.01, .015, .011, .012,
                .007, -.001, .002, List.of())), Optional.empty(), ToneMapping.automatic(metric));
        List<String> lines = SceneInfo.lines(file);
        assertHas(lines, "upper bound on missing flux 6.7733 W");
        assertHas(lines, "mean form-factor sum        0.9987");
        assertHas(lines, "largest form-factor sum     1.01");
        assertHas(lines, "reciprocity error           1.5 %");
    }

    @Test
    void numbers_haveFiveDigits_andListsSayWhatIsInThem() throws IOException {
        Path file = folder.resolve("x.scene");
        Solution solution = Handmade.room(Vec3.ZERO, 1, p -> Rgb.grey(1)).solution();
        Map<String, Object> extras = Map.of("third", 1 / 3., "list", List.of(2 / 3., 100, "text"), "array",
                new double[] {1e-7 / 3, 2e9 / 3}, "map", Map.of("bound", 1 / 7.));
        SceneFile.write(file, solution, extras, Optional.empty(), ToneMapping.automatic(solution));
        List<String> lines = SceneInfo.lines(file);
        assertHas(lines, "third                       0.33333");
        assertHas(lines, "list                        0.66667, 100, text");
        assertHas(lines, "array                       3.3333E-8, 6.6667E8");
        assertHas(lines, "map                         bound=0.14286");
        assertTrue(lines.stream().anyMatch(line -> line.startsWith("not yet distributed ") && line.contains(" net, ")
                && line.endsWith(" W/m2 x unit2 absolute")),
                lines.toString());
    }

    @Test
    void emptyFile_hasItsLinesToo() throws IOException {
        List<String> lines = lines(new Handmade().solution(), Optional.empty());
        assertHas(lines, "triangles                   0: mesh elements, and what closes the cracks between them");
        assertHas(lines, "camera                      none");
        assertHas(lines, "state                       none, the render cannot go on");
    }

    @Test
    void fileThatIsNoScene_isRefused() throws IOException {
        Path file = Files.writeString(folder.resolve("x"), "hello");
        assertThrows(SceneFormatException.class, () -> SceneInfo.lines(file));
    }
}
