package radiosity.formfactor;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.mesh.PatchTree;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.scene.SceneBuilder;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;
import radiosity.visibility.RadiosityBounds;

/** Light that leaves the floor of a cube without a ceiling: the form factor of opposite sides is 0.19982. */
class EscapingLightTest {

    private static final double FACTOR = 0.19982;

    private static Faces openCube() {
        SceneBuilder builder = new SceneBuilder();
        for (int side : new int[] {0, 1, 2, 4, 5}) {
            builder.polygon(RoomScenes.grey("wall", 1, .5), Box.UNIT.inside(side));
        }
        return new Faces(builder.scene("open cube"));
    }

    /** The two triangles of the floor, the second of them in four elements. */
    private static List<PatchTree> floor(double radiosity) {
        double[] one = new double[3];
        double[] four = new double[15];
        Arrays.fill(one, radiosity);
        Arrays.fill(four, 3, 15, radiosity);
        return List.of(new PatchTree(4, NodePath.FACE, new int[] {-1}, one),
                new PatchTree(5, NodePath.FACE, new int[] {1, -1, -1, -1, -1}, four));
    }

    @Test
    void flux_isThatThroughTheOpening() {
        Faces faces = openCube();
        assertEquals(1, faces.channels());
        EscapingLight light = new EscapingLight(faces, new RadiosityBounds(faces.occluders()));
        double[] found = light.flux(floor(3), 1e-5);
        double error = Math.sqrt(found[1]);
        assertTrue(error > 0 && error < .01, "standard error of " + error);
        assertEquals(3 * FACTOR, found[0], 4 * error);
        assertArrayEquals(new double[] {-found[0], found[1]}, light.flux(floor(-3), 1e-5), 1e-12, "light taken back");
    }
}
