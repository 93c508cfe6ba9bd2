package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.viewer.Rendered.SIZE;
import static radiosity.viewer.Rendered.black;
import static radiosity.viewer.Rendered.brightness;
import static radiosity.viewer.Rendered.difference;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The window on the Cornell box, used by key and mouse on a display in memory. */
class WindowTest {

    /** Half the window shows the left wall at this height, and so on; pixels. */
    private static final int LEFT = SIZE / 10;
    private static final int RIGHT = SIZE - SIZE / 10;
    private static final int MIDDLE = SIZE / 2;

    @TempDir
    static Path folder;

    private static Xvfb display;
    private static Process process;
    private static PrintWriter to;
    private static BufferedReader from;
    private static Path scene;

    @BeforeAll
    static void open() throws IOException {
        display = new Xvfb();
        scene = Rendered.cornellBox(folder);
        process = display.program(Session.class, scene.toString(), "" + SIZE, "" + SIZE)
                .redirectError(ProcessBuilder.Redirect.DISCARD).start();
        to = new PrintWriter(process.getOutputStream(), true);
        from = new BufferedReader(new InputStreamReader(process.getInputStream()));
    }

    @AfterAll
    static void close() {
        if (process != null) {
            process.destroy();
        }
        if (display != null) {
            display.close();
        }
    }

    private static String say(String line) throws IOException {
        to.println(line);
        String answer = from.readLine();
        assertNotNull(answer, "the window went away at: " + line);
        return answer;
    }

    private static void tap(String key) throws IOException {
        say("hold " + key + " 40");
    }

    private static BufferedImage shot(String name) throws IOException {
        Path file = folder.resolve(name + ".png");
        say("shot " + file);
        return Rendered.picture(file);
    }

    /** Eye and direction. */
    private static double[] camera() throws IOException {
        return Stream.of(say("camera").split(" ")).mapToDouble(Double::parseDouble).toArray();
    }

    private static Color colour(BufferedImage image, int x, int y) {
        return new Color(image.getRGB(x, y));
    }

    @BeforeEach
    void home() throws IOException {
        tap("HOME");
    }

    @Test
    void cornellBox_isRedOnTheLeftGreenOnTheRightAndBrightestAtTheLamp() throws IOException {
        BufferedImage image = shot("start");
        Color left = colour(image, LEFT, MIDDLE);
        Color right = colour(image, RIGHT, MIDDLE);
        assertTrue(left.getRed() > 2 * left.getGreen() && left.getRed() > 2 * left.getBlue(), left.toString());
        assertTrue(right.getGreen() > 1.2 * right.getRed() && right.getGreen() > 2 * right.getBlue(), right.toString());
        assertEquals(Color.WHITE, colour(image, MIDDLE, SIZE * 57 / 400));
    }

    @Test
    void picture_isTheRenderers() throws IOException {
        double difference = difference(shot("same"), Rendered.picture(folder.resolve("box.png")));
        assertTrue(difference <= 2, "mean difference " + difference + " of 255");
    }

    @Test
    void keyOfTheDisplay_reachesTheWindow() throws IOException {
        double[] start = camera();
        assertEquals("walked", say("real UP"));
        double[] there = camera();
        assertTrue((there[0] - start[0]) * start[3] + (there[2] - start[2]) * start[5] > 0, "ahead");
    }

    @Test
    void heldKey_walksAsFarAsItIsHeld() throws IOException {
        double[] start = camera();
        say("hold UP 150");
        double once = camera()[2] - start[2];
        say("hold UP 300");
        assertEquals(3 * once, camera()[2] - start[2], 1e-9 * Math.abs(once));
    }

    @Test
    void arrowUp_walksAheadAndHomeLeadsBack() throws IOException {
        BufferedImage before = shot("before");
        double[] start = camera();
        say("hold UP 300");
        double[] there = camera();
        double ahead = (there[0] - start[0]) * start[3] + (there[2] - start[2]) * start[5];
        assertTrue(ahead > 10, "walked " + ahead);
        assertEquals(start[1], there[1], "height");
        assertTrue(difference(before, shot("ahead")) > 3, "another picture");
        tap("HOME");
        assertEquals(0, difference(before, shot("back")), 0.01);
    }

    @Test
    void arrowLeft_turnsLeftAndPageUp_looksUp() throws IOException {
        double[] start = camera();
        say("hold LEFT 200");
        double[] left = camera();
        assertTrue(start[5] * left[3] - start[3] * left[5] > 0.05, "turned to the left seen from above");
        say("hold PAGE_UP 200");
        assertTrue(camera()[4] > left[4] + 0.05, "looks higher");
    }

    @Test
    void sideStep_leavesTheDirectionAlone() throws IOException {
        double[] start = camera();
        say("hold D 200");
        double[] right = camera();
        assertEquals(start[5], right[5], 1e-12);
        double aside = (right[0] - start[0]) * -start[5] + (right[2] - start[2]) * start[3];
        assertTrue(aside > 5, "walked " + aside);
    }

    @Test
    void drag_looksAround() throws IOException {
        double[] start = camera();
        say("drag 100 150 160 150");
        double[] turned = camera();
        double sine = start[5] * turned[3] - start[3] * turned[5];
        assertEquals(Math.sin(60.0 * 1.5 / SIZE), sine, 0.02);
    }

