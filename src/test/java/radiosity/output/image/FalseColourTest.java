package radiosity.output.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import radiosity.scene.Camera;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/** A floor of 4 x 4 m, 1 m below a bulb of 1000 cd, seen from straight above; 1000 lx in the middle. */
class FalseColourTest {

    private static final int WIDTH = 200;

    private static BufferedImage picture(Path folder) throws IOException {
        Scene floor = new SceneBuilder().polygon(RoomScenes.grey("floor", 0, .5), new Vec3(-2, 0, 2), new Vec3(2, 0, 2),
                new Vec3(2, 0, -2), new Vec3(-2, 0, -2)).light(new Light("bulb", Light.Kind.POINT, Rgb.grey(1000),
                new Vec3(0, 1, 0), Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, 1, 0, 0)).scene("floor").with(new Units(1, true));
        Path file = folder.resolve("lux.png");
        FalseColour.write(file, Solve.byDefault().solution(floor), new Camera(new Vec3(0, 2, 0), new Vec3(0, -1, 0),
                new Vec3(0, 0, -1), Math.PI / 4, 1), WIDTH, 2);
        return ImageIO.read(file.toFile());
    }

    /** E = 1000 / (1 + r²)^1.5: 500 lx at r = .766, where a pixel is 4 m / 200. */
    @Test
    void linesLie_whereTheIlluminanceIsTheirs_andColoursFollowIt(@TempDir Path folder) throws IOException {
        BufferedImage image = picture(folder);
        assertEquals(WIDTH, image.getHeight());
        assertTrue(image.getWidth() > WIDTH, "a legend beside it");
        List<Integer> lines = java.util.stream.IntStream.range(WIDTH / 2 + 2, WIDTH - 2)
                .filter(x -> brightness(image, x) < .75 * Math.min(brightness(image, x - 2), brightness(image, x + 2)))
                .boxed().toList();
        for (double lux = 200; lux < 999; lux += 200) {
            double r = Math.sqrt(Math.pow(1000 / lux, 2 / 3.0) - 1);
            double x = WIDTH / 2.0 + r * WIDTH / 4;
            assertTrue(lines.stream().anyMatch(line -> Math.abs(line + .5 - x) < 2), lux + " lx at " + x + ": " + lines);
        }
        int middle = image.getRGB(WIDTH / 2 + 3, WIDTH / 2 + 3);
        int corner = image.getRGB(3, 3);
        assertTrue((middle >> 16 & 255) > 150 && (middle & 255) < 80, "red in the middle");
        assertTrue((corner >> 16 & 255) < 80 && (corner & 255) > 60, "blue in the corner");
    }

    private static double brightness(BufferedImage image, int x) {
        int rgb = image.getRGB(x, WIDTH / 2);
        return (rgb >> 16 & 255) + (rgb >> 8 & 255) + (rgb & 255);
    }

    @ParameterizedTest
    @CsvSource({"1000, 200", "999, 100", "5, 1", "0.013, 0.002", "0, 1", "7e9, 1e9",
        "20, 2", "22.5, 5", "2499, 500", "25, 5"})
    void steps_areRoundNumbers(double most, double step) {
        assertEquals(step, FalseColour.step(most), 1e-12 * step);
    }
}
