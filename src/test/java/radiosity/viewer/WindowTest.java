package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.viewer.Rendered.SIZE;
import static radiosity.viewer.Rendered.black;
import static radiosity.viewer.Rendered.brightness;
import static radiosity.viewer.Rendered.difference;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.testkit.NeedsProgram;

/** The window on the Cornell box, used by key and mouse on a display in memory. */
@Tag("slow")
@NeedsProgram("Xvfb")
class WindowTest {

    /** Half the window shows the left wall at this height, and so on; pixels. */
    private static final int LEFT = SIZE / 10;
    private static final int RIGHT = SIZE - SIZE / 10;
    private static final int MIDDLE = SIZE / 2;

    @TempDir
    static Path folder;

    private static DrivenWindow window;
    private static Path scene;

    @BeforeAll
    static void open() throws IOException {
        scene = Rendered.cornellBox(folder);
        window = new DrivenWindow(scene, folder);
    }

    @AfterAll
    static void close() {
        if (window != null) {
            window.close();
        }
    }

    private static Color colour(BufferedImage image, int x, int y) {
        return new Color(image.getRGB(x, y));
    }

    @BeforeEach
    void home() throws IOException {
        window.tap("HOME");
    }

    @Test
    void cornellBox_isRedOnTheLeftGreenOnTheRightAndBrightestAtTheLamp() throws IOException {
        BufferedImage image = window.shot("start");
        Color left = colour(image, LEFT, MIDDLE);
        Color right = colour(image, RIGHT, MIDDLE);
        assertTrue(left.getRed() > 2 * left.getGreen() && left.getRed() > 2 * left.getBlue(), left.toString());
        assertTrue(right.getGreen() > 1.2 * right.getRed() && right.getGreen() > 2 * right.getBlue(), right.toString());
        assertEquals(Color.WHITE, colour(image, MIDDLE, SIZE * 57 / 400));
    }

    @Test
    void picture_isTheRenderers() throws IOException {
        double difference = difference(window.shot("same"), Rendered.picture(folder.resolve("box.png")));
        assertTrue(difference <= 2, "mean difference " + difference + " of 255");
    }

    /** In a window of its own: others leave exposure and curve in theirs. */
    @Test
    void photo_isTheRenderersPicture() throws Exception {
        Path photo = folder.resolve(scene.getFileName() + "-photo-1.png");
        DrivenWindow own = new DrivenWindow(scene, folder);
        try {
            own.tap("F");
            for (int look = 0; look < 600 && !Files.exists(photo); look++) {
                Thread.sleep(100);
            }
        } finally {
            own.close();
        }
        double difference = difference(Rendered.picture(photo), Rendered.picture(folder.resolve("box.png")));
        assertTrue(difference <= .5, "mean difference " + difference + " of 255");
    }

    @Test
    void keyOfTheDisplay_reachesTheWindow() throws IOException {
        double[] start = window.camera();
        assertEquals("walked", window.say("real UP"));
        double[] there = window.camera();
        assertTrue((there[0] - start[0]) * start[3] + (there[2] - start[2]) * start[5] > 0, "ahead");
    }

    @Test
    void heldKey_walksAsFarAsItIsHeld() throws IOException {
        double[] start = window.camera();
        window.say("hold UP 150");
        double once = window.camera()[2] - start[2];
        window.say("hold UP 300");
        assertEquals(3 * once, window.camera()[2] - start[2], 1e-9 * Math.abs(once));
    }

    @Test
    void arrowUp_walksAheadAndHomeLeadsBack() throws IOException {
        BufferedImage before = window.shot("before");
        double[] start = window.camera();
        window.say("hold UP 300");
        double[] there = window.camera();
        double ahead = (there[0] - start[0]) * start[3] + (there[2] - start[2]) * start[5];
        assertTrue(ahead > 10, "walked " + ahead);
        assertEquals(start[1], there[1], "height");
        assertTrue(difference(before, window.shot("ahead")) > 3, "another picture");
        window.tap("HOME");
        assertEquals(0, difference(before, window.shot("back")), 0.01);
    }

    @Test
    void arrowLeft_turnsLeftAndPageUp_looksUp() throws IOException {
        double[] start = window.camera();
        window.say("hold LEFT 200");
        double[] left = window.camera();
        assertTrue(start[5] * left[3] - start[3] * left[5] > 0.05, "turned to the left seen from above");
        window.say("hold PAGE_UP 200");
        assertTrue(window.camera()[4] > left[4] + 0.05, "looks higher");
    }

    @Test
    void sideStep_leavesTheDirectionAlone() throws IOException {
        double[] start = window.camera();
        window.say("hold D 200");
        double[] right = window.camera();
        assertEquals(start[5], right[5], 1e-12);
        double aside = (right[0] - start[0]) * -start[5] + (right[2] - start[2]) * start[3];
        assertTrue(aside > 5, "walked " + aside);
    }

    @Test
    void drag_looksAround() throws IOException {
        double[] start = window.camera();
        window.say("drag 100 150 160 150");
        double[] turned = window.camera();
        double sine = start[5] * turned[3] - start[3] * turned[5];
        assertEquals(Math.sin(60.0 * 1.5 / SIZE), sine, 0.02);
    }

