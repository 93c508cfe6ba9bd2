package radiosity.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import radiosity.cli.RadiosityRenderer;

/** The Cornell box, rendered for the tests of this package, and what its pictures show. */
final class Rendered {

    static final int SIZE = 300;

    private Rendered() { }

    /** Renders into box.scene and box.png, coarsely. */
    static Path cornellBox(Path folder, String... arguments) {
        Path scene = folder.resolve("box.scene");
        // with -se, patch by patch as in the paper: the fewest elements
        String[] usual = {"-q", "-pa", "20000", "-se", "0.01", "--tone-mapping", "reinhard", "--picture",
                folder.resolve("box.png").toString(), "--size",
            SIZE + "x" + SIZE};
        String[] all = new String[arguments.length + usual.length + 2];
        System.arraycopy(usual, 0, all, 0, usual.length);
        System.arraycopy(arguments, 0, all, usual.length, arguments.length);
        all[all.length - 2] = "scenes/cornell-box.lws";
        all[all.length - 1] = scene.toString();
        assertEquals(0, RadiosityRenderer.run(all));
        return scene;
    }

    /** Mean difference of two pictures of the same size, codes of 255. */
    static double difference(BufferedImage a, BufferedImage b) {
        assertEquals(a.getWidth(), b.getWidth());
        assertEquals(a.getHeight(), b.getHeight());
        double sum = 0;
        for (int i = 0; i < a.getWidth() * a.getHeight(); i++) {
            Color p = new Color(a.getRGB(i % a.getWidth(), i / a.getWidth()));
            Color q = new Color(b.getRGB(i % a.getWidth(), i / a.getWidth()));
            sum += Math.abs(p.getRed() - q.getRed()) + Math.abs(p.getGreen() - q.getGreen())
                    + Math.abs(p.getBlue() - q.getBlue());
        }
        return sum / (3.0 * a.getWidth() * a.getHeight());
    }

    /** Mean of red + green + blue, codes of 255. */
    static double brightness(BufferedImage image) {
        return 3 * difference(image, new BufferedImage(image.getWidth(), image.getHeight(),
                BufferedImage.TYPE_INT_RGB));
    }

    /** The share of pixels that are black. */
    static double black(BufferedImage image) {
        int count = 0;
        for (int i = 0; i < image.getWidth() * image.getHeight(); i++) {
            count += (image.getRGB(i % image.getWidth(), i / image.getWidth()) & 0xFFFFFF) == 0 ? 1 : 0;
        }
        return (double) count / (image.getWidth() * image.getHeight());
    }

    static BufferedImage picture(Path file) throws IOException {
        return ImageIO.read(file.toFile());
    }
}
