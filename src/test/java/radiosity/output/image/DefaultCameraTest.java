package radiosity.output.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import radiosity.output.gltf.Handmade;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;

class DefaultCameraTest {

    private static final Vec3 X = new Vec3(1, 0, 0);
    private static final Vec3 Y = new Vec3(0, 1, 0);
    private static final Vec3 Z = new Vec3(0, 0, 1);

    private static float[] picture(Solution solution) {
        return Snapshot.take(solution, DefaultCamera.of(solution), 64, UnaryOperator.identity()).rgb();
    }

    private static double lit(Solution solution) {
        float[] rgb = picture(solution);
        int lit = 0;
        for (int i = 0; i < rgb.length; i += 3) {
            lit += rgb[i] > 0 ? 1 : 0;
        }
        return 3.0 * lit / rgb.length;
    }

    @Test
    void cameraOfTheScene_isTaken() {
        Camera camera = new Camera(Vec3.ZERO, X, Y, .4, 2);
        assertSame(camera, DefaultCamera.of(Handmade.room(Vec3.ZERO, 1, p -> Rgb.grey(1)).solution(camera)));
    }

    @Test
    void room_isLookedInto_soThatFiveWallsAreSeen() {
        Vec3 low = new Vec3(100, 200, 300);
        Handmade room = new Handmade();
        Vec3[][] walls = {{low, Z, X}, {low.plus(Y), X, Z}, {low, Y, Z}, {low.plus(X), Z, Y}, {low, X, Y},
            {low.plus(Z), Y, X}};
        for (int w = 0; w < 6; w++) {
            double brightness = 10 + w;
            room.grid(room.surface("wall " + w, 0.5), walls[w][0], walls[w][1], walls[w][2], 1, 1,
                    p -> Rgb.grey(2 * brightness));
        }
        Map<Float, Integer> pixels = new HashMap<>();
        for (float b : picture(room.solution())) {
            pixels.merge(b, 1, Integer::sum);
        }
        pixels.keySet().removeIf(b -> b < 10 || b != Math.rint(b));
        pixels.values().removeIf(count -> count < 90);
        assertEquals(5, pixels.size(), pixels.toString());
    }

    @Test
    void roomWithClosedOutside_isSeenFromInside() {
        Handmade room = Handmade.room(Vec3.ZERO, 1, p -> Rgb.grey(1));
        int outside = room.surface("outside", Rgb.BLACK, Rgb.BLACK, false);
        Vec3 low = new Vec3(-.1, -.1, -.1);
        Vec3[] edges = {X.times(1.2), Y.times(1.2), Z.times(1.2)};
        for (int a = 0; a < 3; a++) {
            Vec3 u = edges[a];
            Vec3 v = edges[(a + 1) % 3];
            room.grid(outside, low, v, u, 1, 1, p -> Rgb.BLACK);
            room.grid(outside, low.plus(edges[(a + 2) % 3]), u, v, 1, 1, p -> Rgb.BLACK);
        }
        Solution solution = room.solution();
        Vec3 eye = DefaultCamera.of(solution).position();
        assertTrue(Math.max(eye.x(), Math.max(eye.y(), eye.z())) < 1
                && Math.min(eye.x(), Math.min(eye.y(), eye.z())) > 0,
                "eye at " + eye);
        assertTrue(lit(solution) > .95);
    }

    @Test
    void floor_isSeenFromAbove() {
        Handmade made = new Handmade();
        made.grid(made.surface("floor", .5), Vec3.ZERO, Z, X, 2, 2, p -> Rgb.grey(1));
        Solution floor = made.solution();
        assertTrue(DefaultCamera.of(floor).position().y() > 0);
        assertTrue(lit(floor) > .3);
    }

    @Test
    void sceneThatIsAPoint_orEmpty_hasAView() {
        assertTrue(DefaultCamera.of(new Handmade().solution()).position().isFinite());
    }
}
