package radiosity.partition;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.mesh.Block;
import radiosity.mesh.Patcher;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Vec3;
import radiosity.testkit.RoomScenes;
import radiosity.util.ParallelFor;

/** What is divided, by the light that is known of it. */
class MeshRefinementTest {

    private static int elements(double meshError) {
        Scene scene = new SceneBuilder()
                .polygon(RoomScenes.grey("wall", 0, .5), Vec3.ZERO, new Vec3(0, 0, 10), new Vec3(10, 0, 0))
                .polygon(RoomScenes.grey("bar", 0, .5), new Vec3(1, 1, 1), new Vec3(1, 1, 2), new Vec3(2, 1, 1))
                .scene("a bar before a wall");
        Faces faces = new Faces(scene);
        RadiosityNodes bar = new RadiosityNodes(new Patcher(faces, faces.area(), true),
                List.of(new Block(0, new int[] {1}, new long[] {NodePath.FACE})));
        new MeshRefinement(bar, Weights.of(new double[] {1, 1, 1}), meshError).splitAll(1, new ParallelFor(1));
        return bar.elements();
    }

    /** Its corners are where other bars cover it: between them may be the sky. */
    @Test
    void faceWithDarkCorners_isDivided_whereItsAreaMatters() {
        assertEquals(4, elements(.1));
        assertEquals(1, elements(.5));
    }
}
