package radiosity.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Vec3;
import radiosity.testkit.RoomScenes;
import radiosity.visibility.RadiosityBounds;

class RadiosityNodesTest {

    @Test
    void positions_areTheSameForManyThreadsAtOnce() {
        Scene scene = new SceneBuilder().polygon(RoomScenes.grey("grey", 0, .5), Vec3.ZERO, new Vec3(3, 0, 0),
                new Vec3(1, 2, 0)).scene("triangle");
        Faces faces = new Faces(scene);
        Patcher patcher = new Patcher(faces, faces.area(0) / 1024, (f, small) -> null);
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

    /**
     * By that face, and by how bright a vertex is, is decided how exactly the vertex gathers: neither may depend on who
     * else is on the same host.
     */
    @Test
    void verticesThatTwoFacesShare_haveTheSameFaceOnEveryHost() {
        Scene scene = new SceneBuilder()
                .polygon(RoomScenes.grey("floor", 0, .5), Vec3.ZERO, new Vec3(0, 0, 9), new Vec3(9, 0, 0))
                .polygon(RoomScenes.grey("small", 0, .5), new Vec3(1, 1, 1), new Vec3(1, 1, 1.01),
                        new Vec3(1.01, 1, 1.01), new Vec3(1.003, 1, 1.001)).scene("two triangles over a floor");
        Faces faces = new Faces(scene);
        Patcher patcher = new Patcher(faces, faces.area(), (f, small) -> small ? faces.middle(f) : null);
        int[] small = IntStream.range(0, faces.count()).filter(patcher::isPoint).toArray();
        assertEquals(2, small.length);
        assertNotEquals(patcher.slack(small[0]), patcher.slack(small[1]), "one is as exact as the other");
        RadiosityNodes one = divided(patcher, small[0]);
        RadiosityNodes other = divided(patcher, small[1]);
        int shared = 0;
        for (int v : one.points().madeBy(1)) {
            for (int w : other.points().madeBy(1)) {
                if (one.points().key(v) == other.points().key(w)) {
                    assertEquals(one.points().face(v), other.points().face(w));
                    assertEquals(one.points().bright(v), other.points().bright(w));
                    shared++;
                }
            }
        }
        assertEquals(3, shared, "two corners and the middle between them");
    }

    /** The smallest have a side of 6e-5 of the scene. Rays begin at receiving points, which lie nearer to the wall. */
    @ParameterizedTest
    @ValueSource(ints = {4, 8, 10, 12, 14})
    void receivingPointsBesideWall_seeNothingBeyondWall(int depth) {
        Scene scene = new SceneBuilder()
                .polygon(RoomScenes.grey("floor", 0, .5), Vec3.ZERO, new Vec3(1, 0, 0), new Vec3(0, 1, 0))
                .polygon(RoomScenes.grey("wall", 0, .5), Vec3.ZERO, new Vec3(0, 1, 0), new Vec3(0, 1, 1),
                        new Vec3(0, 0, 1)).scene("a floor and a wall");
        Faces faces = new Faces(scene);
        Patcher patcher = new Patcher(faces, faces.area(), (f, small) -> null);
        RadiosityBounds bounds = new RadiosityBounds(faces.occluders());
        int[] middle = {NodePath.ONE / 2, 0, NodePath.ONE / 2};
        float[] place = new float[3];
        for (int a = 0; a < 3; a++) {
            place[a] = (faces.corner(0, 0, a) + faces.corner(0, 2, a)) / 2;
        }
        float[] receiver = new float[3];

        patcher.pull(0, middle, 0, depth, place, receiver, 0);

        assertFalse(bounds.isFree(new Vec3(receiver[0], receiver[1], receiver[2]), new Vec3(-1, 1, 3).unit(),
                new RadiosityBounds.Blocker()));
    }

    private static RadiosityNodes divided(Patcher patcher, int face) {
        RadiosityNodes nodes = new RadiosityNodes(patcher,
                List.of(new Block(0, new int[] {face}, new long[] {NodePath.FACE})));
        nodes.points().setBright(nodes.corner(nodes.patch(0), 0), face % (Patcher.MOST_SLACK + 1));
        nodes.split(nodes.patch(0), 1);
        return nodes;
    }
}
