package radiosity.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.protocol.BlockState;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.setup.InitialMesh;
import radiosity.testkit.RoomScenes;

/** Which vertices are bright, and what becomes of that when the mesh is divided or saved. */
class BrightVerticesTest {

    private static final InitialMesh MESH = mesh(RoomScenes.grey("floor", 0, .5));

    private final RadiosityNodes nodes = new RadiosityNodes(MESH.patcher, MESH.blocks);

    private static InitialMesh mesh(Surface surface) {
        Scene scene = new SceneBuilder().polygon(surface, Vec3.ZERO, new Vec3(0, 0, 4), new Vec3(4, 0, 4),
                new Vec3(4, 0, 0)).scene("a floor");
        return new InitialMesh(scene, RadiositySettings.defaults());
    }

    private int bright(double irradiance) {
        Arrays.fill(nodes.light().irradiance(), irradiance);
        BrightVertices.find(nodes, Weights.of(new double[] {.2}));
        return nodes.points().bright(0);
    }

    /** A tenth of the irradiance is the reflected radiosity over its mean. */
    @Test
    void fromSixTimesTheMeanOn_raysMayCarryAsMuchMoreAsAnErrorMay() {
        assertEquals(0, bright(-1e9));
        assertEquals(0, bright(0));
        assertEquals(0, bright(59.9));
        assertEquals(1, bright(60.1));
        assertEquals(1, bright(119.9));
        assertEquals(2, bright(120.1));
        assertEquals(3, bright(240.1));
        assertEquals(3, bright(1e30));
        assertEquals(0, bright(Double.NaN));
    }

    @Test
    void whatIsBrightInOneColourOnly_isNotBright() {
        InitialMesh mesh = mesh(new Surface("floor", Rgb.BLACK, new Rgb(.5, .25, 0), false));
        RadiosityNodes coloured = new RadiosityNodes(mesh.patcher, mesh.blocks);
        assertEquals(3, coloured.channels());
        Weights weights = Weights.of(new double[] {1, 1, 1});
        Arrays.fill(coloured.light().irradiance(), 100); // 50, 25 and nothing, as blue is not reflected
        BrightVertices.find(coloured, weights);
        assertEquals(3, coloured.points().bright(0));
        for (int v = 0; v < coloured.vertices(); v++) {
            coloured.light().irradiance()[3 * v + 1] = 30;
        }
        BrightVertices.find(coloured, weights);
        assertEquals(1, coloured.points().bright(0));
        for (int v = 0; v < coloured.vertices(); v++) {
            coloured.light().irradiance()[3 * v + 1] = 0;
        }
        BrightVertices.find(coloured, weights);
        assertEquals(0, coloured.points().bright(0));
    }

    @Test
    void newVertex_isAsBrightAsTheDarkerEndOfItsEdge() {
        int patch = nodes.patch(0);
        for (int k = 0; k < 3; k++) {
            nodes.points().setBright(nodes.corner(patch, k), 1 + k);
        }
        nodes.beginSplits(1);
        int first = nodes.split(patch, 1);
        for (int k = 0; k < 3; k++) {
            int darker = Math.min(1 + (k + 1) % 3, 1 + (k + 2) % 3);
            assertEquals(darker, nodes.points().bright(nodes.corner(first + 3, k)));
        }
    }

    @Test
    void savedState_keepsIt() {
        int patch = nodes.patch(0);
        nodes.beginSplits(1);
        int first = nodes.split(patch, 1);
        for (int v = 0; v < nodes.vertices(); v++) {
            nodes.points().setBright(v, v % 4);
        }
        nodes.points().bury(nodes.corner(first, 1));
        List<byte[]> states = MESH.blocks.stream().map(b -> BlockState.write(nodes, nodes.tops(b))).toList();
        RadiosityNodes restored = new RadiosityNodes(MESH.patcher, MESH.blocks);
        for (int b = 0; b < states.size(); b++) {
            BlockState.restore(restored, restored.tops(MESH.blocks.get(b)), states.get(b));
        }
        assertTrue(restored.points().isBuried(restored.corner(restored.child(restored.patch(0)), 1)));
        for (int node = 0; node < nodes.nodes(); node++) {
            for (int k = 0; k < 3; k++) {
                assertEquals(nodes.points().bright(nodes.corner(node, k)),
                        restored.points().bright(restored.corner(node, k)));
            }
        }
    }
}