    @Test
    void walls_stopTheWalker() throws IOException {
        double[] start = camera();
        say("hold SHIFT+UP 5000");
        double[] end = camera();
        assertTrue(end[2] < start[2] - 500, "walked into the box: " + end[2]);
        assertTrue(end[2] > -560 && shotIsLit(), "stopped before the back wall: " + end[2]);
    }

    private static boolean shotIsLit() throws IOException {
        return brightness(shot("wall")) > 100;
    }

    @Test
    void click_tellsTheLightThere() throws IOException {
        String wall = say("probe " + LEFT + " " + MIDDLE);
        assertTrue(wall.startsWith("surface"), wall);
        double[] b = numbers(wall, "radiosity");
        double[] h = numbers(wall, "irradiance");
        double[] rho = numbers(wall, "reflectance");
        for (int c = 0; c < 3; c++) {
            assertEquals(b[c], rho[c] * h[c], 2e-3 * b[0], wall);
        }
        assertTrue(b[0] > 2 * b[1], "red: " + wall);
        assertEquals("nothing", say("probe 1 1"));
        BufferedImage bare = shot("unprobed");
        say("click " + LEFT + " " + MIDDLE);
        assertTrue(difference(bare, shot("probed")) > 1, "the answer is shown");
    }

    private static double[] numbers(String lines, String name) {
        String line = Stream.of(lines.split("; ")).filter(l -> l.startsWith(name)).findFirst().orElseThrow();
        return Stream.of(line.substring(name.length()).replace("W/m²", "").trim().split(" +"))
                .mapToDouble(Double::parseDouble).toArray();
    }

    @Test
    void keys_changeExposureAndCurve() throws IOException {
        double before = Double.parseDouble(say("exposure"));
        tap("EQUALS");
        tap("EQUALS");
        tap("EQUALS");
        assertEquals(2 * before, Double.parseDouble(say("exposure")), 1e-9 * before);
        BufferedImage reinhard = shot("bright");
        tap("T");
        assertTrue(difference(reinhard, shot("filmic")) > 3, "another curve");
        tap("T");
        tap("T");
        tap("0");
        assertEquals(before, Double.parseDouble(say("exposure")), 1e-9 * before);
    }

    @Test
    void falseColours_areThoseOfTheScale() throws IOException {
        tap("C");
        double[] b = numbers(say("probe " + MIDDLE + " " + SIZE * 2 / 5), "radiosity");
        tap("SPACE");
        double luminance = 0.2126 * b[0] + 0.7152 * b[1] + 0.0722 * b[2];
        double x = 1 + Math.log10(luminance * Double.parseDouble(say("exposure")) / 4) / FalseColour.DECADES;
        Color expected = new Color(FalseColour.turbo(x));
        BufferedImage image = shot("false");
        Color got = colour(image, MIDDLE, SIZE * 2 / 5);
        Color blue = new Color(FalseColour.turbo(0));
        Color least = colour(image, SIZE - 100, 12 + 230);
        assertTrue(Math.abs(blue.getRed() - least.getRed()) + Math.abs(blue.getBlue() - least.getBlue()) < 40,
                "the lower end of the scale: " + least);
        tap("C");
        assertEquals(expected.getRed(), got.getRed(), 4);
        assertEquals(expected.getGreen(), got.getGreen(), 4);
        assertEquals(expected.getBlue(), got.getBlue(), 4);
    }

    @Test
    void wireframe_leavesHolesBetweenTheLines() throws IOException {
        BufferedImage whole = shot("whole");
        tap("X");
        BufferedImage wires = shot("wires");
        tap("X");
        assertTrue(black(wires) > black(whole) + 0.3, black(wires) + " of the picture is black");
        assertTrue(brightness(wires) > 20, "lines are there");
    }

    @Test
    void help_liesOverThePicture() throws IOException {
        BufferedImage bare = shot("bare");
        tap("H");
        BufferedImage help = shot("help");
        tap("H");
        assertTrue(difference(bare, help) > 10, "a panel of text");
        assertEquals(0, difference(bare, shot("bare-again")), 0.01);
    }

    @Test
    void replacedFile_isShownFromTheSamePlace() throws Exception {
        say("hold UP 200");
        double[] place = camera();
        BufferedImage before = shot("old");
        Path whole = Files.copy(scene, folder.resolve("whole.scene"));
        Path begun = Rendered.cornellBox(Files.createDirectory(folder.resolve("begun")), "-it", "2");
        Files.move(begun, scene, StandardCopyOption.REPLACE_EXISTING);
        assertTrue(becomes(image -> difference(before, image) > 3), "two shots look different");
        assertArrayEquals(place, camera());
        Files.move(whole, scene, StandardCopyOption.REPLACE_EXISTING);
        assertTrue(becomes(image -> difference(before, image) < 0.01), "as it was");
    }

    /** Whether the picture does so within some seconds. */
    private static boolean becomes(Predicate<BufferedImage> wanted) throws Exception {
        for (int i = 0; i < 60; i++) {
            tap("SPACE");
            if (wanted.test(shot("now"))) {
                return true;
            }
            Thread.sleep(100);
        }
        return false;
    }
}
