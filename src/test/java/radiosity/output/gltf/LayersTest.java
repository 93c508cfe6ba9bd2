package radiosity.output.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.output.image.ToneMapping;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Lamp;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;

/** The light of two lamps, kept apart in a scene file. */
class LayersTest {

    private static final Rgb GLOW = new Rgb(2, 3, 4);
    private static final Rgb RHO = new Rgb(.5, .25, .125);
    private static final List<Lamp> LAMPS = List.of(new Lamp("glowing", true, 0), new Lamp("sun", false, 0));

    @TempDir
    Path folder;

    /** A triangle that glows; at vertex i the first lamp's irradiance is i, i + 1, i + 2, the second's a tenth. */
    private static Solution solution() {
        Handmade hand = new Handmade();
        int triangle = hand.triangle(hand.surface("glowing", GLOW, RHO, false), new Vec3(0, 0, 0), new Vec3(1, 0, 0),
                new Vec3(0, 1, 0));
        hand.element(2 * triangle, hand.vertex(new Vec3(0, 0, 0), Rgb.BLACK), hand.vertex(new Vec3(1, 0, 0), Rgb.BLACK),
                hand.vertex(new Vec3(0, 1, 0), Rgb.BLACK));
        Solution plain = hand.solution();
        double[] irradiance = new double[6 * plain.vertices()];
        for (int i = 0; i < irradiance.length; i++) {
            irradiance[i] = (i / 6 + i % 3) * (i % 6 < 3 ? 1 : 0.1);
        }
        return new Solution(plain.scene(), 6, LAMPS, plain.positions(), irradiance, plain.corners(), plain.faceOf(), 0,
                0,
                0, Handmade.LEDGER, SavedState.NONE);
    }

    private LitScene written() throws IOException {
        Path file = folder.resolve("two.scene");
        SceneFile.write(file, solution(), Map.of(), Optional.empty(), new ToneMapping(ToneMapping.Operator.LINEAR, 1));
        assertTrue(SceneInfo.lines(file).stream().anyMatch(line -> line.matches("lamps +2 kept apart: glowing, sun")));
        return LitScene.read(file);
    }

    @Test
    void sumOfTheLayers_isTheWhole() throws IOException {
        LitScene scene = written();
        assertEquals(LAMPS, scene.lamps());
        Mesh mesh = scene.meshes().get(0);
        for (int i = 0; i < mesh.irradiance().length; i++) {
            double h = 1.1 * (i / 3 + i % 3);
            assertEquals(h, mesh.irradiance()[i], 1e-6 * h);
            assertEquals(h, mesh.layers().get(0)[i] + mesh.layers().get(1)[i], 1e-6 * h);
            assertEquals(GLOW.channel(i % 3) + RHO.channel(i % 3) * h, mesh.radiosity()[i], 1e-6 * h + 1e-6);
        }
    }

    @Test
    void mixture_isMadeOfEachLampsLight() throws IOException {
        Rgb warm = new Rgb(1, .5, 0);
        Mesh mesh = written().mixed(List.of(warm, Rgb.grey(3))).meshes().get(0);
        for (int i = 0; i < mesh.irradiance().length; i++) {
            double factor = warm.channel(i % 3);
            double h = (factor + .3) * (i / 3 + i % 3);
            assertEquals(h, mesh.irradiance()[i], 1e-6 * h);
            assertEquals(factor * GLOW.channel(i % 3) + RHO.channel(i % 3) * h, mesh.radiosity()[i], 1e-6 * (h + 4));
        }
    }
}
