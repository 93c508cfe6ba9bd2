package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.output.points.Points;
import radiosity.scene.Lamp;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.solution.Certificate;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.testkit.Cells;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;
import radiosity.testkit.Spread;

/**
 * The share of each lamp is kept apart: light is linear, so lamps may be dimmed and coloured afterwards. Where to look
 * closer is decided for each layer relative to itself, so neither mesh nor rays depend on how bright a lamp is.
 */
@Tag("slow")
public class LayersTest {

    private static final double DIM = 0.3;
    private static final Rgb WARM = new Rgb(1, 0.7, 0.4);

    private static final Solve COARSE = Solve.byDefault().settings(
            new RadiositySettings(0, 0, Double.POSITIVE_INFINITY, Schedule.PREDICT, 0.3, 6e-3));

    private static Solution whole;

    @BeforeAll
    static void solve() {
        whole = layered(room(Rgb.grey(1)));
    }

    /** Four lamps, of which the last is a light without geometry; the first is as bright as told. */
    public static Scene room(Rgb first) {
        Surface wall = new Surface("wall", Rgb.BLACK, new Rgb(0.7, 0.5, 0.3), false);
        Surface[] lamp = {new Surface("first", first.times(5), Rgb.grey(0.2), false), RoomScenes.grey("second", 1, 0.4),
            new Surface("third", new Rgb(0, 0.2, 3), Rgb.BLACK, false)};
        double[] planes = {0, 1, 2, 3};
        Scene room = new Cells(planes, planes, planes).room("four lamps", (i, j, k) -> i != 1 || j != 0 || k != 1,
                (i, j, k, side) -> side == 3 && k == 1 ? lamp[i] : wall);
        Light light = new Light("fourth", Light.Kind.POINT, Rgb.grey(0.5), new Vec3(0.5, 1.5, 0.5), new Vec3(0, -1, 0),
                Vec3.ZERO, Vec3.ZERO, 1, 0, 0);
        return new Scene(room.name(), room.points(), room.corners(), room.surfaceOf(), room.surfaces(), List.of(light),
                room.camera());
    }

    private static Solution layered(Scene scene) {
        return COARSE.settings(COARSE.settings().layers(true)).solution(scene);
    }

    /** Irradiance at a vertex with the first lamp in another light. */
    private static Rgb mixed(int vertex, Rgb first) {
        Rgb sum = whole.irradianceAt(vertex, 0).times(first);
        for (int layer = 1; layer < whole.layers(); layer++) {
            sum = sum.plus(whole.irradianceAt(vertex, layer));
        }
        return sum;
    }

    private static double largest(Solution solution, int channel) {
        double largest = 0;
        for (int v = 0; v < solution.vertices(); v++) {
            largest = Math.max(largest, solution.irradianceAt(v).channel(channel));
        }
        return largest;
    }

    @Test
    void everyLamp_hasALayer() {
        assertEquals(List.of("first", "second", "third", "fourth"), whole.lamps().stream().map(Lamp::name).toList());
        assertEquals(12, whole.channels());
        assertEquals(3, whole.ledger().emitted().length);
    }

    @Test
    void redOfABlueLamp_isNone() {
        for (int v = 0; v < whole.vertices(); v++) {
            assertEquals(0, whole.irradianceAt(v, 2).r());
        }
    }

    @Test
    void dimmedLamp_isMixedAsItIsSolved() {
        mixedAsSolved(Rgb.grey(DIM));
    }

    @Test
    void colouredLamp_isMixedAsItIsSolved() {
        mixedAsSolved(WARM);
    }

    private static void mixedAsSolved(Rgb first) {
        Solution solved = layered(room(first));
        assertArrayEquals(whole.corners(), solved.corners(), "the same mesh");
        for (int c = 0; c < 3; c++) {
            double largest = largest(whole, c);
            for (int v = 0; v < solved.vertices(); v++) {
                assertEquals(solved.irradianceAt(v).channel(c), mixed(v, first).channel(c), 1e-6 * largest);
            }
        }
    }

    /** The two are independent estimates: what they differ by is within the sum of the errors that they expect. */
    @Test
    void mixture_differsFromASolveFromScratchByLessThanBothCertificates() throws IOException {
        Certified scratch = Certified.of(room(Rgb.grey(DIM)), COARSE.settings());
        Certified layers = Certified.of(room(Rgb.grey(1)), COARSE.settings().layers(true));
        double expected = scratch.certificate.expected() + layers.certificate.expected();
        double rms = difference(new Points(mixture(Rgb.grey(DIM))), scratch.solution);
        assertTrue(rms <= expected, "differs by " + rms + " of the mean, certified are " + expected);
        assertTrue(expected < 0.05, "and that is not much: " + expected);
        for (int c = 0; c < 3; c++) {
            int channel = c;
            double mean = Spread.irradiance(scratch.solution, c).mean();
            assertEquals(mean, Spread.of(whole, p -> true, (e, k) ->
                    mixed(whole.corners()[3 * e + k], Rgb.grey(DIM)).channel(channel)).mean(), 0.01 * mean);
        }
    }

    /** A solution and how far it can be trusted. */
    private record Certified(Solution solution, Certificate certificate) {

        static Certified of(Scene scene, RadiositySettings settings) throws IOException {
            try (LocalWorld world = new LocalWorld(scene, settings, 2)) {
                ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, COARSE.stop());
                rounds.run(progress -> true);
                return new Certified(rounds.solution(), rounds.certificate(2).orElseThrow());
            }
        }
    }

    /** As if there were one layer. */
    private static Solution mixture(Rgb first) {
        double[] irradiance = new double[3 * whole.vertices()];
        for (int i = 0; i < irradiance.length; i++) {
            irradiance[i] = mixed(i / 3, first).channel(i % 3);
        }
        return new Solution(whole.scene(), 3, whole.positions(), irradiance, whole.corners(), whole.faceOf(), 0, 0, 0,
                whole.ledger(), SavedState.NONE);
    }

    /** Root of the mean square difference of radiosity over what reflects and does not emit, of the mean. */
    private static double difference(Points found, Solution expected) {
        double squares = 0;
        double sum = 0;
        double area = 0;
        for (int e = 0; e < expected.elements(); e++) {
            if (!expected.surface(e).emits()) {
                Vec3[] p = {corner(expected, e, 0), corner(expected, e, 1), corner(expected, e, 2)};
                Vec3 cross = p[1].minus(p[0]).cross(p[2].minus(p[0]));
                double mean = (expected.radiosityAt(e, 0).g() + expected.radiosityAt(e, 1).g()
                        + expected.radiosityAt(e, 2).g()) / 3;
                double other = found.at(p[0].plus(p[1]).plus(p[2]).times(1.0 / 3), cross).radiosity().g();
                squares += cross.length() * (mean - other) * (mean - other);
                sum += cross.length() * mean;
                area += cross.length();
            }
        }
        return Math.sqrt(squares / area) / (sum / area);
    }

    private static Vec3 corner(Solution solution, int element, int k) {
        int v = 3 * solution.corners()[3 * element + k];
        return new Vec3(solution.positions()[v], solution.positions()[v + 1], solution.positions()[v + 2]);
    }
}
