package radiosity.master;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.solver.SameBitsTest.SCENE;
import static radiosity.solver.SameBitsTest.shots;
import static radiosity.solver.SameBitsTest.solve;
import static radiosity.testkit.ColouredRoom.assertSame;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.master.host.Link;
import radiosity.protocol.BlockWork;
import radiosity.protocol.Order;
import radiosity.protocol.Reply;
import radiosity.rmi.RemotePartition;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.setup.InitialMesh;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.testkit.TestLink;

/** Where no elements are divided between rounds, one of several hosts gathers at a point for all who have it. */
@Tag("slow")
class GhostVerticesTest {

    /** By prediction elements are divided three times: into many more, some more, and few more. */
    private static final Map<Schedule, RadiositySettings> SETTINGS = Map.of(
            Schedule.PREDICT, new RadiositySettings(SCENE.area() / 3000, 1, Double.POSITIVE_INFINITY, Schedule.PREDICT,
                    1, 2e-3),
            Schedule.PAPER, new RadiositySettings(SCENE.area() / 300, 1, Double.POSITIVE_INFINITY, Schedule.PAPER));
    private static final Map<Schedule,
            StopRule> STOP = Map.of(Schedule.PREDICT, shots(1000), Schedule.PAPER, shots(120));
    /** Of one host of three after which it dies. */
    private static final Map<Schedule, IntStream> ROUNDS = Map.of(
            Schedule.PREDICT, IntStream.of(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 20, 24, 28, 32, 36, 40, 44, 48),
            Schedule.PAPER, IntStream.rangeClosed(1, 19));

    private static final Map<Schedule, Solution> LOCAL = new EnumMap<>(Schedule.class);

    @BeforeAll
    static void solveHere() throws IOException {
        for (Schedule schedule : SETTINGS.keySet()) {
            LOCAL.put(schedule, solve(new LocalWorld(SCENE, SETTINGS.get(schedule), 2), STOP.get(schedule)));
        }
    }

    private static RemoteWorld world(Schedule schedule, List<Link> links) throws IOException {
        return new RemoteWorld(SCENE, SETTINGS.get(schedule), 1, line -> { }, links, System::nanoTime);
    }

    private static Solution remote(Schedule schedule, List<Link> links) throws IOException {
        try (RemoteWorld world = world(schedule, links)) {
            return solve(world, STOP.get(schedule));
        }
    }

    @Test
    void clustersAreCut_inParts() {
        InitialMesh mesh = new InitialMesh(SCENE, SETTINGS.get(Schedule.PREDICT));
        assertTrue(mesh.blocks.size() >= 2 * mesh.clusters.clusters.size(), mesh.blocks.size() + " blocks");
    }

    static Stream<Arguments> numbersOfHosts() {
        return SETTINGS.keySet().stream().flatMap(schedule -> Stream.of(1, 2, 5).map(n -> Arguments.of(schedule, n)));
    }

    @ParameterizedTest
    @MethodSource("numbersOfHosts")
    void anyNumberOfHosts_givesTheSameBitsAsLocal(Schedule schedule, int hosts) throws IOException {
        assertSame(LOCAL.get(schedule), remote(schedule, TestLink.sound(hosts, 2)));
    }

    @ParameterizedTest
    @EnumSource(names = {"PREDICT", "PAPER"})
    void pointsOfSeveralHosts_areGatheredOnce(Schedule schedule) throws IOException {
        long one = gathered(schedule, 1);
        assertTrue(one > 0);
        assertEquals(one, gathered(schedule, 4));
    }

    /** Pairs of point and step, on all hosts together. */
    private static long gathered(Schedule schedule, int hosts) throws IOException {
        AtomicLong told = new AtomicLong();
        List<Link> links = new ArrayList<>();
        for (int h = 0; h < hosts; h++) {
            links.add(counting(new TestLink("host" + h, 1, round -> false), told));
        }
        try (RemoteWorld world = world(schedule, links)) {
            new ProgressiveRadiosity(world, STOP.get(schedule), Double.MIN_VALUE).run(progress -> true);
        }
        return told.get();
    }

    private static Link counting(TestLink link, AtomicLong told) {
        boolean[] isShooting = {false};
        return replying(link, (order, reply) -> {
            isShooting[0] = order.gathers() ? order.kind() == Order.Kind.SHOOT : isShooting[0];
            // hosts may be asked before they gather at the rest of their points
            if (isShooting[0] && (order.gathers() || order.kind() == Order.Kind.REST)) {
                told.addAndGet(reply.work().stream().mapToLong(BlockWork::gathered).sum());
            }
            return reply;
        });
    }

