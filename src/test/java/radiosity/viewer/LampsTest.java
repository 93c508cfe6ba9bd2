package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.viewer.Rendered.SIZE;
import static radiosity.viewer.Rendered.brightness;
import static radiosity.viewer.Rendered.difference;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.testkit.NeedsProgram;

/** The control panel of the window on a Cornell box with a second, blue light. */
@Tag("slow")
@NeedsProgram("Xvfb")
class LampsTest {

    private static final int LEFT = SIZE / 10;
    private static final int MIDDLE = SIZE / 2;

    @TempDir
    static Path folder;

    private static DrivenWindow window;

    @BeforeAll
    static void open() throws IOException {
        window = new DrivenWindow(TwoLamps.write(folder), folder);
    }

    @AfterAll
    static void close() {
        if (window != null) {
            window.close();
        }
    }

    @BeforeEach
    void asRendered() throws IOException {
        window.say("press asRendered");
        window.say("press automatic");
        window.tap("HOME");
    }

    @Test
    void slider_dimsOneLamp() throws IOException {
        double[] before = window.probe(LEFT, MIDDLE, "radiosity");
        window.say("set lamp1 0");
        double[] ceiling = window.probe(LEFT, MIDDLE, "radiosity");
        window.say("set lamp1 100");
        window.say("set lamp0 30");
        double[] mixed = window.probe(LEFT, MIDDLE, "radiosity");
        for (int c = 0; c < 3; c++) {
            assertEquals(before[c] - 0.7 * ceiling[c], mixed[c], 2e-3 * before[c]);
        }
        assertTrue(before[2] > ceiling[2], "the blue light is seen");
        assertEquals(before[0], ceiling[0], 2e-3 * before[0], "and has no red");
    }

    @Test
    void picture_followsAtOnceAndComesBack() throws IOException {
        BufferedImage before = window.shot("before");
        window.say("set lamp0 0");
        window.say("set lamp1 0");
        BufferedImage dark = window.shot("dark");
        assertTrue(brightness(dark) < 1, "no lamp, no light: " + brightness(dark));
        window.say("press asRendered");
        assertEquals(0, difference(before, window.shot("again")), 0.01);
    }

    @Test
    void colour_tintsALamp() throws IOException {
        window.say("set lamp1 0");
        double[] white = window.probe(MIDDLE, SIZE * 2 / 5, "radiosity");
        window.say("colour 0 255 0 0");
        double[] red = window.probe(MIDDLE, SIZE * 2 / 5, "radiosity");
        assertEquals(white[0], red[0], 1e-3 * white[0]);
        assertEquals(0, red[1]);
        assertEquals(0, red[2]);
        Color lamp = new Color(window.shot("red").getRGB(MIDDLE, SIZE * 57 / 400));
        assertTrue(lamp.getRed() > 100 && lamp.getGreen() == 0, "the lamp shows it: " + lamp);
    }

    @Test
    void mix_isSavedBesideTheSceneFileAndComesBack() throws IOException {
        window.say("press loadMix");
        assertEquals("mix: none is saved", window.say("status"));
        window.say("set lamp0 30");
        window.say("colour 1 255 0 255");
        double[] mixed = window.probe(LEFT, MIDDLE, "radiosity");
        window.say("press saveMix");
        assertEquals("mix saved: lamps.scene.mix", window.say("status"));
        Path saved = folder.resolve("lamps.scene.mix");
        assertTrue(Files.readString(saved).matches("0\\.3 0\\.3 0\\.3 \\S.*\n1\\.0 0\\.0 1\\.0 blue\n"),
                Files.readString(saved));
        window.say("press asRendered");
        window.say("press loadMix");
        assertArrayEquals(mixed, window.probe(LEFT, MIDDLE, "radiosity"));
        Files.writeString(saved, "bright blue");
        window.say("press loadMix");
        assertEquals("mix: lamps.scene.mix, line 1: expected three factors and a lamp's name, got bright blue",
                window.say("status"));
        Files.delete(saved);
    }

    @Test
    void panel_doesWhatTheKeysDo() throws IOException {
        double before = Double.parseDouble(window.say("exposure"));
        window.say("set stops 6");
        assertEquals(4 * before, Double.parseDouble(window.say("exposure")), 1e-6 * before);
        window.say("press automatic");
        window.tap("SPACE");
        BufferedImage plain = window.shot("plain");
        for (String name : List.of("wireframe", "falseColour", "filmic")) {
            window.say("press " + name);
            assertTrue(difference(plain, window.shot(name)) > 3, name);
            window.say("press " + (name.equals("filmic") ? "reinhard" : name));
            window.tap("SPACE");
            assertEquals(0, difference(plain, window.shot("not-" + name)), 0.01, name);
        }
    }

    @Test
    void panel_isShownByKeyBesideThePicture() throws IOException {
        String whole = window.say("size");
        window.tap("P");
        assertNotEquals(whole, window.say("size"), "the picture makes room");
        window.tap("P");
        assertEquals(whole, window.say("size"));
    }
}
