package radiosity.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.accuracy.ColouredRoom.assertSame;
import static radiosity.world.SameBitsTest.SCENE;
import static radiosity.world.SameBitsTest.shots;
import static radiosity.world.SameBitsTest.solve;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** By prediction clusters belong to several hosts, and one of them gathers at a point for all who have it. */
class BorderPointsTest {

    private static final RadiositySettings SETTINGS = new RadiositySettings(SCENE.area() / 3000, 1,
            Double.POSITIVE_INFINITY, Schedule.PREDICT, 1, 1e-2);
    private static final StopRule STOP = shots(1000);

    private static Solution local;

    @BeforeAll
    static void solveHere() throws IOException {
        local = solve(new LocalWorld(SCENE, SETTINGS, 2), STOP);
    }

    private static RemoteWorld world(List<Link> links) throws IOException {
        return new RemoteWorld(SCENE, SETTINGS, 1, line -> { }, links, System::nanoTime);
    }

    private static Solution remote(List<Link> links) throws IOException {
        try (RemoteWorld world = world(links)) {
            return solve(world, STOP);
        }
    }

    @Test
    void clustersAreCut_inParts() {
        InitialMesh mesh = new InitialMesh(SCENE, SETTINGS);
        assertTrue(mesh.blocks.size() >= 2 * mesh.clusters.clusters.size(), mesh.blocks.size() + " blocks");
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5})
    void anyNumberOfHosts_givesTheSameBitsAsLocal(int hosts) throws IOException {
        assertSame(local, remote(TestLink.sound(hosts, 2)));
    }

    @Test
    void pointsOfSeveralHosts_areGatheredOnce() throws IOException {
        long one = gathered(1);
        assertTrue(one > 0);
        assertEquals(one, gathered(4));
    }

    /** Pairs of point and step, on all hosts together. */
    private static long gathered(int hosts) throws IOException {
        AtomicLong told = new AtomicLong();
        List<Link> links = new ArrayList<>();
        for (int h = 0; h < hosts; h++) {
            links.add(counting(new TestLink("host" + h, 1, round -> false), told));
        }
        try (RemoteWorld world = world(links)) {
            new ProgressiveRadiosity(world, STOP, Double.MIN_VALUE).run(progress -> true);
        }
        return told.get();
    }

    private static Link counting(TestLink link, AtomicLong told) {
        RemotePartition behind = link.behind;
        link.behind = (RemotePartition) Proxy.newProxyInstance(Link.class.getClassLoader(),
                new Class<?>[] {RemotePartition.class}, (proxy, method, arguments) -> {
                    Object result = method.invoke(behind, arguments);
                    if (method.getName().equals("round") && Order.decode((byte[]) arguments[2]).gathers()) {
                        told.addAndGet(Reply.decode((byte[]) result).work().stream().mapToLong(BlockWork::told).sum());
                    }
                    return result;
                });
        return link;
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16})
    void hostThatDiesAnywhere_losesNothing(int round) throws IOException {
        List<Link> links = new ArrayList<>(TestLink.sound(2, 1));
        links.add(1, new TestLink("igge", 1, r -> r == round));
        assertSame(local, remote(links));
    }

    /** Between any two steps: what hosts owe each other is told before; 0: nobody dies. */
    @ParameterizedTest
    @ValueSource(ints = {0, 4, 5, 6, 7, 8, 9, 10, 11, 12})
    void statesAskedForInMidRound_changeNothing(int dies) throws IOException {
        List<Link> links = new ArrayList<>(TestLink.sound(2, 1));
        links.add(new TestLink("igge", 1, r -> r == dies));
        try (RemoteWorld world = world(links)) {
            ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, STOP, Double.MIN_VALUE);
            rounds.run(progress -> state(rounds).length > 0);
            assertSame(local, rounds.solution());
        }
    }

    private static byte[] state(ProgressiveRadiosity rounds) {
        try {
            return rounds.state();
        } catch (IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    @Test
    void stoppedInMidRound_isResumedOnOthersToTheSameBits() throws IOException {
        Solution half = solve(world(TestLink.sound(3, 1)), shots(local.shots() / 2));
        ProgressiveRadiosity rest = new ProgressiveRadiosity(world(TestLink.sound(2, 1)), STOP);
        rest.resume(half.state());
        rest.run(progress -> true);
        assertSame(local, rest.solution());
    }
}
