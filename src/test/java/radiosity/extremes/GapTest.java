package radiosity.extremes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.Radiosity;
import radiosity.RadiosityResult;
import radiosity.master.RemoteWorld;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.StopRule;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.SameBitsTest;
import radiosity.testkit.Box;
import radiosity.testkit.ColouredRoom;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.TestLink;

/** Whole renders of things that stand close to a wall: what a coarse mesh lights in the gap is taken back. */
@Tag("slow")
class GapTest {

    private static final double ASKED = .05;
    private static final double GAP = .002;
    /** Light between wall and panel over that beside the panel: .21 here, and .52 where unshot light is left. */
    private static final double MOST = .3;

    private static Scene scene() {
        SceneBuilder builder = new SceneBuilder();
        RoomScenes.addRoom(builder, RoomScenes.grey("room", 0, .75), new Box(Vec3.ZERO, new Vec3(4, 2.5, 3.5)));
        RoomScenes.addSolid(builder, RoomScenes.grey("lamp", 25, 0), new Vec3(1.7, 2.4, 1.5), new Vec3(2.3, 2.45, 2));
        for (int i = 0; i < 6; i++) {
            RoomScenes.addSolid(builder, RoomScenes.grey("panel", 0, .7), new Vec3(4 - GAP - .004, .9, .5 + .45 * i),
                    new Vec3(4 - GAP, 1.3, .8 + .45 * i));
        }
        return builder.scene("gaps");
    }

    @Test
    void wallBehindPanels_isDark() throws IOException {
        RadiosityResult result = Radiosity.of(scene()).accuracy(ASKED).threads(2).run(progress -> true);
        Vec3 inward = new Vec3(-1, 0, 0);
        double beside = result.points().at(new Vec3(4, .7, 1.1), inward).irradiance().r();
        double behind = result.points().at(new Vec3(4, 1.13, 1.11), inward).irradiance().r();
        assertTrue(behind <= MOST * beside, behind + " behind, " + beside + " beside");
        double expected = result.certificate().orElseThrow().expected();
        assertTrue(expected <= ASKED, "error " + expected);
    }

    /**
     * A box 2 cm before a wall of reflectance .8. The radiosities on its back, from its upper edge down, are those of a
     * path tracer of its own with a million paths per point, whose standard errors are .016 to .0025.
     */
    @Test
    void lightFadesInAGap() throws IOException {
        SceneBuilder builder = new SceneBuilder();
        RoomScenes.addRoom(builder, RoomScenes.grey("room", 0, .8), new Box(Vec3.ZERO, new Vec3(4, 2.8, 4)));
        RoomScenes.addSolid(builder, RoomScenes.grey("box", 0, .8), new Vec3(3, 0, 1.5), new Vec3(3.98, .45, 2.7));
        RoomScenes.addSolid(builder, RoomScenes.grey("housing", 0, .8), new Vec3(1.7, 2.601, 1.7),
                new Vec3(2.3, 2.66, 2.3));
        builder.polygon(RoomScenes.grey("lamp", 200, .5), new Vec3(1.7, 2.6, 1.7), new Vec3(2.3, 2.6, 1.7),
                new Vec3(2.3, 2.6, 2.3), new Vec3(1.7, 2.6, 2.3));
        RadiosityResult result = Radiosity.of(builder.scene("gap")).accuracy(.02).threads(2).run(progress -> true);
        double mean = 72 / .2 / 78;
        double[][] depths = {{.43, 1.658}, {.4, .727}, {.35, .273}, {.3, .124}, {.2, .039}};
        for (double[] depth : depths) {
            double radiosity = result.points().at(new Vec3(3.98, depth[0], 2.1), new Vec3(1, 0, 0)).radiosity().r();
            assertEquals(depth[1], radiosity, .02 * mean, "at height " + depth[0]);
        }
    }

    @Test
    void rest_isShotByTheSameRays_onTwoHosts() throws IOException {
        RadiositySettings settings = RadiositySettings.defaults().accurate(ASKED);
        StopRule stop = new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT, 2);
        Solution alone = SameBitsTest.solve(new LocalWorld(scene(), settings, 2), stop);
        try (RemoteWorld hosts = new RemoteWorld(scene(), settings, 1, line -> { }, TestLink.sound(2, 1),
                System::nanoTime)) {
            ColouredRoom.assertSame(alone, SameBitsTest.solve(hosts, stop));
        }
    }
}
