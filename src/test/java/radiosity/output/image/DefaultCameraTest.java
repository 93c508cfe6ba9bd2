package radiosity.output.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
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
        return Snapshot.take(solution, DefaultCamera.of(solution), 64, UnaryOperator.identity(),
                new Snapshot.Drawing(0, done -> true)).rgb();
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

    /** Brightness of the first wall, of the next one and so on; and of what stands in a room. */
    private static final int WALL = 10;
    private static final int BLOCK = 20;
    /** What a surface must fill of a picture to be seen, and what no object may fill. */
    private static final double SEEN = 0.01;
    private static final double TOO_LARGE = 1.0 / 3;

    /** A scene of boxes whose surfaces are told apart by their brightness, turned about the three axes, radians. */
    private static final class Boxes {
        private final Handmade made = new Handmade();
        private final double[] angles;

        Boxes(double... angles) {
            this.angles = angles;
        }

        Vec3 turned(Vec3 p) {
            double[] v = {p.x(), p.y(), p.z()};
            for (int axis = 0; axis < 3; axis++) {
                double a = v[(axis + 1) % 3];
                double b = v[(axis + 2) % 3];
                double c = StrictMath.cos(angles[axis]);
                double s = StrictMath.sin(angles[axis]);
                v[(axis + 1) % 3] = a * c - b * s;
                v[(axis + 2) % 3] = a * s + b * c;
            }
            return new Vec3(v[0], v[1], v[2]);
        }

        /** A parallelogram that faces u x v. */
        Boxes face(Vec3 at, Vec3 u, Vec3 v, double brightness, boolean twoSided) {
            int surface = made.surface("s", Rgb.BLACK, Rgb.grey(.5), twoSided);
            made.grid(surface, turned(at), turned(u), turned(v), 1, 1, p -> Rgb.grey(2 * brightness));
            return this;
        }

        /** The first walls of a room, seen from inside: floor, ceiling, back, left, right, front. */
        Boxes room(Vec3 size, int walls, boolean twoSided) {
            Vec3 x = X.times(size.x());
            Vec3 y = Y.times(size.y());
            Vec3 z = Z.times(size.z());
            Vec3[][] all = {{Vec3.ZERO, z, x}, {y, x, z}, {Vec3.ZERO, x, y}, {Vec3.ZERO, y, z}, {x, z, y}, {z, y, x}};
            for (int w = 0; w < walls; w++) {
                face(all[w][0], all[w][1], all[w][2], WALL + w, twoSided);
            }
            return this;
        }

        /** A block without a bottom, seen from outside. */
        Boxes block(Vec3 at, Vec3 size, double brightness) {
            Vec3 x = X.times(size.x());
            Vec3 y = Y.times(size.y());
            Vec3 z = Z.times(size.z());
            return face(at.plus(y), z, x, brightness, false).face(at, y, x, brightness, false)
                    .face(at, z, y, brightness, false).face(at.plus(x), y, z, brightness, false)
                    .face(at.plus(z), x, y, brightness, false);
        }

        /** Shares of the picture by brightness. */
        Map<Integer, Double> picture() {
            return shares(made.solution());
        }

        static Map<Integer, Double> shares(Solution solution) {
            float[] rgb = DefaultCameraTest.picture(solution);
            Map<Integer, Double> shares = new HashMap<>();
            for (int i = 0; i < rgb.length; i += 3) {
                if (rgb[i] == Math.rint(rgb[i])) {
                    shares.merge((int) rgb[i], 3.0 / rgb.length, Double::sum);
                }
            }
            return shares;
        }
    }

    private static double share(Map<Integer, Double> picture, int brightness) {
        return picture.getOrDefault(brightness, 0.0);
    }

    private static long walls(Map<Integer, Double> picture) {
        return picture.entrySet().stream()
                .filter(e -> e.getKey() >= WALL && e.getKey() < BLOCK && e.getValue() > SEEN).count();
    }

    @ParameterizedTest
    @CsvSource({"0,0,0", "30,0,0", "0,30,0", "0,0,30", "30,30,30", "-30,30,30", "30,-30,30", "30,30,-30", "30,60,30",
        "60,30,0", "57,115,172", "40,143,11", "30,189,-30", "178,57,6", "10,45,0", "0,45,45"})
    void turnedRoomWithBlocks_isSeen_noBlockInTheWay(double x, double y, double z) {
        for (int walls = 5; walls <= 6; walls++) {
            for (boolean twoSided : new boolean[] {false, true}) {
                Map<Integer, Double> picture = new Boxes(Math.toRadians(x), Math.toRadians(y), Math.toRadians(z))
                        .room(new Vec3(5.5, 5.5, 5.6), walls, twoSided)
                        .block(new Vec3(.9, 0, .9), new Vec3(1.6, 3.3, 1.6), BLOCK)
                        .block(new Vec3(3, 0, 3.2), new Vec3(1.6, 1.6, 1.6), BLOCK + 1).picture();
                String what = walls + " walls, two-sided " + twoSided + ": " + picture;
                assertTrue(share(picture, BLOCK) < TOO_LARGE && share(picture, BLOCK + 1) < TOO_LARGE, what);
                assertTrue(walls(picture) >= (walls == 5 && !twoSided ? 3 : 4), what);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"0,0,0", "0,30,0", "30,30,30"})
    void corridor_isSeenAlong(double x, double y, double z) {
        Map<Integer, Double> picture = new Boxes(Math.toRadians(x), Math.toRadians(y), Math.toRadians(z))
                .room(new Vec3(2, 2.5, 30), 6, true)
                .block(new Vec3(.2, 0, 8), new Vec3(.9, 1.2, .9), BLOCK)
                .block(new Vec3(.9, 0, 21), new Vec3(.9, 1.8, .9), BLOCK + 1).picture();
        assertTrue(share(picture, BLOCK) < TOO_LARGE && share(picture, BLOCK + 1) < TOO_LARGE, picture.toString());
        assertTrue(walls(picture) >= 4, picture.toString());
    }

    @ParameterizedTest
    @CsvSource({"0,0,0", "0,30,0", "0,200,0", "30,30,30"})
    void roomOfTheShapeOfAnL_isSeenAlongItsLength(double x, double y, double z) {
        Vec3 h = Y.times(3);
        Map<Integer, Double> picture = new Boxes(Math.toRadians(x), Math.toRadians(y), Math.toRadians(z))
                .face(Vec3.ZERO, Z.times(4), X.times(10), WALL, true)
                .face(Z.times(4), Z.times(6), X.times(4), WALL + 1, true)
                .face(h, X.times(10), Z.times(4), WALL + 2, true)
                .face(h.plus(Z.times(4)), X.times(4), Z.times(6), WALL + 3, true)
                .face(Vec3.ZERO, X.times(10), h, WALL + 4, true)
                .face(Vec3.ZERO, h, Z.times(10), WALL + 5, true)
                .face(X.times(10), Z.times(4), h, WALL + 6, true)
                .face(new Vec3(4, 0, 4), h, X.times(6), WALL + 7, true)
                .face(new Vec3(4, 0, 4), Z.times(6), h, WALL + 8, true)
                .face(Z.times(10), h, X.times(4), WALL + 9, true)
                .block(new Vec3(1, 0, 1), new Vec3(1, 1.5, 1), BLOCK).picture();
        assertTrue(share(picture, BLOCK) < TOO_LARGE, picture.toString());
        assertTrue(walls(picture) >= 5, picture.toString());
    }

    @ParameterizedTest
    @CsvSource({"0,0,0", "0,30,0", "0,45,0"})
    void objectInTheOpen_isSeenFromOutside(double x, double y, double z) {
        Solution open = new Boxes(Math.toRadians(x), Math.toRadians(y), Math.toRadians(z))
                .face(new Vec3(-5, 0, -5), Z.times(10), X.times(10), WALL, false)
                .block(new Vec3(-1, 0, -1), new Vec3(2, 2, 2), BLOCK).made.solution();
        Map<Integer, Double> picture = Boxes.shares(open);
        Vec3 eye = DefaultCamera.of(open).position();
        assertTrue(eye.y() > 2 && eye.length() > 7, "eye at " + eye);
        assertTrue(share(picture, BLOCK) > SEEN && share(picture, BLOCK) < TOO_LARGE, picture.toString());
        assertTrue(share(picture, WALL) > .2, picture.toString());
    }
}
