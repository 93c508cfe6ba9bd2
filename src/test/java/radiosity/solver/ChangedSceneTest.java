package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.testkit.ColouredRoom.assertSame;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.edit.LightDifference;
import radiosity.master.RemoteWorld;
import radiosity.master.host.Link;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.StopRule;
import radiosity.solution.EnergyLedger;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.testkit.ColouredRoom;
import radiosity.testkit.Edits;
import radiosity.testkit.Evaluate;
import radiosity.testkit.TestLink;

/**
 * A solution that is changed with its scene is, within the error that was asked for, that of a render anew: the root
 * mean square difference of two solutions that each are off by {@value #ERROR} is at most the sum of both.
 */
@Tag("slow")
class ChangedSceneTest {

    private static final double ERROR = 0.02;
    private static final RadiositySettings SETTINGS = RadiositySettings.defaults().accurate(ERROR);
    private static final StopRule STOP = new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT);
    private static final Scene ROOM = ColouredRoom.SCENE;
    private static final SavedState OLD = anew(ROOM).state();
    private static final IntPredicate BLOCK = Edits.surface(ROOM, "block");
    private static final IntPredicate LAMP = Edits.surface(ROOM, "lamp");

    private static Solution anew(Scene scene) {
        try (LocalWorld world = new LocalWorld(scene, SETTINGS, 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            radiosity.run(progress -> true);
            return radiosity.solution();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private static Solution changed(Scene scene, SavedState from, int threads, int parts) throws IOException {
        return changed(new LocalWorld(scene, SETTINGS, threads, parts), from);
    }

    private static Solution changed(World ofScene, SavedState from) throws IOException {
        try (World world = ofScene) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            assertEquals(Optional.empty(), radiosity.change(from));
            radiosity.run(progress -> true);
            return radiosity.solution();
        }
    }

    private static void assertAsAnew(Scene scene) throws IOException {
        Solution anew = anew(scene);
        Solution changed = changed(scene, OLD, 2, 1);
        assertAlike(anew, changed);
        double least = DoubleStream.of(changed.irradiance()).min().orElseThrow();
        assertTrue(least >= -1e-6 * DoubleStream.of(changed.irradiance()).average().orElseThrow(), "least " + least);
        EnergyLedger ledger = changed.ledger();
        for (int c = 0; c < 3; c++) {
            assertEquals(0, ledger.imbalance(c), 1e-12);
            assertTrue(Math.abs(ledger.deficit(c) - anew.ledger().deficit(c)) < 2e-3 * ledger.emitted()[c],
                    "no energy is gained or lost");
        }
    }

    private static void assertAlike(Solution expected, Solution got) {
        double[] places = LightDifference.places(expected.scene(), 4000);
        double[] a = Evaluate.radiosity(expected, places);
        double[] b = Evaluate.radiosity(got, places);
        double sum = 0;
        double squares = 0;
        int count = 0;
        for (int i = 0; i < a.length; i++) {
            if (!Double.isNaN(a[i]) && !Double.isNaN(b[i])) {
                sum += a[i];
                squares += (a[i] - b[i]) * (a[i] - b[i]);
                count++;
            }
        }
        double difference = Math.sqrt(squares / count) / (sum / count);
        assertTrue(difference < 2 * ERROR, "difference " + difference);
    }

    private static Scene repainted() {
        return Edits.with(ROOM, "wall 3",
                s -> new Surface(s.name(), s.exitance(), new Rgb(.1, .2, .7), s.twoSided()));
    }

    private static Scene blockMoved() {
        return Edits.moved(ROOM, BLOCK, new Vec3(-0.05, 0, 0.25));
    }

    @Test
    void nothingChanged_isTakenOverAsItIs() throws IOException {
        Solution changed = changed(ROOM, OLD, 2, 1);
        assertEquals(OLD, changed.state());
    }

    @Test
    void repaintedWall_isAsAnew() throws IOException {
        assertAsAnew(repainted());
    }

    @Test
    void brighterLamp_isAsAnew() throws IOException {
        assertAsAnew(Edits.with(ROOM, "lamp",
                s -> new Surface(s.name(), new Rgb(1.5, 1, .6), s.reflectance(), s.twoSided())));
    }

    @Test
    void movedBlock_isAsAnew() throws IOException {
        assertAsAnew(blockMoved());
    }

    @Test
    void removedBlock_isAsAnew() throws IOException {
        assertAsAnew(Edits.without(ROOM, BLOCK));
    }

    /** Nothing is left of the light of a room when its only lamp is gone. */
    @Test
    void onlyLampMoved_isRenderedAnew() throws IOException {
        try (LocalWorld world = new LocalWorld(Edits.moved(ROOM, LAMP, new Vec3(-0.05, 0, 0)), SETTINGS, 2)) {
            String why = new ProgressiveRadiosity(world, STOP).change(OLD).orElseThrow();
            assertTrue(why.matches("light has changed by \\d+ % of what is emitted"), why);
        }
    }

    @Test
    void thereAndBackAgain_isAsBefore() throws IOException {
        SavedState there = changed(blockMoved(), OLD, 2, 1).state();
        assertAlike(anew(ROOM), changed(ROOM, there, 2, 1));
    }

    @Test
    void anyThreadsAndPartitions_giveTheSameBits() throws IOException {
        for (Scene scene : List.of(repainted(), blockMoved())) {
            Solution one = changed(scene, OLD, 1, 1);
            assertSame(one, changed(scene, OLD, 2, 3));
            assertSame(one, changed(scene, OLD, 1, 7));
        }
    }

    @Test
    void stoppedOnTheWay_endsWithTheSameBits() throws IOException {
        try (LocalWorld world = new LocalWorld(blockMoved(), SETTINGS, 2);
                LocalWorld other = new LocalWorld(blockMoved(), SETTINGS, 1)) {
            ProgressiveRadiosity first = new ProgressiveRadiosity(world, STOP);
            first.change(OLD);
            int elements = first.progress().elements();
            first.run(progress -> progress.elements() == elements);
            ProgressiveRadiosity rest = new ProgressiveRadiosity(other, STOP);
            rest.resume(first.state());
            rest.run(progress -> true);
            assertSame(changed(blockMoved(), OLD, 2, 1), rest.solution());
        }
    }

    @Test
    void overHostsOfWhichOneDies_givesTheSameBits() throws IOException {
        Solution local = changed(blockMoved(), OLD, 2, 1);
        assertSame(local, changed(new RemoteWorld(blockMoved(), SETTINGS, 1, line -> { }, TestLink.sound(1, 2),
                System::nanoTime), OLD));
        TestLink mortal = new TestLink("mortal", 1, round -> round == 4);
        List<Link> links = new ArrayList<>(TestLink.sound(2, 1));
        links.add(mortal);
        assertSame(local, changed(new RemoteWorld(blockMoved(), SETTINGS, 1, line -> { }, links, System::nanoTime),
                OLD));
        assertTrue(mortal.isDead());
    }

    @Test
    void tooMuchChanged_isSaid() throws IOException {
        Scene larger = Edits.moved(ROOM, t -> true, new Vec3(1, 0, 0));
        try (LocalWorld world = new LocalWorld(larger, SETTINGS, 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            assertEquals(Optional.of("the extent of the scene has changed"), radiosity.change(OLD));
            radiosity.run(progress -> true);
            assertArrayEquals(anew(larger).irradiance(), radiosity.solution().irradiance());
        }
    }
}
