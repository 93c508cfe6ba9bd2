package radiosity.master;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.master.host.Link;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.ReadOptions;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.SameBitsTest;
import radiosity.testkit.ColouredRoom;
import radiosity.testkit.TestLink;

/** Neighbours that were subdivided in different rounds have different histories at the vertices between them. */
@Tag("slow")
class DeepMeshTest {

    @Test
    void deepMeshDealtMovedAndLost_givesTheSameBitsAsLocal() throws IOException {
        Scene scene = LightWaveReader.read(Path.of("scenes/cornell-box.lws"), ReadOptions.defaults(), line -> { });
        RadiositySettings settings = new RadiositySettings(3500, 4, 0.05, Schedule.PAPER);
        StopRule stop = SameBitsTest.shots(300);
        Solution local = SameBitsTest.solve(new LocalWorld(scene, settings, 2), stop);
        ColouredRoom.assertSame(local, SameBitsTest.solve(new LocalWorld(scene, settings, 1, 5), stop));
        List<Link> links = List.of(new TestLink("daniel", 1, round -> false),
                new TestLink("igge", 1, round -> round == 90));
        try (RemoteWorld world = new RemoteWorld(scene, settings, 1, line -> { }, links, System::nanoTime)) {
            ColouredRoom.assertSame(local, SameBitsTest.solve(world, stop));
        }
    }
}
