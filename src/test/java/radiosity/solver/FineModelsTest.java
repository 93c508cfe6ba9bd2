package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.testkit.ColouredRoom.assertSame;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleBiFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.mesh.PatchTree;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.RepresentativeFaces;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.prediction.CoarseSystem;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.setup.InitialMesh;
import radiosity.solution.Solution;
import radiosity.testkit.RoomScenes;

/** A ball of 8192 triangles in a cube: modelled finer than light needs. */
@Tag("slow")
class FineModelsTest {

    private static final int LEVELS = 5;
    private static final int TRIANGLES = 8 << 2 * LEVELS;
    private static final double RADIUS = 0.15;
    private static final Vec3 MIDDLE = new Vec3(0.6, 0.5, 0.55);
    private static final Surface WALL = RoomScenes.grey("wall", 1, 0.5);
    private static final Surface LAMP = RoomScenes.grey("lamp", 2, 0);
    private static final Surface DULL = RoomScenes.grey("dull", 0, 0.6);

    private static Scene ball(Surface lamp, Surface wall) {
        return ball(lamp, wall, true);
    }

    private static Scene ball(Surface lamp, Surface wall, boolean closed) {
        SceneBuilder room = new SceneBuilder();
        Vec3[] c = new Vec3[8];
        for (int i = 0; i < 8; i++) {
            c[i] = new Vec3(i & 1, i >> 1 & 1, i >> 2);
        }
        room.polygon(lamp, c[4], c[6], c[7], c[5]).polygon(wall, c[0], c[1], c[3], c[2])
                .polygon(wall, c[0], c[4], c[5], c[1])
                .polygon(wall, c[2], c[3], c[7], c[6]).polygon(wall, c[0], c[2], c[6], c[4]);
        if (closed) {
            room.polygon(wall, c[1], c[5], c[7], c[3]);
        }
        for (int octant = 0; octant < 8; octant++) {
            Vec3 x = new Vec3((octant & 1) == 0 ? 1 : -1, 0, 0);
            Vec3 y = new Vec3(0, (octant & 2) == 0 ? 1 : -1, 0);
            Vec3 z = new Vec3(0, 0, (octant & 4) == 0 ? 1 : -1);
            boolean outward = x.cross(y).dot(z) > 0;
            divide(room, wall, x, outward ? y : z, outward ? z : y, LEVELS);
        }
        return room.scene("ball");
    }

    private static void divide(SceneBuilder room, Surface wall, Vec3 a, Vec3 b, Vec3 c, int levels) {
        if (levels == 0) {
            room.polygon(wall, place(a), place(b), place(c));
            return;
        }
        Vec3 ab = a.plus(b).unit();
        Vec3 bc = b.plus(c).unit();
        Vec3 ca = c.plus(a).unit();
        divide(room, wall, a, ab, ca, levels - 1);
        divide(room, wall, ab, b, bc, levels - 1);
        divide(room, wall, ca, bc, c, levels - 1);
        divide(room, wall, ab, bc, ca, levels - 1);
    }

    private static Vec3 place(Vec3 direction) {
        return MIDDLE.plus(direction.times(RADIUS));
    }

    private static RadiositySettings settings() {
        return RadiositySettings.defaults().accurate(0.05);
    }

    @Test
    void furnace_isExactOnEverySmallFace() throws IOException {
        Solution found = SameBitsTest.solve(new LocalWorld(ball(WALL, WALL), settings(), 2),
                SameBitsTest.shots(10_000));
        double low = Double.POSITIVE_INFINITY;
        double high = 0;
        for (int e = 0; e < found.elements(); e++) {
            for (int k = 0; k < 3; k++) {
                low = Math.min(low, found.radiosityAt(e, k).r());
                high = Math.max(high, found.radiosityAt(e, k).r());
            }
        }
        assertEquals(2, low, 0.02);
        assertEquals(2, high, 0.02);
    }

    @Test
    void smallFaces_receiveAtOnePointEach_andFewStandForMany() {
        InitialMesh mesh = new InitialMesh(ball(LAMP, DULL), settings());
        RadiosityNodes nodes = new RadiosityNodes(mesh.patcher, mesh.blocks);
        assertTrue(nodes.vertices() < TRIANGLES + 2000, "one vertex per triangle of the ball, got " + nodes.vertices());
        RepresentativeFaces representatives = mesh.representatives;
        assertTrue(representatives.followers() > TRIANGLES / 2, "others stand for most, got " + representatives.followers());
        for (int f = 0; f < mesh.faces.count(); f++) {
            assertEquals(representatives.leader(f), representatives.leader(representatives.leader(f)));
            double alike = 0;
            for (int a = 0; a < 3; a++) {
                alike += (double) mesh.faces.normal(f, a) * mesh.faces.normal(representatives.leader(f), a);
            }
            assertTrue(alike > -1e-6, "they look the same way");
        }
    }

