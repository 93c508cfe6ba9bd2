package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.bench.TruthTable;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.settings.Schedule;
import radiosity.solution.Solution;
import radiosity.testkit.Evaluate;
import radiosity.testkit.PointSet;
import radiosity.testkit.Score;
import radiosity.testkit.SharedData;
import radiosity.testkit.Solve;
import radiosity.testkit.TruthFile;

/**
 * Nine scenes whose radiosities at about 2,000 points each are known from path tracing, to 0.25 %. Errors are
 * area-weighted and relative to the mean of what does not emit ({@link Score}).
 */
@Tag("slow")
class TruthTest {

    /** Radiosities at default settings at the points of a scene; each is calculated once. */
    private static final Map<String, double[]> FOUND = new HashMap<>();

    static Stream<String> scenes() {
        return TruthTable.SCENES.stream();
    }

    private static Score score(String name, PointSet set) throws IOException {
        TruthFile truth = TruthFile.read(SharedData.truth("truth", name + ".csv"));
        if (!FOUND.containsKey(name)) {
            Solution solution = Solve.byDefault().solution(read(name + ".lws"));
            FOUND.put(name, Evaluate.radiosity(solution, truth.places()));
        }
        return Score.rgb(truth, set, FOUND.get(name));
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void defaultSettings_areWithinTwoPerCent(String name) throws IOException {
        assertEquals(0, score(name, PointSet.REFLECTORS).rmse(), 0.02);
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void defaultSettings_areUnbiasedToHalfAPerCent(String name) throws IOException {
        assertEquals(0, score(name, PointSet.REFLECTORS).bias(), 0.005);
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void nearOtherSurfaces_errorIsAtMostSixPerCent(String name) throws IOException {
        assertEquals(0, score(name, PointSet.NEAR).rmse(), 0.06);
    }

    /** It has 5e-4 of the scene's mean, and begins behind a wall of 4 mm. */
    @Test
    void darkRoomBehindAThinWall_isWithinFivePerCentOfItsOwnMean() throws IOException {
        assertEquals(0, score("thin_wall", PointSet.DARK).rmse(), 0.05);
    }

    @Test
    void darkRoomBehindADoorway_isWithinFivePerCentOfItsOwnMean() throws IOException {
        assertEquals(0, score("two_room", PointSet.DARK).rmse(), 0.05);
    }

    static Stream<String> variants() {
        return TruthTable.SCENES.stream().flatMap(name -> Stream.of(name + "_lwo2", name + "_v1"));
    }

    @ParameterizedTest
    @MethodSource("variants")
    void everyFormat_givesTheSameTriangles(String variant) throws IOException {
        Scene expected = read(variant.replaceAll("_[^_]*$", ".lws"));
        Scene found = read(variant + ".lws");
        assertArrayEquals(corners(expected), corners(found));
        assertArrayEquals(surfaces(expected), surfaces(found), 1e-6);
    }

    /** The files hold coordinates as floats. */
    @ParameterizedTest
    @MethodSource("scenes")
    void triangles_areThoseOfTheDescription(String name) throws IOException {
        double[] described = areas(SharedData.scene(name,
                SharedData.json(SharedData.truth("scenes", name + ".json")).get("surfaces")));
        double[] found = areas(read(name + ".lws"));
        for (int i = 0; i < found.length; i++) {
            assertEquals(described[i], found[i], 1e-5 * described[i]);
        }
    }

    /** Gathered, so that a last bit of a colour does not change who shoots first. */
    @ParameterizedTest
    @MethodSource("scenes")
    void everyFormat_givesTheSameRadiosities(String name) throws IOException {
        Solution expected = cheap(name + ".lws");
        for (String variant : new String[] {"_lwo2.lws", "_v1.lws"}) {
            Solution found = cheap(name + variant);
            assertArrayEquals(expected.corners(), found.corners());
            for (int i = 0; i < 3 * expected.elements(); i++) {
                for (int c = 0; c < 3; c++) {
                    double b = expected.radiosityAt(i / 3, i % 3).channel(c);
                    assertEquals(b, found.radiosityAt(i / 3, i % 3).channel(c), 1e-5 * Math.abs(b));
                }
            }
        }
    }

    private static Solution cheap(String file) throws IOException {
        Scene scene = read(file);
        RadiositySettings settings = new RadiositySettings(scene.area() / 200, 1, Double.POSITIVE_INFINITY,
                Schedule.GATHERING);
        return Solve.byDefault().settings(settings).unsent(0.3).solution(scene);
    }

    static Scene read(String file) throws IOException {
        return LightWaveReader.read(SharedData.truth("lightwave", file), ReadOptions.defaults(), warning -> { });
    }

    private static double[] corners(Scene scene) {
        double[] corners = new double[9 * scene.triangles()];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = scene.points()[3 * scene.corners()[i / 3] + i % 3];
        }
        return corners;
    }

    /** Exitance and reflectance, 6 per triangle. */
    private static double[] surfaces(Scene scene) {
        double[] values = new double[6 * scene.triangles()];
        for (int i = 0; i < values.length; i++) {
            var surface = scene.surface(i / 6);
            values[i] = (i % 6 < 3 ? surface.exitance() : surface.reflectance()).channel(i % 3);
        }
        return values;
    }

    /** Area seen from each of six sides, and emitted and reflected flux under unit irradiance in three channels. */
    private static double[] areas(Scene scene) {
        double[] sums = new double[12];
        for (int t = 0; t < scene.triangles(); t++) {
            var a = scene.corner(t, 0);
            var half = scene.corner(t, 1).minus(a).cross(scene.corner(t, 2).minus(a)).times(0.5);
            double[] n = {half.x(), half.y(), half.z()};
            for (int c = 0; c < 3; c++) {
                sums[2 * c + (n[c] > 0 ? 1 : 0)] += Math.abs(n[c]);
                sums[6 + c] += scene.area(t) * scene.surface(t).exitance().channel(c);
                sums[9 + c] += scene.area(t) * scene.surface(t).reflectance().channel(c);
            }
        }
        return sums;
    }
}