    @Test
    void walls_stopTheWalker() throws IOException {
        double[] start = window.camera();
        window.say("hold SHIFT+UP 5000");
        double[] end = window.camera();
        assertTrue(end[2] < start[2] - 500, "walked into the box: " + end[2]);
        assertTrue(end[2] > -560 && shotIsLit(), "stopped before the back wall: " + end[2]);
    }

    private static boolean shotIsLit() throws IOException {
        return brightness(window.shot("wall")) > 100;
    }

    @Test
    void click_tellsTheLightThere() throws IOException {
        String wall = window.say("probe " + LEFT + " " + MIDDLE);
        assertTrue(wall.startsWith("surface"), wall);
        double[] b = DrivenWindow.numbers(wall, "radiosity");
        double[] h = DrivenWindow.numbers(wall, "irradiance");
        double[] rho = DrivenWindow.numbers(wall, "reflectance");
        for (int c = 0; c < 3; c++) {
            assertEquals(b[c], rho[c] * h[c], 2e-3 * b[0], wall);
        }
        assertTrue(b[0] > 2 * b[1], "red: " + wall);
        assertEquals("nothing", window.say("probe 1 1"));
        BufferedImage bare = window.shot("unprobed");
        window.say("click " + LEFT + " " + MIDDLE);
        assertTrue(difference(bare, window.shot("probed")) > 1, "the answer is shown");
    }

    @Test
    void photometricScene_isToldInLuxAndCandela() throws IOException {
        Path lux = Rendered.cornellBox(Files.createDirectory(folder.resolve("lux")), "--unit", "mm", "--photometric");
        try (DrivenWindow own = new DrivenWindow(lux, folder)) {
            String wall = own.say("probe " + LEFT + " " + MIDDLE);
            assertTrue(wall.matches(".*; radiosity [^;]* lm/m²; irradiance [^;]* lx; luminance Y .* cd/m², illuminance .*"),
                    wall);
            own.tap("T");
            String exposure = own.say("status");
            assertTrue(exposure.matches("exposure \\S+ per lm/m² .*"), exposure);
        }
    }

    @Test
    void keys_changeExposureAndCurve() throws IOException {
        double before = Double.parseDouble(window.say("exposure"));
        window.tap("EQUALS");
        window.tap("EQUALS");
        window.tap("EQUALS");
        assertEquals(2 * before, Double.parseDouble(window.say("exposure")), 1e-9 * before);
        BufferedImage reinhard = window.shot("bright");
        window.tap("T");
        assertTrue(difference(reinhard, window.shot("filmic")) > 3, "another curve");
        window.tap("T");
        window.tap("T");
        window.tap("0");
        assertEquals(before, Double.parseDouble(window.say("exposure")), 1e-9 * before);
    }

    @Test
    void falseColours_areThoseOfTheScale() throws IOException {
        window.tap("C");
        double[] b = window.probe(MIDDLE, SIZE * 2 / 5, "radiosity");
        window.tap("SPACE");
        double luminance = 0.2126 * b[0] + 0.7152 * b[1] + 0.0722 * b[2];
        double x = 1 + Math.log10(luminance * Double.parseDouble(window.say("exposure")) / 4) / TurboColourMap.DECADES;
        Color expected = new Color(TurboColourMap.turbo(x));
        BufferedImage image = window.shot("false");
        Color got = colour(image, MIDDLE, SIZE * 2 / 5);
        Color blue = new Color(TurboColourMap.turbo(0));
        Color least = colour(image, SIZE - 100, 12 + 230);
        assertTrue(Math.abs(blue.getRed() - least.getRed()) + Math.abs(blue.getBlue() - least.getBlue()) < 40,
                "the lower end of the scale: " + least);
        window.tap("C");
        assertEquals(expected.getRed(), got.getRed(), 4);
        assertEquals(expected.getGreen(), got.getGreen(), 4);
        assertEquals(expected.getBlue(), got.getBlue(), 4);
    }

    @Test
    void wireframe_leavesHolesBetweenTheLines() throws IOException {
        BufferedImage whole = window.shot("whole");
        window.tap("X");
        BufferedImage wires = window.shot("wires");
        window.tap("X");
        assertTrue(black(wires) > black(whole) + 0.3, black(wires) + " of the picture is black");
        assertTrue(brightness(wires) > 20, "lines are there");
    }

    @Test
    void help_liesOverThePicture() throws IOException {
        BufferedImage bare = window.shot("bare");
        window.tap("H");
        BufferedImage help = window.shot("help");
        window.tap("H");
        assertTrue(difference(bare, help) > 10, "a panel of text");
        assertEquals(0, difference(bare, window.shot("bare-again")), 0.01);
    }

    @Test
    void replacedFile_isShownFromTheSamePlace() throws Exception {
        window.say("hold UP 200");
        double[] place = window.camera();
        BufferedImage before = window.shot("old");
        Path whole = Files.copy(scene, folder.resolve("whole.scene"));
        Path begun = Rendered.cornellBox(Files.createDirectory(folder.resolve("begun")), "-it", "2");
        Files.move(begun, scene, StandardCopyOption.REPLACE_EXISTING);
        assertTrue(window.becomes(image -> difference(before, image) > 3), "two shots look different");
        assertArrayEquals(place, window.camera());
        Files.move(whole, scene, StandardCopyOption.REPLACE_EXISTING);
        assertTrue(window.becomes(image -> difference(before, image) < 0.01), "as it was");
    }
}
