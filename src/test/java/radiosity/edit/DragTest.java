package radiosity.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import radiosity.Radiosity;
import radiosity.scene.Camera;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.Aabb;

/** What is under the mouse in the Cornell box, and where the mouse takes it. */
class DragTest {

    private static final int SHORT = 1;
    private static final int HEIGHT = 500;

    private final Scene scene = box();
    private final Camera camera = scene.camera().orElseThrow();
    private final Aabb block = ObjectTriangles.box(scene, SHORT);

    private static Scene box() {
        try {
            return Radiosity.read(Path.of("scenes/cornell-box.lws"), line -> { });
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private Drag drag() {
        return new Drag(scene, SHORT, block.centre());
    }

    /** Where a point is in the picture, in pixels to the right and downwards of its middle. */
    private double[] pixel(Vec3 point) {
        Vec3 sight = point.minus(camera.position());
        double scale = HEIGHT / 2.0 / Math.tan(camera.verticalHalfAngle()) / sight.dot(camera.forward());
        return new double[] {scale * sight.dot(camera.forward().cross(camera.up())), -scale * sight.dot(camera.up())};
    }

    @Test
    void ray_meetsTheVisibleSideThatIsNearest() {
        Vec3 eye = camera.position();
        Picked picked = Picked.of(scene, eye, block.centre().minus(eye)).orElseThrow();
        assertEquals(SHORT, scene.hierarchy().of(picked.triangle()));
        assertTrue(picked.point().z() > block.low().z() && picked.point().z() <= block.high().z() + 1e-9);
        assertTrue(Picked.of(scene, new Vec3(278, 450, -900), new Vec3(0, 0, 1)).isEmpty(),
                "the back wall from behind, then out of the open side");
    }

    @Test
    void room_isNotDragged() {
        assertTrue(Drag.isTooLarge(scene, 0));
        assertFalse(Drag.isTooLarge(scene, 1) || Drag.isTooLarge(scene, 2));
    }

    @Test
    void draggedAside_staysUnderTheMouse() {
        Drag drag = drag();
        double before = pixel(block.centre())[0];
        drag.move(Drag.Hand.LEVEL, -20, 0, camera, HEIGHT);
        drag.move(Drag.Hand.LEVEL, 10, 0, camera, HEIGHT);
        Edit.Moved moved = drag.edit();
        assertEquals(0, moved.by().y());
        assertEquals(before - 10, pixel(block.centre().plus(moved.by()))[0], 1e-9);
    }

    @Test
    void draggedUpThePicture_goesAway() {
        Drag drag = drag();
        drag.move(Drag.Hand.LEVEL, 0, -3, camera, HEIGHT);
        Vec3 by = drag.edit().by();
        assertTrue(by.dot(camera.forward()) > 1, by.toString());
        assertEquals(0, by.y());
    }

    @Test
    void lifted_goesUpOnly() {
        Drag drag = drag();
        assertEquals(Vec3.ZERO, drag.edit().by());
        drag.move(Drag.Hand.UPRIGHT, 50, -30, camera, HEIGHT);
        Vec3 by = drag.edit().by();
        assertEquals(pixel(block.centre())[1] - 30, pixel(block.centre().plus(by))[1], 1e-9);
        assertEquals(0, Math.abs(by.x()) + Math.abs(by.z()));
    }

    @Test
    void turned_staysWhereItIs() {
        Drag drag = drag();
        drag.move(Drag.Hand.TURN, 50, 3, camera, HEIGHT);
        assertEquals(new Edit.Moved(SHORT, block.centre(), 0.5, Vec3.ZERO), drag.edit());
    }

    /** Nor through the floor; the hand goes on, and takes the object along on its way back. */
    @Test
    void draggedOut_stopsAtTheWalls() {
        Drag drag = drag();
        drag.move(Drag.Hand.LEVEL, -10_000, 0, camera, HEIGHT);
        drag.move(Drag.Hand.UPRIGHT, 0, 10_000, camera, HEIGHT);
        Vec3 by = drag.edit().by();
        assertEquals(0, by.y());
        Aabb moved = ObjectTriangles.box(drag.edit().of(scene), SHORT);
        Aabb room = ObjectTriangles.box(scene, 0);
        for (int a = 0; a < 3; a++) {
            assertTrue(moved.low().coordinate(a) >= room.low().coordinate(a), moved.toString());
            assertTrue(moved.high().coordinate(a) <= room.high().coordinate(a), moved.toString());
        }
        drag.move(Drag.Hand.LEVEL, 10_000, 0, camera, HEIGHT);
        assertEquals(0, drag.edit().by().length(), 1e-6);
    }
}
