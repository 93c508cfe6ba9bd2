package radiosity.partition;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.face.NodePath;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.setup.InitialMesh;
import radiosity.testkit.RoomScenes;
import radiosity.util.ParallelFor;

/** What vertices of a divided mesh receive for themselves, and what they take from the ends of their edges. */
class EdgeMiddlesTest {

    /** A lamp over a floor; one patch of the floor is divided twice. */
    private static final Scene SCENE = new SceneBuilder()
            .polygon(RoomScenes.grey("lamp", 1, 0), new Vec3(.1, 3, 0), new Vec3(1.3, 3, .2), new Vec3(0, 2.9, .7))
            .polygon(RoomScenes.grey("floor", 0, .5), Vec3.ZERO, new Vec3(0, 0, 4), new Vec3(4, 0, 4), new Vec3(4, 0, 0))
            .scene("a lamp over a floor");
    private static final InitialMesh MESH = new InitialMesh(SCENE, RadiositySettings.defaults());

    private final RadiosityNodes nodes = new RadiosityNodes(MESH.patcher, MESH.blocks);
    /** A patch inside a triangle of the floor. */
    private final int patch = floor(0);
    private final int known = nodes.vertices();
    private final EdgeMiddles middles = new EdgeMiddles(nodes, MESH.patcher);

    /** A patch of which so many corners lie on the edge that the two triangles of the floor share. */
    private int floor(int corners) {
        return IntStream.range(0, nodes.patches()).map(nodes::patch)
                .filter(p -> nodes.exitance(p, 0) == 0 && onSharedEdge(p) == corners).findFirst().orElseThrow();
    }

    private int onSharedEdge(int node) {
        int[] weights = new int[9];
        NodePath.weights(nodes.path(node), weights);
        int edge = IntStream.range(0, 3).filter(k -> !MESH.faces.isBorder(nodes.face(node), k)).findFirst()
                .orElseThrow();
        return (int) IntStream.range(0, 3).filter(k -> weights[3 * k + edge] == 0).count();
    }

    private void divide(int node) {
        nodes.beginSplits(5);
        int first = nodes.split(node, 1);
        for (int k = 0; k < 4; k++) {
            nodes.split(first + k, 2);
        }
    }

    @Test
    void middlesOfPatchesGather_andThoseOfTheirPartsComeAfterTheEndsOfTheirEdges() {
        divide(patch);
        int[] all = IntStream.range(0, nodes.vertices()).toArray();
        int[][] waves = middles.waves(all);
        assertEquals(2, waves.length);
        assertEquals(known + 3, waves[0].length);
        assertEquals(9, waves[1].length);
        for (int v : waves[1]) {
            assertTrue(Arrays.binarySearch(waves[0], middles.end(v, 0)) >= 0);
            assertTrue(Arrays.binarySearch(waves[0], middles.end(v, 1)) >= 0);
        }
        int[][] one = middles.waves(new int[] {waves[1][4]});
        int[] ends = {middles.end(waves[1][4], 0), middles.end(waves[1][4], 1)};
        Arrays.sort(ends);
        assertArrayEquals(new int[][] {ends, {waves[1][4]}}, one);
    }

    @Test
    void onAnEdgeThatFacesShare_middlesAreTheSame() {
        divide(floor(2));
        int[][] waves = middles.waves(IntStream.range(0, nodes.vertices()).toArray());
        assertEquals(known + 3, waves[0].length);
        assertEquals(9, waves[1].length);
    }

