package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.solver.SameBitsTest.solve;
import static radiosity.testkit.ColouredRoom.assertSame;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.master.RemoteWorld;
import radiosity.master.host.Link;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.StopRule;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.testkit.Cells;
import radiosity.testkit.TestLink;

/** No surface reflects less than nothing, however little arrives there and however it is sampled. */
@Tag("slow")
class NonNegativeTest {

    private static final StopRule STOP = new StopRule(Integer.MAX_VALUE, 1e-3);
    private static final Map<String, Scene> SCENES = scenes();
    private static final String WINDING = "winding passage";

    private static Map<String, Scene> scenes() {
        Map<String, Scene> scenes = new TreeMap<>();
        scenes.put("corridor", dug(new double[] {0, .1, 1}, new double[] {0, .9, 1}, new double[] {0, 1, 1.2, 20},
                (i, j, k) -> true));
        scenes.put(WINDING, dug(new double[] {0, 1, 1.2, 2.2, 2.4, 3.4}, new double[] {0, .9, 1},
                new double[] {0, 1, 1.2, 3, 4}, (i, j, k) -> i % 2 == 0 || k == (i == 1 ? 3 : 0)));
        scenes.put("room behind a slit", dug(new double[] {0, 1, 1.02, 3}, new double[] {0, .02, .9, 1},
                new double[] {0, 1, 1.2, 2}, (i, j, k) -> i != 1 || j == 0));
        scenes.put("room with shelves", dug(new double[] {0, .7, 2}, new double[] {0, .3, .32, .6, .62, .9, 1},
                new double[] {0, 1, 1.2, 2}, (i, j, k) -> i == 1 || j != 1 && j != 3));
        return scenes;
    }

    /** A panel in the ceiling glows yellow; other squares are red, green or blue. */
    private static Scene dug(double[] x, double[] y, double[] z, Cells.Air air) {
        Surface lamp = new Surface("lamp", new Rgb(10, 8, 1), new Rgb(.5, .5, .5), false);
        List<Surface> walls = List.of(new Surface("red", Rgb.BLACK, new Rgb(.7, .1, .02), false),
                new Surface("green", Rgb.BLACK, new Rgb(.1, .6, .05), false),
                new Surface("blue", Rgb.BLACK, new Rgb(.02, .1, .5), false));
        return new Cells(x, y, z).room("coloured cells", air, (i, j, k, side) ->
                side == 3 && i == 0 && k == 1 ? lamp : walls.get((i + 2 * k + side / 2) % 3));
    }

    static Stream<Arguments> cases() {
        return SCENES.keySet().stream().flatMap(scene -> Stream.of(.3, .1).map(error -> Arguments.of(scene, error)));
    }

    private static RadiositySettings settings(double error) {
        return RadiositySettings.defaults().accurate(error);
    }

    @ParameterizedTest
    @MethodSource("cases")
    void finishedSolution_hasNoNegativeRadiosity(String scene, double error) throws IOException {
        assertNonNegative(solve(new LocalWorld(SCENES.get(scene), settings(error), 2), STOP));
    }

    /** Where little light is enough, discarding some points leaves less than that unshot: it must not end there. */
    @ParameterizedTest
    @ValueSource(doubles = {.2, .05, .01})
    void looseStop_leavesNoDiscardedPointDark(double unsent) throws IOException {
        try (LocalWorld world = new LocalWorld(SCENES.get(WINDING), settings(.3), 2)) {
            ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, new StopRule(Integer.MAX_VALUE, unsent));
            rounds.run(progress -> true);
            assertFalse(rounds.progress().gathers());
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void lampsKeptApartAndLights_haveNoNegativeRadiosity(boolean layers) throws IOException {
        Scene scene = SCENES.get(WINDING);
        Light light = new Light("lamp", Light.Kind.POINT, Rgb.grey(.1), new Vec3(.5, .5, .5), new Vec3(0, -1, 0),
                Vec3.ZERO,
                Vec3.ZERO, 1, 0, 0);
        Scene lit = new Scene("lit", scene.points(), scene.corners(), scene.surfaceOf(), scene.surfaces(),
                List.of(light),
                Optional.empty());
        Solution solution = solve(new LocalWorld(lit, settings(.1).layers(layers), 2), STOP);
        assertEquals(layers ? 2 : 1, solution.layers());
        assertNonNegative(solution);
    }

    private static void assertNonNegative(Solution solution) {
        double mean = 0;
        double least = 0;
        for (int i = 0; i < 3 * solution.elements(); i++) {
            for (int layer = 0; layer < solution.layers(); layer++) {
                Rgb h = solution.irradianceAt(solution.corners()[i], layer);
                least = Math.min(least, Math.min(h.r(), Math.min(h.g(), h.b())));
            }
            Rgb b = solution.radiosityAt(i / 3, i % 3);
            mean += (b.r() + b.g() + b.b()) / (9 * solution.elements());
        }
        assertTrue(mean > 0);
        assertEquals(0, Math.min(0, least + 1e-6 * mean), "least irradiance " + least + " W/m2, mean radiosity "
                + mean);
        assertEquals(0, solution.ledger().imbalance(0), 1e-12);
    }

    /** What was discarded is gathered anew by whoever owns it, and is saved as such. */
    @Test
    void discardedPoints_areTheSameOnAnyHostsAndAfterAStop() throws IOException {
        Scene scene = SCENES.get(WINDING);
        Solution local = solve(new LocalWorld(scene, settings(.1), 2), STOP);
        assertSame(local, solve(new LocalWorld(scene, settings(.1), 1, 3), STOP));
        List<SavedState> states = new ArrayList<>();
        ProgressiveRadiosity rounds = new ProgressiveRadiosity(new LocalWorld(scene, settings(.1), 2), STOP,
                Double.MIN_VALUE);
        int[] elements = {0};
        rounds.run(progress -> {
            boolean discarded = progress.gathers() && progress.elements() == elements[0];
            elements[0] = progress.elements();
            if (discarded && states.size() < 12) {
                states.add(state(rounds));
            }
            return true;
        });
        assertTrue(states.size() > 2, "stops while renewed points gather: " + states.size());
        for (int i = 0; i < states.size(); i += 1 + states.size() / 3) {
            ProgressiveRadiosity rest = new ProgressiveRadiosity(new LocalWorld(scene, settings(.1), 1, 2), STOP);
            rest.resume(states.get(i));
            rest.run(progress -> true);
            assertSame(local, rest.solution());
        }
    }

    private static SavedState state(ProgressiveRadiosity rounds) {
        try {
            return rounds.state();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    void hostsThatDie_changeNothingWhereLightIsDiscarded() throws IOException {
        Scene scene = SCENES.get(WINDING);
        Solution local = solve(new LocalWorld(scene, settings(.1), 2), STOP);
        for (int dies : new int[] {Integer.MAX_VALUE, 60}) {
            List<Link> links = TestLink.sound(2, 1);
            links.add(new TestLink("mortal", 1, round -> round == dies));
            try (RemoteWorld world = new RemoteWorld(scene, settings(.1), 1, line -> { }, links, System::nanoTime)) {
                assertSame(local, solve(world, STOP));
            }
        }
    }
}
