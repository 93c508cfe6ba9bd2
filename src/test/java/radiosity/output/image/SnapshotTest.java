package radiosity.output.image;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.UnaryOperator;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.output.gltf.Handmade;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.Specular;
import radiosity.scene.Surface;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.TooLargeException;

class SnapshotTest {

    private static final Vec3 X = new Vec3(1, 0, 0);
    private static final Vec3 Y = new Vec3(0, 1, 0);
    private static final int WIDTH = 16;
    /** From the solution alone, to the end. */
    private static final Snapshot.Drawing PLAIN = new Snapshot.Drawing(0, done -> true);

    @TempDir
    Path folder;

    /** From the +z side at the unit square in the plane z = 0, which fills the picture. */
    private static Camera camera(double distance) {
        return new Camera(new Vec3(.5, .5, distance), new Vec3(0, 0, -1), Y, Math.atan(.5 / distance), 1);
    }

    private static Camera behind() {
        return new Camera(new Vec3(.5, .5, -1), new Vec3(0, 0, 1), Y, Math.atan(.5), 1);
    }

    private static Picture take(Solution solution, Camera camera) {
        return Snapshot.take(solution, camera, WIDTH, UnaryOperator.identity(), PLAIN);
    }

    private static Solution square(Rgb exitance) {
        Handmade made = new Handmade();
        made.grid(made.surface("s", exitance, Rgb.grey(.5), false), Vec3.ZERO, X, Y, 5, 3,
                p -> new Rgb(2 * p.x(), 2 * p.y(), 4));
        return made.solution();
    }

    private static void assertShowsSquare(Picture picture, double error) {
        assertEquals(WIDTH, picture.height());
        for (int i = 0; i < WIDTH * WIDTH; i++) {
            assertEquals((i % WIDTH + .5) / WIDTH, picture.rgb()[3 * i], error);
            assertEquals(1 - (i / WIDTH + .5) / WIDTH, picture.rgb()[3 * i + 1], error);
            assertEquals(2, picture.rgb()[3 * i + 2], error);
        }
    }

    @Test
    void smoothSurface_isShownWithoutStepsBetweenFacets() {
        assertEquals(4, largestStep(0), .01);
        assertTrue(largestStep(.5) < 1, "the step between two facets is spread over their widths");
    }

    /** Between neighbouring pixels of a picture of two facets whose irradiances differ by 8. */
    private static double largestStep(double smoothing) {
        Handmade made = new Handmade();
        int surface = made.surface(new Surface("s", Rgb.BLACK, Rgb.grey(.5), false).smoothed(smoothing));
        made.grid(surface, Vec3.ZERO, new Vec3(.5, 0, .01), Y, 1, 1, p -> Rgb.grey(1));
        made.grid(surface, new Vec3(.5, 0, .01), new Vec3(.5, 0, -.01), Y, 1, 1, p -> Rgb.grey(9));
        Picture picture = take(made.solution(), camera(1));
        double most = 0;
        for (int x = 1; x < WIDTH; x++) {
            int i = 3 * (WIDTH * WIDTH / 2 + x);
            most = Math.max(most, Math.abs(picture.rgb()[i] - picture.rgb()[i - 3]));
        }
        return most;
    }

    @Test
    void everyPixel_showsTheRadiosityBehindIt() {
        assertShowsSquare(take(square(Rgb.BLACK), camera(1)), 1e-5);
    }

    @Test
    void eyeFarAway_seesTheSame() {
        assertShowsSquare(take(square(Rgb.BLACK), camera(1e5)), 1e-3);
    }

    @Test
    void backOfASingleSidedSurface_isSeenThrough() {
        Handmade made = new Handmade();
        made.grid(made.surface("away", .5), new Vec3(0, 0, .5), Y, X, 1, 1, p -> Rgb.grey(100));
        made.grid(made.surface("wall", .5), Vec3.ZERO, X, Y, 1, 1, p -> Rgb.grey(6));
        float[] rgb = take(made.solution(), camera(1)).rgb();
        float[] wall = new float[rgb.length];
        Arrays.fill(wall, 3);
        assertArrayEquals(wall, rgb, 1e-5f);
    }

    @Tag("slow")
    @Test
    void twoSidedSurface_showsTheLightOfTheSideThatIsSeen() {
        Handmade made = new Handmade();
        int t = made.triangle(made.surface("s", Rgb.BLACK, Rgb.grey(.5), true), new Vec3(-9, -9, 0),
                new Vec3(20, -9, 0), new Vec3(-9, 20, 0));
        Vec3[] corners = {new Vec3(-9, -9, 0), new Vec3(20, -9, 0), new Vec3(-9, 20, 0)};
        int[] front = Arrays.stream(corners).mapToInt(p -> made.vertex(p, Rgb.grey(4))).toArray();
        int[] back = Arrays.stream(corners).mapToInt(p -> made.vertex(p, Rgb.grey(8))).toArray();
        made.element(2 * t, front[0], front[1], front[2]);
        made.element(2 * t + 1, back[0], back[2], back[1]);
        Solution sheet = made.solution();
        for (int i = 0; i < 3 * WIDTH * WIDTH; i++) {
            assertEquals(2, take(sheet, camera(1)).rgb()[i], 1e-5);
            assertEquals(4, take(sheet, behind()).rgb()[i], 1e-5);
        }
    }

