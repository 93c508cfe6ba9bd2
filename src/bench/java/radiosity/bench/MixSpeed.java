package radiosity.bench;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.DoubleStream;
import javax.swing.SwingUtilities;
import radiosity.output.gltf.LitScene;
import radiosity.output.image.ToneMapping;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Rgb;
import radiosity.viewer.ViewSettings;
import radiosity.viewer.Walkthrough;

/** Measures how long a lamp's slider takes to change the picture; docs/VIEWER.md has the command and figures. */
final class MixSpeed {

    private static final int MOVES = 20;

    private MixSpeed() { }

    /** @param arguments a scene file whose lamps are kept apart */
    public static void main(String[] arguments) throws Exception {
        LitScene scene = LitScene.read(Path.of(arguments[0]));
        Walkthrough window = Walkthrough.open(scene, new ViewSettings("mix", false, false, Optional.empty(),
                ToneMapping.Operator.REINHARD, 0, 512, 512, Optional.empty(), Optional.empty(), Optional.empty()));
        window.screenshot();
        double[] milliseconds = new double[MOVES];
        for (int i = 0; i < MOVES; i++) {
            Rgb factor = Rgb.grey(i / 10.0);
            long begin = System.nanoTime();
            SwingUtilities.invokeAndWait(() -> window.display().lamp(0, factor));
            milliseconds[i] = (System.nanoTime() - begin) * 1e-6;
        }
        long vertices = scene.meshes().stream().mapToLong(Mesh::vertices).sum();
        System.out.printf("%d elements, %d vertices, %d lamps, %d bytes of layers: %.0f ms in the mean, %.0f at least%n",
                scene.meshes().stream().mapToInt(Mesh::elements).sum(), vertices, scene.lamps().size(),
                12 * vertices * scene.lamps().size(), Arrays.stream(milliseconds).average().orElseThrow(),
                DoubleStream.of(milliseconds).min().orElseThrow());
        System.exit(0);
    }
}
