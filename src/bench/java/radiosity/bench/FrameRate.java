package radiosity.bench;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import javax.imageio.ImageIO;
import radiosity.output.gltf.LitScene;
import radiosity.output.gltf.TexturedMesh;
import radiosity.output.image.ToneMapping;
import radiosity.output.mesh.Mesh;
import radiosity.viewer.SceneCanvas;
import radiosity.viewer.ViewSettings;
import radiosity.viewer.Walkthrough;

/** Measures section 5.3 of the paper, textures against triangles; docs/VIEWER.md has the command and figures. */
final class FrameRate {

    private static final int FRAMES = 100;
    private static final int SIZE = 512;

    private FrameRate() { }

    /** @param arguments scene files that have textures */
    public static void main(String[] arguments) throws Exception {
        for (String file : arguments) {
            LitScene scene = LitScene.read(Path.of(file));
            LitScene.Textures textures = scene.textures().orElseThrow();
            int elements = scene.meshes().stream().mapToInt(Mesh::elements).sum();
            long vertexBytes = scene.meshes().stream().mapToLong(m -> 24L * m.vertices() + 12L * m.elements()).sum();
            int triangles = textures.meshes().stream().mapToInt(m -> m.positions().length / 9).sum();
            long textureBytes = textures.meshes().stream().mapToLong(m -> 20L * m.positions().length / 3).sum()
                    + 3 * texels(textures);
            System.out.printf("%s: %d elements, %.1f frames/s, %d bytes; %d textured triangles, %.1f frames/s, %d bytes%n",
                    file, elements, rate(scene, false), vertexBytes, triangles, rate(scene, true), textureBytes);
        }
        System.exit(0);
    }

    private static long texels(LitScene.Textures textures) throws IOException {
        long texels = 0;
        for (TexturedMesh mesh : textures.meshes()) {
            BufferedImage image = ImageIO.read(new ByteArrayInputStream(mesh.png()));
            texels += (long) image.getWidth() * image.getHeight();
        }
        return texels;
    }

    /** Frames per second. */
    private static double rate(LitScene scene, boolean textures) throws Exception {
        Walkthrough window = Walkthrough.open(scene, new ViewSettings("frame rate", false, textures, Optional.empty(),
                ToneMapping.Operator.REINHARD, 0, SIZE, SIZE, Optional.empty(), Optional.empty(), Optional.empty()));
        window.screenshot();
        long start = System.nanoTime();
        for (int i = 0; i < FRAMES; i++) {
            frame(window.canvas());
        }
        double rate = FRAMES * 1e9 / (System.nanoTime() - start);
        window.close();
        return rate;
    }

    /** Asks until one is drawn: a request during the last frame is lost. */
    private static void frame(SceneCanvas canvas) throws Exception {
        CompletableFuture<BufferedImage> next = canvas.next();
        while (!next.isDone()) {
            canvas.getView().repaint();
            try {
                next.get(2, TimeUnit.MILLISECONDS);
            } catch (TimeoutException e) {
                continue;
            }
        }
    }
}