    @Test
    void emptiness_isBlack() {
        assertArrayEquals(new float[3 * WIDTH * WIDTH], take(square(Rgb.BLACK), behind()).rgb());
        assertArrayEquals(new float[3 * WIDTH * WIDTH], take(new Handmade().solution(), camera(1)).rgb());
    }

    @Test
    void picture_isTheSameEveryTime() {
        Solution room = Handmade.room(Vec3.ZERO, 1, p -> new Rgb(p.x(), p.y(), p.z())).solution();
        assertArrayEquals(take(room, camera(3)).rgb(), take(room, camera(3)).rgb());
    }

    @Test
    void height_followsFromTheAspect() {
        Camera wide = new Camera(new Vec3(.5, .5, 1), new Vec3(0, 0, -1), Y, .5, 1.6);
        assertEquals(10, take(square(Rgb.BLACK), wide).height());
    }

    /** 800 x 1,200,000 pixels. */
    @Test
    void pictureThatNoArrayHolds_isRefusedBeforeAnyRay() {
        Camera narrow = new Camera(new Vec3(.5, .5, 1), new Vec3(0, 0, -1), Y, .5, 1 / 1500.0);
        TooLargeException e = assertThrows(TooLargeException.class, () -> Snapshot.take(square(Rgb.BLACK), narrow, 800,
                light -> light, PLAIN));
        assertEquals("picture of 800x1200000 pixels: expected at most 2,147,483,639 numbers, got 2,880,000,000",
                e.getMessage());
    }

    @Test
    void pngAndJpg_holdSrgb() throws IOException {
        ToneMapping tones = new ToneMapping(ToneMapping.Operator.LINEAR, .25);
        for (String name : new String[] {"a.png", "a.jpg", "a.JPEG"}) {
            Path file = folder.resolve(name);
            Snapshot.write(file, square(Rgb.BLACK), camera(1), WIDTH, tones, PLAIN);
            BufferedImage image = ImageIO.read(file.toFile());
            assertEquals(WIDTH, image.getWidth());
            assertEquals(188, image.getRGB(8, 8) & 255, 2);
            assertEquals(ToneMapping.srgb(.25 / 32), image.getRGB(0, 0) >> 16 & 255, name.endsWith("png") ? 0 : 40);
        }
    }

    @Test
    void edges_areSmoothedAfterToneMapping() throws IOException {
        Path file = folder.resolve("a.png");
        Camera half = new Camera(new Vec3(1 + .5 / WIDTH, .5, 1), new Vec3(0, 0, -1), Y, Math.atan(.5), 1);
        Snapshot.write(file, square(Rgb.grey(1e6)), half, WIDTH, new ToneMapping(ToneMapping.Operator.LINEAR, 1),
                PLAIN);
        int edge = ImageIO.read(file.toFile()).getRGB(7, 8) & 255;
        assertTrue(edge > 100 && edge < 240, "edge of a bright lamp: " + edge);
    }

    @Test
    void hdr_isNotClamped() throws IOException {
        Path file = folder.resolve("a.hdr");
        Snapshot.write(file, square(new Rgb(5e6, 3e-4, 0)), camera(1), WIDTH,
                new ToneMapping(ToneMapping.Operator.LINEAR, 1e-9), PLAIN);
        byte[] bytes = Files.readAllBytes(file);
        String text = new String(bytes, StandardCharsets.ISO_8859_1);
        assertTrue(text.startsWith("#?RADIANCE\n"));
        int pixels = text.indexOf("-Y 16 +X 16\n") + 12;
        assertEquals(bytes.length, pixels + 4 * WIDTH * WIDTH);
        double unit = Math.scalb(1.0, (bytes[pixels + 3] & 255) - 136);
        assertEquals(5e6, ((bytes[pixels] & 255) + .5) * unit, 5e6 / 128);
        assertEquals(0, bytes[pixels + 1]);
    }

