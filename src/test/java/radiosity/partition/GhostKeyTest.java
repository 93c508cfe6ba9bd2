package radiosity.partition;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import org.junit.jupiter.api.Test;
import radiosity.mesh.RadiosityNodes;
import radiosity.settings.RadiositySettings;
import radiosity.setup.InitialMesh;
import radiosity.testkit.ColouredRoom;

/** Hosts share ghost values only between vertices that gather the same. */
class GhostKeyTest {

    private static RadiosityNodes nodes() {
        InitialMesh mesh = new InitialMesh(ColouredRoom.SCENE, RadiositySettings.defaults());
        return new RadiosityNodes(mesh.patcher, mesh.blocks);
    }

    @Test
    void vertexAsBright_withTheSameLight_hasTheSameKeyOnEveryHost() {
        assertEquals(GhostVertices.keyWithLight(nodes(), 0), GhostVertices.keyWithLight(nodes(), 0));
    }

    /** A brighter vertex has other rays. */
    @Test
    void brighterVertex_hasAnotherKey() {
        RadiosityNodes nodes = nodes();
        nodes.points().setBright(0, 1);
        assertNotEquals(GhostVertices.keyWithLight(nodes(), 0), GhostVertices.keyWithLight(nodes, 0));
    }

    @Test
    void vertexWithOtherLight_hasAnotherKey() {
        RadiosityNodes nodes = nodes();
        nodes.light().irradiance()[0] += 1;
        assertNotEquals(GhostVertices.keyWithLight(nodes(), 0), GhostVertices.keyWithLight(nodes, 0));
    }
}
