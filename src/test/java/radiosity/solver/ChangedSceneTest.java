package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.testkit.ColouredRoom.assertSame;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.IntPredicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
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
import radiosity.testkit.Changing;
import radiosity.testkit.ColouredRoom;
import radiosity.testkit.Edits;
import radiosity.testkit.TestLink;

/** A solution that is changed with its scene is that of a render anew, within the error that was asked for. */
@Tag("slow")
class ChangedSceneTest {

    private static final double ERROR = 0.02;
    private static final Changing CHANGING = new Changing(ERROR);
    private static final RadiositySettings SETTINGS = CHANGING.settings();
    private static final StopRule STOP = Changing.STOP;
    private static final Scene ROOM = ColouredRoom.SCENE;
    private static final SavedState OLD = CHANGING.anew(ROOM).state();
    private static final IntPredicate BLOCK = Edits.surface(ROOM, "block");
    private static final IntPredicate LAMP = Edits.surface(ROOM, "lamp");

    private static Solution changed(Scene scene, SavedState from, int threads, int parts) throws IOException {
        return CHANGING.changed(new LocalWorld(scene, SETTINGS, threads, parts), from);
    }

    private static void assertAsAnew(Scene scene) throws IOException {
        CHANGING.assertAsAnew(scene, OLD);
    }

    /** Faces that are cut otherwise are not divided more and more finely. */
    @Test
    void movedToAndFro_hasNoMoreAndMoreElements() throws IOException {
        Solution last = changed(blockMoved(), OLD, 2, 1);
        int once = last.elements();
        for (int i = 0; i < 3; i++) {
            last = changed(i % 2 == 0 ? ROOM : blockMoved(), last.state(), 2, 1);
        }
        assertTrue(last.elements() < 1.5 * once, once + " elements became " + last.elements());
    }

    @Test
    void changeThatIsNotWantedAnyMore_ends() throws IOException {
        try (LocalWorld world = new LocalWorld(blockMoved(), SETTINGS, 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            assertThrows(CancellationException.class, () -> radiosity.change(OLD, null, () -> false));
        }
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

    /** Those that would be divided again at once are no finer than they need to be. */
    @Test
    void elements_stayWhereLittleChanged() throws IOException {
        Scene scene = Edits.with(ROOM, "block",
                s -> new Surface(s.name(), s.exitance(), Rgb.grey(0.71), s.twoSided()));
        try (LocalWorld old = new LocalWorld(ROOM, SETTINGS, 2);
                LocalWorld world = new LocalWorld(scene, SETTINGS, 2)) {
            ProgressiveRadiosity before = new ProgressiveRadiosity(old, STOP);
            before.resume(OLD);
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            radiosity.change(OLD);
            int kept = radiosity.progress().elements();
            assertTrue(kept > 0.98 * before.progress().elements(), kept + " elements are left");
        }
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

    /** Faces have other numbers after the move, and the light comes from no face. */
    @Test
    void blockMovedBeforeALight_isAsAnew() throws IOException {
        Vec3 at = new Vec3(0.278, 0.5, -0.1);
        Light light = new Light("bulb", Light.Kind.POINT, Rgb.grey(0.3), at, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, 1, 0, 0);
        Scene room = ROOM.with(ROOM.surfaces(), List.of(light));
        Scene moved = Edits.moved(room, BLOCK, new Vec3(-0.05, 0, 0.25));
        CHANGING.assertAsAnew(moved, CHANGING.anew(room).state());
    }

    @Test
    void removedBlock_isAsAnew() throws IOException {
        assertAsAnew(Edits.without(ROOM, BLOCK));
    }

    /** Nothing is left of the light of a room when its only lamp is gone. */
    @Test
    void onlyLampMoved_isRenderedAnew() throws IOException {
        String why = CHANGING.obstacle(Edits.moved(ROOM, LAMP, new Vec3(-0.05, 0, 0)), OLD);
        assertTrue(why.matches("light has changed by \\d+ % of what is emitted"), why);
    }

    @Test
    void thereAndBackAgain_isAsBefore() throws IOException {
        SavedState there = changed(blockMoved(), OLD, 2, 1).state();
        CHANGING.assertAlike(CHANGING.anew(ROOM), changed(ROOM, there, 2, 1));
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
        assertSame(local, CHANGING.changed(new RemoteWorld(blockMoved(), SETTINGS, 1, line -> { }, TestLink.sound(1, 2),
                System::nanoTime), OLD));
        TestLink mortal = new TestLink("mortal", 1, round -> round == 4);
        List<Link> links = new ArrayList<>(TestLink.sound(2, 1));
        links.add(mortal);
        assertSame(local, CHANGING.changed(new RemoteWorld(blockMoved(), SETTINGS, 1, line -> { }, links,
                System::nanoTime), OLD));
        assertTrue(mortal.isDead());
    }

    @Test
    void tooMuchChanged_isSaid() throws IOException {
        Scene larger = Edits.moved(ROOM, t -> true, new Vec3(1, 0, 0));
        try (LocalWorld world = new LocalWorld(larger, SETTINGS, 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            assertEquals(Optional.of("the extent of the scene has changed"), radiosity.change(OLD));
            radiosity.run(progress -> true);
            assertArrayEquals(CHANGING.anew(larger).irradiance(), radiosity.solution().irradiance());
        }
    }
}
