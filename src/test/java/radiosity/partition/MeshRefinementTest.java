package radiosity.partition;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.mesh.Block;
import radiosity.mesh.Patcher;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.protocol.Mark;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Vec3;
import radiosity.testkit.RoomScenes;
import radiosity.util.ParallelFor;

/** What is divided, by the light that is known of it. */
class MeshRefinementTest {

    private static RadiosityNodes bar() {
        Scene scene = new SceneBuilder()
                .polygon(RoomScenes.grey("wall", 0, .5), Vec3.ZERO, new Vec3(0, 0, 10), new Vec3(10, 0, 0))
                .polygon(RoomScenes.grey("bar", 0, .9), new Vec3(1, 1, 1), new Vec3(1, 1, 2), new Vec3(2, 1, 1))
                .scene("a bar before a wall");
        Faces faces = new Faces(scene);
        return new RadiosityNodes(new Patcher(faces, faces.area(), (f, small) -> small ? faces.middle(f) : null),
                List.of(new Block(0, new int[] {1}, new long[] {NodePath.FACE})));
    }

    private static int divided(RadiosityNodes bar, double meshError, int with, Mark... marks) {
        new MeshRefinement(bar, Weights.of(new double[] {1, 1, 1}), meshError)
                .splitAll(with, List.of(marks), new ParallelFor(1));
        return bar.elements();
    }

    /** Its corners are where other bars cover it: between them may be the sky. */
    @Test
    void faceWithDarkCorners_isDivided_whereItsAreaMatters() {
        assertEquals(4, divided(dark(), .1, 1));
        assertEquals(1, divided(dark(), .5, 1));
    }

    /** Its corners lie behind the frame of the picture. */
    @Test
    void faceWithBlackCorners_isDivided_whereItCanBeSeen() {
        assertEquals(4, divided(bar(), .5, 1));
    }

    /** Its corners lie inside the frame of the picture, but the face does not. */
    @Test
    void faceWithBuriedCorners_isDivided_whereItCanBeSeen() {
        assertEquals(4, divided(buried(1), .5, 1));
        assertEquals(4, divided(buried(.4), .5, 1));
    }

    /** Only a speck of it lies outside of solids, or it is not known how much. */
    @Test
    void faceWithBuriedCorners_isNotDivided_whereItCannotBeSeen() {
        assertEquals(1, divided(buried(1e-4), .5, 1));
        assertEquals(1, divided(buried(Double.NaN), .5, 1));
    }

    private static RadiosityNodes buried(double visible) {
        RadiosityNodes bar = bar();
        bar.faces().cover(face -> visible);
        for (int k = 0; k < 3; k++) {
            bar.points().bury(bar.corner(0, k));
        }
        return bar;
    }

    /** No vertex of the evenly lit bar shows an error: it is divided around the mark, and nowhere else. */
    @Test
    void marks_areDividedWithAllAboveThem() {
        RadiosityNodes bar = bar();
        Arrays.fill(bar.light().irradiance(), .5);
        long part = NodePath.child(NodePath.child(NodePath.FACE, 3), 1);
        Mark elsewhere = new Mark(0, part);
        assertEquals(10, divided(bar, 3, 1, new Mark(1, part), elsewhere));
        assertEquals(10, divided(bar, 3, 2, new Mark(1, part), new Mark(1, NodePath.FACE)), "divided before");
        assertEquals(13, divided(bar, 3, 3, new Mark(1, NodePath.child(part, 0))));
    }

    private static RadiosityNodes dark() {
        RadiosityNodes bar = bar();
        Arrays.fill(bar.light().irradiance(), .02);
        return bar;
    }

    /** The light of a lamp beside both ends of a tube is not that along the tube, though the ends are equally lit. */
    @Test
    void faceWithBrightCorners_isDivided_whereItsFluxMatters() {
        RadiosityNodes bar = bar();
        Arrays.fill(bar.light().irradiance(), 20);
        assertEquals(4, divided(bar, 3, 1));
        RadiosityNodes lessBright = bar();
        Arrays.fill(lessBright.light().irradiance(), 2);
        assertEquals(1, divided(lessBright, 3, 1));
    }

    /** Its middle is where the next bar crosses it. */
    @Test
    void faceWithDarkMiddles_isDividedAgain_asLongAsItIsNotLit() {
        RadiosityNodes bar = bar();
        assertEquals(4, divided(bar, .03, 1));
        assertEquals(16, divided(bar, .03, 2));
        assertEquals(16, divided(bar, .03, 3), "too small to matter");
        RadiosityNodes lit = bar();
        divided(lit, .03, 1);
        Arrays.fill(lit.light().irradiance(), 1);
        assertEquals(4, divided(lit, .03, 2), "it is lit evenly");
    }
}