    @Test
    void rebalancedPrediction_hasTheLightThatFacesHaveReflected_alsoOfThoseThatAnotherRepresents() throws IOException {
        LocalWorld world = new LocalWorld(ball(LAMP, DULL, false), settings(), 2);
        CoarseSystem system = withRows(world);
        List<Shot> importance = system.importance();
        Faces faces = world.mesh.faces;
        List<Shot> emitted = each(importance, (tree, i) -> faces.exitance(tree.face(), i % faces.channels()));
        List<Shot> first = system.with(emitted, system.irradiance(system.restrict(emitted), () -> true), true);
        List<Shot> other = each(first, (tree, i) -> {
            double e = faces.exitance(tree.face(), i % faces.channels());
            return e + (tree.radiosity()[i] - e) * (0.6 + 0.2 * (tree.face() % 5));
        });
        system.rebalance(other, new double[system.restrict(emitted).length]);
        double[] wanted = system.restrict(other);
        double[] found = system.restrict(system.with(emitted, system.irradiance(system.restrict(emitted), () -> true), true));
        double[] before = system.restrict(first);
        int changed = 0;
        for (int i = 0; i < wanted.length; i++) {
            assertEquals(wanted[i], found[i], 0.1 * wanted[i], "rows know means, equations corners");
            changed += Math.abs(before[i] - wanted[i]) > 0.15 * wanted[i] ? 1 : 0;
        }
        assertTrue(changed > TRIANGLES / 4, "most have another radiosity than before, got " + changed);
    }

    @Test
    void changeByEvenLight_isAboveItsMean_whereSomeSurfacesReflectNone() throws IOException {
        LocalWorld world = new LocalWorld(ball(LAMP, DULL), settings(), 2);
        CoarseSystem system = withRows(world);
        double[] dark = new double[system.restrict(List.of()).length];
        double[] even = system.irradiance(dark, () -> true).clone();
        Arrays.fill(even, 1);
        Weights weights = new Weights(world.mesh.rooms, 3, new double[] {1, 1, 1});
        CoarseSystem.Change change = system.change(even, dark, weights, 0);
        double lamp = 1 / (6 + 4 * Math.PI * RADIUS * RADIUS);
        assertEquals(0.6 * (1 - lamp), change.bias(), 1e-3);
        assertEquals(0.6 * Math.sqrt(1 - lamp), change.size(), 1e-3);
    }

    private static CoarseSystem withRows(LocalWorld world) throws IOException {
        CoarseSystem system = new CoarseSystem(world.mesh, world.parallel);
        List<Shot> importance = system.importance();
        system.take(importance.size(), world.round(new Order(Order.Kind.ROWS, importance, new Order.Rules(0.02,
                new double[] {1, 1, 1}, 0), Order.Question.candidates(0))));
        return system;
    }

    /** Shots with another radiosity at each corner and channel. */
    private static List<Shot> each(List<Shot> shots, ToDoubleBiFunction<PatchTree, Integer> radiosity) {
        return shots.stream().map(shot -> new Shot(shot.trees().stream().map(tree -> new PatchTree(tree.face(),
                tree.path(), tree.child(), IntStream.range(0, tree.radiosity().length)
                .mapToDouble(i -> radiosity.applyAsDouble(tree, i)).toArray())).toList(), shot.flux())).toList();
    }

    @Test
    void paperSchedule_hasThreePointsPerTriangle() {
        RadiositySettings d = RadiositySettings.defaults();
        InitialMesh mesh = new InitialMesh(ball(LAMP, DULL), new RadiositySettings(0, 0, d.meshing(), Schedule.PAPER));
        assertTrue(new RadiosityNodes(mesh.patcher, mesh.blocks).vertices() > 3 * TRIANGLES);
    }

    @Test
    void dealtAndResumed_givesTheSameBits() throws IOException {
        Scene ball = ball(LAMP, DULL);
        Solution local = SameBitsTest.solve(new LocalWorld(ball, settings(), 2), SameBitsTest.shots(10_000));
        assertSame(local, SameBitsTest.solve(new LocalWorld(ball, settings(), 1, 3), SameBitsTest.shots(10_000)));
        Solution first = SameBitsTest.solve(new LocalWorld(ball, settings(), 2), SameBitsTest.shots(local.shots() / 2));
        ProgressiveRadiosity rest = new ProgressiveRadiosity(new LocalWorld(ball, settings(), 1, 2),
                SameBitsTest.shots(10_000));
        rest.resume(first.state());
        rest.run(progress -> true);
        assertSame(local, rest.solution());
    }

    @Test
    void solution_hasEverySmallFaceWithItsOwnCorners() throws IOException {
        Solution found = SameBitsTest.solve(new LocalWorld(ball(LAMP, DULL), settings(), 2),
                SameBitsTest.shots(10_000));
        double[] at = found.positions();
        int small = 0;
        for (int e = 0; e < found.elements(); e++) {
            int[] v = {found.corners()[3 * e], found.corners()[3 * e + 1], found.corners()[3 * e + 2]};
            boolean onBall = List.of(0, 1, 2).stream().allMatch(k -> Math.abs(new Vec3(at[3 * v[k]], at[3 * v[k] + 1],
                    at[3 * v[k] + 2]).minus(MIDDLE).length() - RADIUS) < 1e-9);
            if (onBall) {
                small++;
                assertEquals(found.radiosityAt(e, 0), found.radiosityAt(e, 1));
                assertTrue(v[0] != v[1] && v[1] != v[2]);
            }
        }
        assertEquals(TRIANGLES, small);
    }
}