    /** @param change of what the host replies to an order */
    private static Link replying(TestLink link, BiFunction<Order, Reply, Reply> change) {
        RemotePartition behind = link.behind;
        link.behind = (RemotePartition) Proxy.newProxyInstance(Link.class.getClassLoader(),
                new Class<?>[] {RemotePartition.class}, (proxy, method, arguments) -> {
                    Object result = method.invoke(behind, arguments);
                    return method.getName().equals("round") ? change.apply(Order.decode(((byte[][]) arguments[2])[0]),
                            Reply.decode((byte[]) result)).encode() : result;
                });
        return link;
    }

    static Stream<Arguments> lastRounds() {
        return ROUNDS.entrySet().stream().flatMap(e -> e.getValue().mapToObj(round -> Arguments.of(e.getKey(), round)));
    }

    @ParameterizedTest
    @MethodSource("lastRounds")
    void hostThatDiesAnywhere_losesNothing(Schedule schedule, int round) throws IOException {
        List<Link> links = new ArrayList<>(TestLink.sound(2, 1));
        TestLink mortal = new TestLink("igge", 1, r -> r == round);
        links.add(1, mortal);
        assertSame(LOCAL.get(schedule), remote(schedule, links));
        assertTrue(mortal.isDead());
    }

    /** The others gather themselves where it should have told what it has gathered. */
    @ParameterizedTest
    @EnumSource(names = {"PREDICT", "PAPER"})
    void hostThatTellsTooLittle_changesNothing(Schedule schedule) throws IOException {
        List<Link> links = new ArrayList<>(TestLink.sound(2, 1));
        AtomicLong leftOut = new AtomicLong();
        links.add(1, replying(new TestLink("igge", 1, r -> false), (order, reply) -> {
            leftOut.addAndGet(reply.given().length);
            return new Reply(reply.answer(), reply.cpu(), reply.seconds(), reply.work(), new byte[0]);
        }));
        assertSame(LOCAL.get(schedule), remote(schedule, links));
        assertTrue(leftOut.get() > 0);
    }

    /** The second one sometimes while what the first one had is made again. */
    @ParameterizedTest
    @EnumSource(names = {"PREDICT", "PAPER"})
    void twoHostsThatDieOneAfterTheOther_loseNothing(Schedule schedule) throws IOException {
        for (int later = 0; later < 4; later++) {
            int second = 6 + later;
            List<Link> links = new ArrayList<>(TestLink.sound(2, 1));
            links.add(1, new TestLink("igge", 1, r -> r == 6));
            links.add(1, new TestLink("daniel", 1, r -> r == second));
            assertSame(LOCAL.get(schedule), remote(schedule, links));
        }
    }

    static Stream<Arguments> midRounds() {
        return SETTINGS.keySet().stream().flatMap(schedule ->
                IntStream.of(0, 4, 5, 6, 7, 8, 9, 10, 11, 12).mapToObj(round -> Arguments.of(schedule, round)));
    }

    /** Between any two steps: what hosts owe each other is told before; 0: nobody dies. */
    @ParameterizedTest
    @MethodSource("midRounds")
    void statesAskedForInMidRound_changeNothing(Schedule schedule, int dies) throws IOException {
        List<Link> links = new ArrayList<>(TestLink.sound(2, 1));
        links.add(new TestLink("igge", 1, r -> r == dies));
        try (RemoteWorld world = world(schedule, links)) {
            ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, STOP.get(schedule), Double.MIN_VALUE);
            rounds.run(progress -> !state(rounds).isEmpty());
            assertSame(LOCAL.get(schedule), rounds.solution());
        }
    }

    private static SavedState state(ProgressiveRadiosity rounds) {
        try {
            return rounds.state();
        } catch (IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    @ParameterizedTest
    @EnumSource(names = {"PREDICT", "PAPER"})
    void stoppedInMidRound_isResumedOnOthersToTheSameBits(Schedule schedule) throws IOException {
        Solution local = LOCAL.get(schedule);
        Solution half = solve(world(schedule, TestLink.sound(3, 1)), shots(local.shots() / 2));
        ProgressiveRadiosity rest = new ProgressiveRadiosity(world(schedule, TestLink.sound(2, 1)), STOP.get(schedule));
        rest.resume(half.state());
        rest.run(progress -> true);
        assertSame(local, rest.solution());
    }
}
