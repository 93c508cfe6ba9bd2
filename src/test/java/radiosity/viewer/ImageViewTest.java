package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.output.gltf.SceneFile;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Camera;
import radiosity.scene.ImageMap;
import radiosity.scene.Light;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.viewer.web.WebPage;

/** Stripes of red and blue on a wall of two elements: seen at full size in the window and on the web page. */
@Tag("slow")
class ImageViewTest {

    private static final int STRIPES = 10;
    private static final int SIZE = Rendered.SIZE;

    @TempDir
    static Path folder;

    private static Path file;

    @BeforeAll
    static void write() throws IOException {
        file = folder.resolve("stripes.scene");
        Solution solution = solution();
        assertEquals(2, solution.elements());
        SceneFile.write(file, solution, Map.of(), solution.scene().camera(), ToneMapping.automatic(solution),
                OptionalDouble.of(1));
    }

    private static Solution solution() throws IOException {
        float[] rgb = new float[3 * STRIPES];
        for (int i = 0; i < STRIPES; i++) {
            rgb[3 * i + (i % 2 == 0 ? 0 : 2)] = 0.8f;
        }
        Raster stripes = new Raster(STRIPES, 1, rgb, ImageMap.Wrap.EDGE, ImageMap.Wrap.EDGE, Rgb.BLACK);
        Surface wall = new Surface("wall", Rgb.BLACK, Rgb.grey(.4), false)
                .with(new Surface.Maps(Optional.empty(), Optional.of(stripes)));
        Light sun = new Light("sun", Light.Kind.DISTANT, Rgb.grey(1), Vec3.ZERO, new Vec3(0, 0, -1), Vec3.ZERO,
                Vec3.ZERO, 1, 0, 0);
        Camera camera = new Camera(new Vec3(5, 5, 10), new Vec3(0, 0, -1), new Vec3(0, 1, 0), Math.atan(.5), 1);
        Scene scene = new Scene("stripes", new double[] {0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0},
                new int[] {0, 1, 2, 0, 2, 3}, new int[] {0, 0}, List.of(wall), List.of(sun), Optional.of(camera),
                new float[] {0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1});
        RadiositySettings coarse = new RadiositySettings(100, 1, Double.POSITIVE_INFINITY, Schedule.PAPER);
        try (LocalWorld world = new LocalWorld(scene, coarse, 1)) {
            ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, new StopRule(10, 0));
            rounds.run(progress -> true);
            return rounds.solution();
        }
    }

    private static void assertStripes(BufferedImage image) {
        for (int i = 0; i < STRIPES; i++) {
            Color c = new Color(image.getRGB((2 * i + 1) * SIZE / (2 * STRIPES), SIZE / 3));
            assertTrue(i % 2 == 0 ? c.getRed() > 100 && c.getBlue() < 20 : c.getBlue() > 100 && c.getRed() < 20,
                    "stripe " + i + ": " + c);
        }
    }

    @Test
    void window_showsTheImageInTheTextures() throws Exception {
        try (DrivenWindow window = new DrivenWindow(file, folder)) {
            window.tap("U");
            window.tap("SPACE");
            assertStripes(window.shot("stripes"));
        }
    }

    @Test
    void webPage_showsTheImageInTheTextures() throws Exception {
        try (WebPage page = new WebPage(file, ToneMapping.Operator.REINHARD, 0, 0);
                Browser browser = new Browser(Files.createDirectory(folder.resolve("profile")), SIZE)) {
            browser.open(page.address());
            browser.tap("KeyU", "u");
            assertStripes(browser.screenshot());
            assertEquals(List.of(), browser.errors);
        }
    }
}