    @Test
    void rgbe_isNearAtEveryBrightness() throws IOException {
        for (float light = 1e-30f; light < 1e30f; light *= 3) {
            byte[] bytes = PictureFormat.HDR.bytes(new Picture(1, 1, new float[] {light, light / 2, 0}), Units.UNKNOWN);
            int p = bytes.length - 4;
            double unit = Math.scalb(1.0, (bytes[p + 3] & 255) - 136);
            assertEquals(light, ((bytes[p] & 255) + .5) * unit, light / 128);
            assertEquals(light / 2, ((bytes[p + 1] & 255) + .5) * unit, light / 128);
        }
        byte[] black = PictureFormat.HDR.bytes(new Picture(1, 1, new float[3]), Units.UNKNOWN);
        assertEquals(0, black[black.length - 1]);
    }

    @Test
    void otherFormats_areRefusedInOneLine() {
        Path gif = folder.resolve("a.gif");
        String message = assertThrows(IOException.class,
                () -> Snapshot.write(gif, square(Rgb.BLACK), camera(1), WIDTH, null, PLAIN)).getMessage();
        assertEquals(gif + ": expected a name that ends in .png, .jpg or .hdr, got a.gif", message);
    }

    /** A wall in the plane z = 2, seen in a mirror in the plane z = 0, and another one that is seen through its back. */
    private static Solution mirror(boolean isThere) {
        Handmade made = new Handmade();
        Specular all = new Specular(Rgb.grey(1), Rgb.BLACK, 0, 0, 1, false);
        if (isThere) {
            made.grid(made.surface(new Surface("mirror", Rgb.BLACK, Rgb.BLACK, false).with(Optional.of(all))),
                    new Vec3(-9, -9, 0), new Vec3(20, 0, 0), new Vec3(0, 20, 0), 1, 1, p -> Rgb.BLACK);
        }
        made.grid(made.surface("wall", .5), new Vec3(-9, -9, 2), new Vec3(0, 20, 0), new Vec3(20, 0, 0), 3, 2,
                p -> new Rgb(20 + p.x(), 20 + p.y(), 4));
        return made.solution();
    }

    /** As an eye behind the mirror would see it, left and right exchanged. */
    @Test
    void mirror_showsWhatAnEyeBehindItSees() {
        float[] mirrored = take(mirror(true), camera(1)).rgb();
        float[] behind = take(mirror(false), behind()).rgb();
        for (int i = 0; i < behind.length; i++) {
            int pixel = i / 3;
            int other = pixel / WIDTH * WIDTH + WIDTH - 1 - pixel % WIDTH;
            assertEquals(behind[3 * other + i % 3], mirrored[i], 1e-6 * behind[3 * other + i % 3]);
        }
    }

    @Test
    void picturesOfTheSecondPass_areTheSameBitsOnAnyNumberOfThreads() {
        float[] many = Snapshot.take(mirror(true), camera(1), WIDTH, light -> light,
                new Snapshot.Drawing(20, 8, done -> true)).rgb();
        float[] alone = Snapshot.take(mirror(true), camera(1), WIDTH, light -> light,
                new Snapshot.Drawing(20, 1, done -> true)).rgb();
        assertArrayEquals(many, alone);
    }

    @Test
    void oneThread_drawsAlone() {
        Set<Thread> drawing = ConcurrentHashMap.newKeySet();
        Snapshot.take(square(Rgb.BLACK), camera(1), WIDTH, light -> light, new Snapshot.Drawing(4, 1, done -> {
            drawing.add(Thread.currentThread());
            return true;
        }));
        assertEquals(Set.of(Thread.currentThread()), drawing);
    }

    /** In the open, with nothing around, a surface gets nothing: only what it emits is seen. */
    @Test
    void gatheredLight_takesThePlaceOfTheMeshs() {
        float[] rgb = Snapshot.take(square(Rgb.grey(3)), camera(1), WIDTH, light -> light,
                new Snapshot.Drawing(4, done -> true)).rgb();
        float[] emitted = new float[rgb.length];
        Arrays.fill(emitted, 3);
        assertArrayEquals(emitted, rgb, 1e-6f);
    }

    @Test
    void numbersOfRaysThatCannotBe_areRefused() {
        for (int rays : new int[] {-1, 1_000_001, Integer.MIN_VALUE}) {
            assertEquals("gathered rays: expected a number from 0 to 1000000, got " + rays,
                    assertThrows(IllegalArgumentException.class, () -> new Snapshot.Drawing(rays, done -> true))
                            .getMessage());
        }
    }

    @Test
    void pictureThatIsNotWantedAnyMore_isNotWritten() {
        Path file = folder.resolve("a.png");
        List<Double> parts = Collections.synchronizedList(new ArrayList<>());
        assertThrows(CancellationException.class, () -> Snapshot.write(file, square(Rgb.BLACK), camera(1), WIDTH,
                new ToneMapping(ToneMapping.Operator.LINEAR, 1), new Snapshot.Drawing(0, done -> {
                    parts.add(done);
                    return done < .5;
                })));
        assertTrue(!Files.exists(file));
        assertTrue(parts.get(0) > 0 && parts.get(0) < .2, parts.toString());
    }
}
