package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.bench.LargeSceneFile;
import radiosity.cli.RadiosityRenderer;
import radiosity.cli.ViewSceneFile;
import radiosity.testkit.Xvfb;

/** ViewSceneFile as a program of its own. */
@Tag("slow")
class ViewSceneFileTest {

    @TempDir
    static Path folder;

    private static Path scene;

    @BeforeAll
    static void render() {
        scene = Rendered.cornellBox(folder, "-ut", "0.2");
    }

    /**
     * What a program said and returned.
     *
     * @param text output and errors
     */
    private record Ended(String text, int exitCode) { }

    private static Ended run(ProcessBuilder program) throws IOException, InterruptedException {
        Process process = program.redirectErrorStream(true).start();
        process.getOutputStream().close();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return new Ended(text, process.waitFor());
    }

    private static BufferedImage screenshot(String... options) throws IOException, InterruptedException {
        Path file = folder.resolve("shot.png");
        String[] arguments = Arrays.copyOf(options, options.length + 4);
        System.arraycopy(new String[] {"--screenshot", file.toString(), "--size", "200x200"}, 0, arguments,
                options.length, 4);
        try (Xvfb display = new Xvfb()) {
            assertEquals(new Ended("", 0), run(display.program(ViewSceneFile.class, arguments)));
        }
        return Rendered.picture(file);
    }

    @Test
    void wireframe_isBlackBetweenColouredLines() throws Exception {
        BufferedImage image = screenshot("-wf", scene.toString());
        double black = Rendered.black(image);
        assertTrue(black > 0.5 && black < 0.98, black + " of the picture is black");
        Color left = brightest(image, 15);
        Color right = brightest(image, 185);
        assertTrue(left.getRed() > 1.5 * left.getGreen(), "a red line: " + left);
        assertTrue(right.getGreen() > 1.2 * right.getRed(), "a green line: " + right);
    }

    /** Of a column of the picture. */
    private static Color brightest(BufferedImage image, int x) {
        Color brightest = Color.BLACK;
        for (int y = 60; y < 140; y++) {
            Color c = new Color(image.getRGB(x, y));
            if (c.getRed() + c.getGreen() > brightest.getRed() + brightest.getGreen()) {
                brightest = c;
            }
        }
        return brightest;
    }

    @Test
    void textures_showWhatVerticesShow() throws Exception {
        BufferedImage vertices = screenshot(scene.toString());
        BufferedImage textures = screenshot("-ut", scene.toString());
        double difference = Rendered.difference(vertices, textures);
        assertTrue(difference <= 2, "mean difference " + difference + " of 255");
        assertTrue(difference > 0, "not the same triangles");
        assertTrue(seams(vertices, textures) < 10, "pixels that differ much: " + seams(vertices, textures));
    }

    /** Pixels of two pictures that differ by more than a tenth in a channel. */
    private static int seams(BufferedImage a, BufferedImage b) {
        int count = 0;
        for (int i = 0; i < a.getWidth() * a.getHeight(); i++) {
            Color p = new Color(a.getRGB(i % a.getWidth(), i / a.getWidth()));
            Color q = new Color(b.getRGB(i % a.getWidth(), i / a.getWidth()));
            count += Math.max(Math.abs(p.getRed() - q.getRed()), Math.abs(p.getGreen() - q.getGreen())) > 25 ? 1 : 0;
        }
        return count;
    }

    @Test
    void sceneWithoutTextures_isToldWithExitCode3() throws Exception {
        Path bare = folder.resolve("bare.scene");
        assertEquals(0, RadiosityRenderer.run("-q", "-dr", "scenes/cornell-box.lws", bare.toString()));
        Ended ended = run(Xvfb.java(ViewSceneFile.class, "-ut", bare.toString()));
        assertEquals(3, ended.exitCode());
        assertEquals(bare + ": expected textures (RadiosityRenderer -ut <n>), got none", ended.text().strip());
    }

    @Test
    void lightWaveFile_isShownInTheColoursOfItsSurfaces() throws Exception {
        BufferedImage image = screenshot("-lw", "scenes/cornell-box.lws");
        Color left = new Color(image.getRGB(20, 100));
        Color back = new Color(image.getRGB(100, 70));
        assertTrue(left.getRed() > 1.5 * left.getGreen(), "left wall " + left);
        assertEquals(back.getRed(), back.getGreen(), 12, "back wall, not lit: " + back);
        assertEquals(Color.WHITE, new Color(image.getRGB(100, 28)), "lamp");
    }

    @Test
    void hostWithoutDisplay_getsOneLineAndExitCode1() throws Exception {
        ProcessBuilder program = Xvfb.java(ViewSceneFile.class, scene.toString());
        program.environment().remove("DISPLAY");
        Ended ended = run(program);
        assertEquals(1, ended.exitCode());
        assertTrue(ended.text().matches("display: expected [^\\n]*xvfb-run[^\\n]*\\R"), ended.text());
    }

    private static void refused(Path file, String expected) throws Exception {
        Ended ended = run(Xvfb.java(ViewSceneFile.class, file.toString()));
        assertEquals(3, ended.exitCode(), ended.text());
        assertTrue(ended.text().startsWith(file + ": ") && ended.text().contains(expected), ended.text());
        assertEquals(1, ended.text().lines().count(), ended.text());
    }

    @Test
    void brokenForeignAndNewerFiles_getOneLineAndExitCode3() throws Exception {
        byte[] whole = Files.readAllBytes(scene);
        refused(Files.write(folder.resolve("cut.scene"), Arrays.copyOf(whole, whole.length / 2)), "bytes");
        refused(Files.writeString(folder.resolve("foreign.scene"), "A poem of more than twenty bytes"),
                "RadiosityRenderer wrote");
        String newer = new String(whole, StandardCharsets.ISO_8859_1).replace("\"formatVersion\":1",
                "\"formatVersion\":9");
        refused(Files.writeString(folder.resolve("newer.scene"), newer, StandardCharsets.ISO_8859_1),
                "newer program");
        refused(folder.resolve("absent.scene"), "none");
    }

    @Test
    void millionTriangles_openInHalfAGibibyte() throws Exception {
        Path large = folder.resolve("large.scene");
        assertEquals(new Ended("", 0), run(Xvfb.java(LargeSceneFile.class, large.toString(), "1000000")));
        try (Xvfb display = new Xvfb()) {
            Path picture = folder.resolve("large.png");
            ProcessBuilder program = display.program(ViewSceneFile.class, "--screenshot", picture.toString(), "--size",
                    "200x150", large.toString());
            program.command().set(program.command().indexOf("-Xmx2g"), "-Xmx512m");
            assertEquals(new Ended("", 0), run(program));
            Color wall = new Color(Rendered.picture(picture).getRGB(100, 50));
            assertTrue(wall.getGreen() > wall.getBlue() + 40, "higher is greener: " + wall);
        }
    }

    @Test
    void renderer_loadsNothingOfTheViewer() throws Exception {
        ProcessBuilder program = Xvfb.java(RadiosityRenderer.class, "-dr", "scenes/cornell-box.lws",
                folder.resolve("dark.scene").toString());
        program.command().add(1, "-Xlog:class+load");
        Ended ended = run(program);
        assertEquals(0, ended.exitCode());
        assertTrue(ended.text().contains("radiosity.solver.LocalWorld"), "classes are listed");
        assertFalse(ended.text().lines()
                .anyMatch(line -> line.matches(".*(org\\.jogamp|com\\.jogamp|radiosity\\.viewer).*")));
    }
}
