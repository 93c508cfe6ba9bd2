package radiosity.master;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.solver.SameBitsTest.SCENE;
import static radiosity.solver.SameBitsTest.shots;
import static radiosity.solver.SameBitsTest.solve;
import static radiosity.testkit.ColouredRoom.assertSame;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.master.host.Link;
import radiosity.protocol.Order;
import radiosity.protocol.PiggybackMessage;
import radiosity.protocol.Reply;
import radiosity.protocol.Wire;
import radiosity.rmi.RemotePartition;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.testkit.TestLink;

/** A host that is behind the others hands points over to them in mid-round. */
@Tag("slow")
class MidRoundMigrationTest {

    private static final RadiositySettings SETTINGS =
            new RadiositySettings(SCENE.area() / 3000, 1, Double.POSITIVE_INFINITY, Schedule.PREDICT, 1, 2e-3);
    private static final StopRule STOP = shots(1000);
    /** By how much longer a step seems to take on a host that is behind, s. */
    private static final double LAG = 0.005;

    private static Solution local;

    /** How often hosts were told what. */
    private final Map<PiggybackMessage,
            AtomicInteger> told = new ConcurrentHashMap<>(new EnumMap<>(PiggybackMessage.class));

    @BeforeAll
    static void solveHere() throws IOException {
        local = solve(new LocalWorld(SCENE, SETTINGS, 2), STOP);
    }

    /** @param change of what the host says */
    private TestLink watched(TestLink link, UnaryOperator<Reply> change) {
        RemotePartition behind = link.behind;
        link.behind = (RemotePartition) Proxy.newProxyInstance(Link.class.getClassLoader(),
                new Class<?>[] {RemotePartition.class}, (proxy, method, arguments) -> {
                    Object result = method.invoke(behind, arguments);
                    if (!method.getName().equals("round")) {
                        return result;
                    }
                    note((byte[]) arguments[2]);
                    return change.apply(Reply.decode((byte[]) result)).encode();
                });
        return link;
    }

    private void note(byte[] order) throws IOException {
        DataInputStream in = Wire.input(order);
        Order.decode(in);
        if (in.available() > 0) {
            PiggybackMessage what = PiggybackMessage.of(in.readByte());
            told.computeIfAbsent(what, w -> new AtomicInteger()).incrementAndGet();
        }
    }

    private static Reply late(Reply reply) {
        return new Reply(reply.answer(), reply.cpu(), reply.seconds() + LAG, reply.work(), reply.given());
    }

    /** What it was to hand out left out. */
    private static Reply silent(Reply reply) {
        return late(new Reply(reply.answer(), reply.cpu(), reply.seconds(), reply.work(),
                Arrays.copyOf(reply.given(), Math.min(reply.given().length, Integer.BYTES))));
    }

    private List<Link> links(int sound, TestLink behind, UnaryOperator<Reply> change) {
        List<Link> links = new ArrayList<>();
        for (int h = 0; h < sound; h++) {
            links.add(watched(new TestLink("host" + h, 1, round -> false), reply -> reply));
        }
        links.add(watched(behind, change));
        return links;
    }

    private static RemoteWorld world(List<Link> links) throws IOException {
        return new RemoteWorld(SCENE, SETTINGS, 1, line -> { }, links, System::nanoTime);
    }

    /** In steps of one shot. */
    private static Solution solution(RemoteWorld world) throws IOException {
        ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, STOP, Double.MIN_VALUE);
        rounds.run(progress -> true);
        return rounds.solution();
    }

    private Solution solution(List<Link> links) throws IOException {
        try (RemoteWorld world = world(links)) {
            return solution(world);
        }
    }

    private int times(PiggybackMessage what) {
        return told.getOrDefault(what, new AtomicInteger()).get();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4})
    void hostBehindOthers_handsPointsOverAndChangesNothing(int others) throws IOException {
        assertSame(local, solution(links(others, new TestLink("igge", 1, round -> false),
                MidRoundMigrationTest::late)));
        assertTrue(times(PiggybackMessage.HAND_OVER) > 1, "told of handing over: " + times(PiggybackMessage.HAND_OVER));
        assertTrue(times(PiggybackMessage.HANDED_OVER) > 0, "told what was handed over: "
                + times(PiggybackMessage.HANDED_OVER));
    }

    @Test
    void hostThatDoesNotSayWhatItHandsOver_changesNothing() throws IOException {
        assertSame(local, solution(links(2, new TestLink("igge", 1, round -> false), MidRoundMigrationTest::silent)));
        assertTrue(times(PiggybackMessage.HAND_OVER) > 1, "told of handing over: " + times(PiggybackMessage.HAND_OVER));
    }

    static Stream<Arguments> deaths() {
        return Stream.of(true, false)
                .flatMap(behind -> IntStream.range(0, 16).mapToObj(round -> Arguments.of(behind, round)));
    }

    /** @param round from the one on in which points are handed over first */
    @ParameterizedTest
    @MethodSource("deaths")
    void hostThatDiesThenOrLater_losesNothing(boolean isBehind, int round) throws IOException {
        AtomicInteger since = new AtomicInteger();
        TestLink mortal = new TestLink("igge", 1, r -> times(PiggybackMessage.HAND_OVER) > 0
                && since.getAndIncrement() == round);
        List<Link> links = links(1, isBehind ? mortal : new TestLink("late", 1, r -> false),
                MidRoundMigrationTest::late);
        links.add(isBehind ? new TestLink("sound", 1, r -> false) : mortal);
        assertSame(local, solution(links));
        assertTrue(mortal.isDead());
    }

    /** Between any two steps, which ends what is handed over. */
    @Test
    void statesAskedForInMidRound_changeNothing() throws IOException {
        try (RemoteWorld world = world(links(2, new TestLink("igge", 1, round -> false),
                MidRoundMigrationTest::late))) {
            ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, STOP, Double.MIN_VALUE);
            AtomicInteger steps = new AtomicInteger();
            rounds.run(progress -> steps.incrementAndGet() % 16 > 0 || !state(rounds).isEmpty());
            assertSame(local, rounds.solution());
        }
        assertTrue(times(PiggybackMessage.HAND_OVER) > 1, "told of handing over: " + times(PiggybackMessage.HAND_OVER));
    }

    private static SavedState state(ProgressiveRadiosity rounds) {
        try {
            return rounds.state();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