    /** Vertices on the edge that the initial mesh of the other face has, or of which they are the middles, gather. */
    @Test
    void whereTheFaceAcrossHasAFinerInitialMesh_middlesGather() {
        Scene scene = new SceneBuilder().polygon(RoomScenes.grey("floor", 0, .5), Vec3.ZERO, new Vec3(0, 0, 4),
                new Vec3(4, 0, 4), new Vec3(.7, 0, .1)).scene("two triangles of unlike size");
        InitialMesh mesh = new InitialMesh(scene, RadiositySettings.defaults());
        int edge = IntStream.range(0, mesh.faces.across.length).filter(e -> mesh.faces.across[e] >= 0
                && mesh.patcher.level(mesh.faces.across[e]) == 1 + mesh.patcher.level(e / 3)).findFirst().orElseThrow();
        RadiosityNodes floor = new RadiosityNodes(mesh.patcher, mesh.blocks);
        int node = IntStream.range(0, floor.patches()).map(floor::patch).filter(p -> floor.face(p) == edge / 3
                && IntStream.range(0, 3).filter(k -> weight(floor, p, k, edge % 3) == 0).count() == 2).findFirst()
                .orElseThrow();
        int before = floor.vertices();
        floor.beginSplits(5);
        int first = floor.split(node, 1);
        for (int k = 0; k < 4; k++) {
            floor.split(first + k, 2);
        }
        int[][] waves = new EdgeMiddles(floor, mesh.patcher).waves(IntStream.range(0, floor.vertices()).toArray());
        assertEquals(before + 3 + 2, waves[0].length);
        assertEquals(7, waves[1].length);
    }

    private static int weight(RadiosityNodes nodes, int node, int corner, int of) {
        int[] weights = new int[9];
        NodePath.weights(nodes.path(node), weights);
        return weights[3 * corner + of];
    }

    @Test
    void meshThatIsDividedLater_isLookedAtAgain() {
        assertEquals(1, middles.waves(new int[] {0}).length);
        divide(patch);
        assertEquals(2, middles.waves(IntStream.range(0, nodes.vertices()).toArray()).length);
    }

    /** Where a ray may carry all light, all ends receive alike; where it may carry none, none do. */
    @Test
    void middles_takeTheMeanOfEndsThatReceiveAlike_andGatherElsewhere() {
        divide(patch);
        double[] gathered = shoot(1e-6, false);
        assertArrayEquals(gathered, shoot(1e-6, true), 1e-12);
        double[] mixed = shoot(1e3, true);
        int[] gathering = middles.waves(IntStream.range(0, nodes.vertices()).toArray())[0];
        double[] coarse = shoot(1e3, false);
        for (int v : gathering) {
            assertEquals(coarse[v], mixed[v], 1e-12);
        }
        for (int v = known + 3; v < nodes.vertices(); v++) {
            double mean = (mixed[middles.end(v, 0)] + mixed[middles.end(v, 1)]) / 2;
            assertTrue(mean > 0);
            assertEquals(mean, mixed[v], 1e-15);
            assertNotEquals(mean, gathered[v], 1e-6 * mean);
        }
    }

    /** Irradiance after the lamp has shot, W/m². */
    private double[] shoot(double tolerance, boolean interpolates) {
        Arrays.fill(nodes.light().irradiance(), 0);
        List<Shot> shots = MESH.blocks.stream().map(block -> Shot.of(nodes, nodes.tops(block), 0,
                (element, values, at) -> Arrays.fill(values, at, at + 3, nodes.exitance(element, 0)))).toList();
        Order order = new Order(Order.Kind.SHOOT, shots, new Order.Rules(tolerance, new double[] {1}, 0),
                Order.Question.NOTHING);
        Gatherer gatherer = new Gatherer(MESH, new ParallelFor(2));
        int[] all = IntStream.range(0, nodes.vertices()).toArray();
        if (interpolates) {
            Gatherer.Work work = gatherer.work(order);
            new EdgeInterpolation(MESH, gatherer, nodes, new ParallelFor(2)).add(work.shooters(), work.calculators(),
                    order.rules(), 1, all, 0, (run, nanoseconds) -> { });
        } else {
            gatherer.gather(order, nodes, all, 0);
        }
        return nodes.light().irradiance().clone();
    }
}
