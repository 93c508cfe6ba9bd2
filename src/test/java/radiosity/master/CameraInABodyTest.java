package radiosity.master;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import radiosity.master.host.Link;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.StopRule;
import radiosity.solution.SavedState;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.solver.World;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.TestLink;

/** A closed body around the camera keeps its inner sides, on hosts as well: they have the faces that the master has. */
class CameraInABodyTest {

    private static final RadiositySettings SETTINGS = RadiositySettings.defaults().accurate(.2);
    private static final StopRule STOP = new StopRule(1000, StopRule.DEFAULT_UNSENT);
    private static final Box ROOM = new Box(Vec3.ZERO, new Vec3(2, 2, 2));
    private static final Box BODY = new Box(new Vec3(.5, .5, .5), new Vec3(1, 1, 1));

    private static SceneBuilder room(Optional<Camera> camera) {
        SceneBuilder builder = new SceneBuilder();
        Surface sheet = new Surface("sheet", Rgb.BLACK, Rgb.grey(.5), true);
        for (int side = 0; side < 6; side++) {
            builder.polygon(RoomScenes.grey("wall", side == 0 ? 1 : 0, .5), ROOM.inside(side));
            builder.polygon(sheet, BODY.inside(side));
        }
        camera.ifPresent(builder::camera);
        return builder;
    }

    private static SavedState state(World world) throws IOException {
        try (world) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
            radiosity.run(progress -> true);
            return radiosity.state();
        }
    }

    @Test
    void bodyAroundTheCamera_hasTheSameBitsOnHosts() throws IOException {
        Camera camera = new Camera(new Vec3(.75, .75, .75), new Vec3(0, 0, 1), new Vec3(0, 1, 0), .5, 1);
        for (Optional<Camera> at : List.of(Optional.of(camera), Optional.<Camera>empty())) {
            SceneBuilder room = room(at);
            LocalWorld local = new LocalWorld(room.scene("room"), SETTINGS, 1);
            assertEquals(at.isPresent() ? 36 : 24, sides(local));
            SavedState alone = state(local);
            List<Link> hosts = List.of(new TestLink("a", 1, round -> false), new TestLink("b", 1, round -> false));
            assertEquals(alone, state(new RemoteWorld(room.scene("room"), SETTINGS, 1, line -> { }, hosts,
                    System::nanoTime)));
        }
    }

    /** Number of sides of triangles of the scene that have a face. */
    private static long sides(LocalWorld world) {
        return IntStream.range(0, world.mesh.faces.count()).map(world.mesh.faces::side).distinct().count();
    }
}
