package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.Accuracy;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/**
 * Small lamps just above a floor: all light of the room comes from spots that no corner of the first mesh touches.
 * Elements at whose corners nothing is seen of that are looked into before they are believed.
 */
@Tag("slow")
class HiddenSpotsTest {

    private static final double SIZE = .08;
    private static final double ABOVE = .04;

    private static Scene room() {
        SceneBuilder builder = new SceneBuilder();
        Surface wall = RoomScenes.grey("wall", 0, .6);
        Box room = new Box(Vec3.ZERO, new Vec3(3, 3, 3));
        for (int side = 0; side < 6; side++) {
            builder.polygon(wall, room.inside(side));
        }
        Surface lamp = RoomScenes.grey("lamp", 200, 0);
        for (int i = 0; i < 9; i++) {
            double x = .41 + i % 3;
            double z = .37 + i / 3;
            builder.polygon(lamp, new Vec3(x, ABOVE, z), new Vec3(x + SIZE, ABOVE, z), new Vec3(x + SIZE, ABOVE, z + SIZE),
                    new Vec3(x, ABOVE, z + SIZE));
        }
        return builder.scene("hidden spots");
    }

    @Test
    void spots_areFound() {
        double error = Solve.byDefault().certified(room(), true).certificate().expected();
        assertTrue(error <= Accuracy.DEFAULT, "expected error of " + error);
    }
}
