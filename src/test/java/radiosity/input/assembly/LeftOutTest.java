package radiosity.input.assembly;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import radiosity.scene.Affine;
import radiosity.scene.Hierarchy;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.SceneNode;
import radiosity.scene.Surface;
import radiosity.testkit.RoomScenes;

/** A strip of four triangles: a wall, a pane and another wall of two objects, of which one is below a house. */
class LeftOutTest {

    private static final List<Surface> SURFACES = List.of(RoomScenes.grey("wall", 0, .5),
            RoomScenes.grey("pane", 1, .2));
    private static final Hierarchy HIERARCHY = new Hierarchy(List.of(
            new SceneNode("house", -1, "", Affine.IDENTITY), new SceneNode("annex", 0, "annex", Affine.IDENTITY),
            new SceneNode("shed", -1, "shed", Affine.IDENTITY)), new int[] {1, 1, 2, 2});

    private static Scene strip() {
        float[] coordinates = new float[24];
        float[] colours = new float[36];
        for (int i = 0; i < colours.length; i++) {
            colours[i] = i / 36f;
            coordinates[i * 2 / 3] = i * 2 / 3;
        }
        return new Scene("strip", new double[] {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0, 2, 1, 0},
                new int[] {0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5}, new int[] {0, 1, 1, 0}, SURFACES, List.of(),
                Optional.empty(), coordinates, colours, HIERARCHY);
    }

    @Test
    void surface_isLeftOutWithItsPoints() throws SceneFormatException {
        Scene scene = strip();
        Scene rest = LeftOut.of(scene, Set.of("pane"));
        assertArrayEquals(new int[] {0, 0}, rest.surfaceOf());
        assertArrayEquals(scene.points(), rest.points(), "each point is of a triangle that stays");
        assertArrayEquals(new int[] {0, 2, 1, 3, 4, 5}, rest.corners());
        assertArrayEquals(new float[] {0, 1, 2, 3, 4, 5, 18, 19, 20, 21, 22, 23}, rest.textureCoordinates());
        assertEquals(27 / 36f, rest.vertexColours()[9]);
        assertArrayEquals(new int[] {1, 2}, rest.hierarchy().nodeOf());
        assertEquals(List.of(), rest.lamps());
    }

    @Test
    void object_isLeftOutWithAllBelowIt() throws SceneFormatException {
        Scene scene = strip();
        Scene rest = LeftOut.of(scene, Set.of("house"));
        assertArrayEquals(new int[] {2, 2}, rest.hierarchy().nodeOf());
        assertArrayEquals(Arrays.copyOfRange(scene.points(), 6, 18), rest.points());
        assertArrayEquals(new int[] {0, 2, 1, 1, 2, 3}, rest.corners());
        for (int t = 0; t < 2; t++) {
            for (int k = 0; k < 3; k++) {
                assertEquals(scene.corner(t + 2, k), rest.corner(t, k));
            }
        }
        assertEquals(rest.points().length, LeftOut.of(scene, Set.of("annex")).points().length);
    }

    @Test
    void withoutNames_theSceneStays() throws SceneFormatException {
        Scene scene = strip();
        assertSame(scene, LeftOut.of(scene, Set.of()));
    }

    @Test
    void sceneWithoutObjectsAndColours_keepsNone() throws SceneFormatException {
        Scene scene = strip();
        Scene plain = new Scene("plain", scene.points(), scene.corners(), scene.surfaceOf(), SURFACES, List.of(),
                Optional.empty());
        Scene rest = LeftOut.of(plain, Set.of("wall"));
        assertEquals(2, rest.triangles());
        assertEquals(new Rgb(1, 1, 1), rest.surface(0).exitance());
        assertEquals(0, rest.textureCoordinates().length + rest.vertexColours().length);
    }

    @Test
    void unknownNames_andAllOfIt_areRefused() {
        assertEquals("strip: expected a surface or an object that is called glass (--leave-out), got wall, pane, house,"
                + " annex, shed", assertThrows(SceneFormatException.class, () -> LeftOut.of(strip(),
                Set.of("glass", "wall"))).getMessage());
        assertEquals("strip: expected triangles that --leave-out does not name, got none",
                assertThrows(SceneFormatException.class, () -> LeftOut.of(strip(), Set.of("house", "shed")))
                        .getMessage());
    }
}
