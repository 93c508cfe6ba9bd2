package radiosity.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import radiosity.mesh.face.Faces;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Vec3;
import radiosity.testkit.RoomScenes;

class RadiosityNodesTest {

    @Test
    void positions_areTheSameForManyThreadsAtOnce() {
        Scene scene = new SceneBuilder().polygon(RoomScenes.grey("grey", 0, .5), Vec3.ZERO, new Vec3(3, 0, 0),
                new Vec3(1, 2, 0)).scene("triangle");
        Faces faces = new Faces(scene);
        Patcher patcher = new Patcher(faces, faces.area(0) / 1024, false);
        RadiosityNodes nodes = new RadiosityNodes(patcher, Partitioner.blocks(patcher, 4));
        int n = nodes.nodes();
        double[] expected = new double[9 * n];
        double[] got = new double[9 * n];
        IntStream.range(0, 3 * n).forEach(i -> nodes.position(i / 3, i % 3, expected, 3 * i));
        for (int turn = 0; turn < 20; turn++) {
            IntStream.range(0, 3 * n).parallel().forEach(i -> nodes.position(i / 3, i % 3, got, 3 * i));
            assertArrayEquals(expected, got);
        }
    }
}
