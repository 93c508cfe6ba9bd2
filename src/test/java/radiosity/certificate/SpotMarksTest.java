package radiosity.certificate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.protocol.Mark;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.StopRule;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;
import radiosity.util.ParallelFor;

/** The spot of a lamp close before a wall, between the vertices of the first mesh, is found by independent points. */
class SpotMarksTest {

    private static final double ASKED = 0.1;
    private static final double X = 2.6;
    private static final double Z = 1.3;

    /** A wall of 8 m by 4 m, a lamp of 12 cm by 12 cm 6 cm before the wall, and a dim ceiling 4 m before the wall. */
    private static Scene spot() {
        Surface lamp = RoomScenes.grey("lamp", 300, 0);
        return new SceneBuilder()
                .polygon(RoomScenes.grey("wall", 0, 0.5), new Vec3(0, 0, 0), new Vec3(0, 0, 4),
                        new Vec3(8, 0, 4), new Vec3(8, 0, 0))
                .polygon(lamp, new Vec3(X - .06, .06, Z - .06), new Vec3(X + .06, .06, Z - .06),
                        new Vec3(X + .06, .06, Z + .06), new Vec3(X - .06, .06, Z + .06))
                .polygon(RoomScenes.grey("ceiling", 2, .5), new Vec3(0, 4, 0), new Vec3(8, 4, 0), new Vec3(8, 4, 4),
                        new Vec3(0, 4, 4))
                .scene("a lamp before a wall");
    }

    /** Patches are as large as half the wall, and the mesh is not refined: only the points tell of the spot. */
    private static Marked marked(double meshError) throws IOException {
        Scene scene = spot();
        RadiositySettings coarse = Solve.byDefault().accurate(ASKED).patches(scene, 4).settings();
        RadiositySettings undivided = new RadiositySettings(coarse.patchArea(), coarse.rays(), coarse.meshing(),
                coarse.schedule(), coarse.tolerance(), Double.POSITIVE_INFINITY);
        try (LocalWorld world = new LocalWorld(scene, undivided, 2)) {
            ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, new StopRule(1000, .02));
            radiosity.run(progress -> true);
            Audit audit = new Audit(world.mesh, world, world.blocks(), radiosity.ledger(),
                    radiosity.progress().elements(), ASKED, 7, new ParallelFor(2));
            audit.certificate(0);
            Marked marked = audit.marked(meshError);
            assertEquals(!marked.marks().isEmpty(), marked.marks().stream().anyMatch(mark -> holds(world, mark)));
            return marked;
        }
    }

    /** Whether a marked node lies on the wall and reaches within .3 m of the spot. */
    private static boolean holds(LocalWorld world, Mark mark) {
        float[] corner = world.mesh.faces.corners(mark.face(), mark.path());
        Vec3 foot = world.mesh.faces.unit(new Vec3(X, 0, Z));
        double near = .3 / world.mesh.faces.size();
        return Math.abs(corner[1] - foot.y()) < 1e-6 && within(corner, 0, foot.x(), near)
                && within(corner, 2, foot.z(), near);
    }

    private static boolean within(float[] corner, int axis, double x, double near) {
        double low = Math.min(corner[axis], Math.min(corner[axis + 3], corner[axis + 6]));
        double high = Math.max(corner[axis], Math.max(corner[axis + 3], corner[axis + 6]));
        return low - near <= x && x <= high + near;
    }

    @Test
    void spot_isMarked() throws IOException {
        Marked marked = marked(.1);
        assertTrue(marked.marks().size() > 0, "no mark");
        assertTrue(marked.share() > .5 && marked.share() <= 1, "share " + marked.share());
    }

    @Test
    void errorThatAnElementMayHave_isNotMarked() throws IOException {
        assertEquals(new Marked(List.of(), 0), marked(100));
    }
}
