package radiosity.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.Radiosity;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;

/** The light of the Cornell box follows what is done to it. */
@Tag("slow")
class LightFollowerTest {

    private static final double ERROR = 0.1;
    private static final RadiositySettings SETTINGS = RadiositySettings.defaults().accurate(ERROR);
    private static final int TALL = 1;
    private static final Edit MOVED = new Edit.Moved(TALL, new Vec3(370, 0, -350), 0.3, new Vec3(-60, 0, 40));

    private final Scene scene = box();
    private final List<Solution> shown = Collections.synchronizedList(new ArrayList<>());
    private final BlockingQueue<LightFollower.Rest> rests = new LinkedBlockingQueue<>();
    private final List<String> failures = Collections.synchronizedList(new ArrayList<>());

    private static Scene box() {
        try {
            return Radiosity.read(Path.of("scenes/cornell-box.lws"), line -> { });
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private LightFollower follower() {
        return new LightFollower(SavedState.NONE, SETTINGS, 2, shown::add, rests::add, failures::add);
    }

    private LightFollower.Rest rest() throws InterruptedException {
        LightFollower.Rest rest = rests.poll(120, TimeUnit.SECONDS);
        assertNotNull(rest, failures.toString());
        return rest;
    }

    /** Two solutions that are each off by an error differ by no more than both together. */
    @Test
    void lightAtRest_isThatOfARenderAnew() throws Exception {
        EditHistory history = new EditHistory(scene);
        Solution changed;
        try (LightFollower follower = follower()) {
            follower.follow(scene);
            assertFalse(rest().anew().isEmpty());
            shown.clear();
            history.add(MOVED);
            history.add(new Edit.Painted(0, new Rgb(.3, .5, .6)));
            follower.follow(history.scene());
            LightFollower.Rest rest = rest();
            assertEquals("", rest.anew());
            assertTrue(rest.close() <= rest.seconds() && rest.first() <= rest.close(), rest.text());
            assertTrue(rest.difference() > 0.01, "the first picture lacks what is reflected: " + rest.text());
            changed = rest.solution();
            assertSame(changed, shown.get(shown.size() - 1));
        }
        Solution anew = Radiosity.of(history.scene()).settings(SETTINGS).run(progress -> true).solution();
        double[] places = LightDifference.places(history.scene(), 1000);
        double[] expected = LightDifference.radiosity(anew, places);
        double difference = LightDifference.of(expected, LightDifference.radiosity(changed, places));
        assertTrue(difference < 2 * ERROR, "differs by " + difference);
    }

    @Test
    void furtherEdit_endsTheOneUnderWay() throws Exception {
        Scene moved = MOVED.of(scene);
        try (LightFollower follower = follower()) {
            follower.follow(moved);
            follower.follow(scene);
            assertSame(scene, rest().solution().scene());
            assertTrue(rests.isEmpty() && failures.isEmpty(), failures.toString());
        }
    }

    /** Places come faster than pictures, and each ends the one before. */
    @Test
    void movingHand_getsPictures() throws Exception {
        try (LightFollower follower = new LightFollower(SavedState.NONE, SETTINGS.accurate(0.05), 2, shown::add,
                rests::add, failures::add)) {
            follower.follow(scene);
            rest();
            shown.clear();
            Scene last = scene;
            for (int i = 1; shown.isEmpty() && i < 2000; i++) {
                last = new Edit.Moved(TALL, Vec3.ZERO, 0, new Vec3(0, 0.01 * i, 0)).of(scene);
                follower.follow(last, true);
                Thread.sleep(10);
            }
            assertFalse(shown.isEmpty(), failures.toString());
            follower.follow(scene);
            LightFollower.Rest rest = rest();
            assertSame(scene, rest.solution().scene());
            assertTrue(rest.close() <= rest.seconds() && failures.isEmpty(), rest.text());
        }
    }

    @Test
    void undoneEdit_leavesTheSameScene() {
        EditHistory history = new EditHistory(scene);
        history.add(MOVED);
        assertEquals(List.of(MOVED), history.edits());
        assertTrue(history.undo());
        assertSame(scene, history.scene());
        assertFalse(history.undo());
    }

    @Test
    void movedObject_takesNothingElseAlong() {
        Scene moved = MOVED.of(scene);
        boolean[] isTall = ObjectTriangles.triangles(scene, TALL);
        int of = 0;
        for (int t = 0; t < isTall.length; t++) {
            for (int k = 0; k < 3; k++) {
                Vec3 from = scene.corner(t, k);
                Vec3 d = from.minus(new Vec3(370, 0, -350));
                double c = Math.cos(0.3);
                double s = Math.sin(0.3);
                Vec3 to = new Vec3(310 + c * d.x() + s * d.z(), d.y(), -310 - s * d.x() + c * d.z());
                assertEquals(0, moved.corner(t, k).minus(isTall[t] ? to : from).length(), isTall[t] ? 1e-9 : 0);
            }
            of += isTall[t] ? 1 : 0;
        }
        assertEquals(10, of, "triangles of the block");
    }
}
