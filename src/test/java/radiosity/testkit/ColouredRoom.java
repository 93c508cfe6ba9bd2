package radiosity.testkit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;

/** A coloured room with two blocks, of which the higher one glows: solved in a second, to be solved here and there. */
public final class ColouredRoom {

    public static final Scene SCENE = scene();

    private ColouredRoom() { }

    private static Scene scene() {
        SceneBuilder builder = new SceneBuilder();
        addTo(builder);
        return builder.scene("coloured room");
    }

    static void addTo(SceneBuilder builder) {
        Box room = new Box(Vec3.ZERO, new Vec3(0.556, 0.5488, 0.5592));
        for (int side = 0; side < 6; side++) {
            builder.polygon(new Surface("wall " + side, Rgb.BLACK, new Rgb(0.2 + 0.1 * side, 0.6, 0.5), false),
                    room.inside(side));
        }
        RoomScenes.CORNELL_BLOCKS.get(0).addTo(builder, RoomScenes.grey("block", 0, 0.7));
        RoomScenes.CORNELL_BLOCKS.get(1).addTo(builder, RoomScenes.grey("lamp", 1, 0.3));
    }

    /** To the last bit, and to go on from. */
    public static void assertSame(Solution expected, Solution got) {
        assertEquals(expected.shots(), got.shots());
        assertEquals(expected.unshotFlux(), got.unshotFlux());
        assertArrayEquals(expected.corners(), got.corners());
        assertArrayEquals(expected.positions(), got.positions());
        assertArrayEquals(expected.irradiance(), got.irradiance());
        assertEquals(expected.state(), got.state());
    }
}
