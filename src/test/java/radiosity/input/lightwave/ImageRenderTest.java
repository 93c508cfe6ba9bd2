package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.input.lightwave.Iff.chunk;
import static radiosity.input.lightwave.Iff.f4;
import static radiosity.input.lightwave.Iff.s0;
import static radiosity.input.lightwave.Iff.sub;
import static radiosity.input.lightwave.Iff.u2;
import static radiosity.input.lightwave.Iff.u4;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.cli.RadiosityRenderer;
import radiosity.output.gltf.LitScene;
import radiosity.output.gltf.TexturedMesh;

/** A LightWave object that glows in the colours of an image, from file to picture. */
class ImageRenderTest {

    private static final int STRIPES = 16;

    @TempDir
    Path folder;

    /** Stripes of red and blue, finer than the mesh will be. */
    @BeforeEach
    void write() throws IOException {
        BufferedImage image = new BufferedImage(64, 8, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 64 * 8; i++) {
            image.setRGB(i % 64, i / 64, i % 64 * STRIPES / 64 % 2 == 0 ? 0xFF0000 : 0x0000FF);
        }
        ImageIO.write(image, "png", folder.resolve("stripes.png").toFile());
        Files.write(folder.resolve("screen.lwo"), Objects.lwo2(chunk("CLIP", u4(1), sub("STIL", s0("stripes.png"))),
                Objects.lwo2Surface("white", "", Objects.colour(1, 1, 1), Objects.share("DIFF", 0.5),
                        Objects.share("LUMI", 2), SoundFiles.imageBlock("COLR", 0, sub("AXIS", u2(2)),
                                sub("TMAP", sub("CNTR", f4(0.5, 0.5, 0), u2(0)), sub("SIZE", f4(1, 1, 1), u2(0)),
                                        sub("ROTA", f4(0, 0, 0), u2(0)))))));
        Files.writeString(folder.resolve("screen.lws"), "LWSC\n3\n\nLoadObjectLayer 1 screen.lwo\n"
                + Scenes.motion3("ObjectMotion", 0, 0, 0, 0, 0, 0, 1, 1, 1) + "\nAddCamera\nCameraName Camera\n"
                + Scenes.motion3("CameraMotion", 0.5, 0.5, -1, 0, 0, 0, 1, 1, 1)
                        + "ZoomFactor 2\nFrameSize 128 128\nPixelAspect 1\n");
    }

    private int render(String... more) {
        String[] arguments = new String[more.length + 3];
        arguments[0] = "-q";
        System.arraycopy(more, 0, arguments, 1, more.length);
        arguments[more.length + 1] = folder.resolve("screen.lws").toString();
        arguments[more.length + 2] = folder.resolve("screen.scene").toString();
        return RadiosityRenderer.run(arguments);
    }

    private static void assertStripes(BufferedImage image) {
        for (int stripe = 0; stripe < STRIPES; stripe++) {
            Color c = new Color(image.getRGB((2 * stripe + 1) * image.getWidth() / (2 * STRIPES),
                    image.getHeight() / 2));
            assertTrue(stripe % 2 == 0 ? c.getRed() > c.getBlue() + 100 : c.getBlue() > c.getRed() + 100,
                    "stripe " + stripe + ": " + c);
        }
    }

    @Test
    void picture_hasTheImageAtFullResolution() throws IOException {
        Path picture = folder.resolve("screen.png");
        assertEquals(0, render("--size", "128x128", "--picture", picture.toString()));
        assertStripes(ImageIO.read(picture.toFile()));
    }

    @Test
    void texturedScene_hasTheImageAtFullResolutionThoughFewSamplesAreAsked() throws IOException {
        assertEquals(0, render("-ut", "2"));
        TexturedMesh mesh = LitScene.read(folder.resolve("screen.scene")).textures().orElseThrow().meshes().get(0);
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(mesh.png()));
        assertTrue(image.getWidth() >= 64, image.getWidth() + " texels");
        int x0 = 2;
        assertStripes(image.getSubimage(x0, 0, image.getWidth() - 2 * x0, image.getHeight()));
    }

    @Test
    void missingImage_isAWarningAndTheBaseColour() throws IOException {
        Files.delete(folder.resolve("stripes.png"));
        Path picture = folder.resolve("screen.png");
        assertEquals(0, render("--size", "16x16", "--picture", picture.toString()));
        Color c = new Color(ImageIO.read(picture.toFile()).getRGB(8, 8));
        assertEquals(c.getRed(), c.getBlue(), "white");
        assertEquals(3, render("--strict"));
    }
}
