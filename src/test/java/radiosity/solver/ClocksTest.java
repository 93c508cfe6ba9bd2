package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.LongSupplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import radiosity.master.RemoteWorld;
import radiosity.master.host.Link;
import radiosity.protocol.BlockWork;
import radiosity.protocol.Reply;
import radiosity.rmi.RemotePartition;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.RoundListener;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.testkit.ColouredRoom;
import radiosity.testkit.TestLink;

/**
 * Time has no part in the result: step sizes, answers in mid-round, checkpoints, blocks that move, and a
 * listener that saves now and then follow from random clocks; the bits do not.
 */
@Tag("slow")
class ClocksTest {

    /** Of each schedule: 1,000 in all. */
    private static final int CLOCKS = 200;
    /** One of this many worlds is on hosts, which takes longer. */
    private static final int HOSTS_EVERY = 2;
    private static final Scene SCENE = ColouredRoom.SCENE;
    private static final StopRule STOP = new StopRule(24, 1e-2);
    /** How often a listener saves by its clock, ns. */
    private static final long INTERVAL = 1_000_000_000;

    private static RadiositySettings settings(Schedule schedule) {
        double meshing = schedule == Schedule.PAPER ? 0.3 : Double.POSITIVE_INFINITY;
        return new RadiositySettings(SCENE.area() / 12, 1, meshing, schedule, 2, 2e-2);
    }

    /** Goes on by anything between nothing and some ten seconds per look, mostly within one order of magnitude. */
    private static LongSupplier clock(long seed) {
        Random random = new Random(seed);
        double usual = -9 * random.nextDouble();
        long[] now = {random.nextLong() >> 2};
        return () -> now[0] += random.nextInt(8) == 0 ? random.nextInt(2) * 10_000_000_000L
                : (long) (1e9 * StrictMath.pow(10, usual + random.nextDouble()));
    }

    /** Hosts that take random times, of the processor and by their clocks. */
    private static List<Link> links(long seed, int hosts) {
        List<Link> links = new ArrayList<>();
        for (int h = 0; h < hosts; h++) {
            TestLink link = new TestLink("host" + h, 1, round -> false);
            LongSupplier clock = clock(31 * seed + h);
            RemotePartition behind = link.behind;
            link.behind = (RemotePartition) Proxy.newProxyInstance(Link.class.getClassLoader(),
                    new Class<?>[] {RemotePartition.class}, (proxy, method, arguments) -> {
                        Object result = method.invoke(behind, arguments);
                        return method.getName().equals("round")
                                ? timed(Reply.decode((byte[]) result), clock).encode() : result;
                    });
            links.add(link);
        }
        return links;
    }

    private static Reply timed(Reply reply, LongSupplier clock) {
        long begin = clock.getAsLong();
        double seconds = (clock.getAsLong() - begin) * 1e-9;
        List<BlockWork> work = reply.work().stream()
                .map(block -> new BlockWork(block.elements(), block.points(), block.gathered(),
                        (float) (seconds / reply.work().size()))).toList();
        return new Reply(reply.answer(), seconds, seconds, work, reply.given());
    }

    private static World world(Schedule schedule, int seed) throws IOException {
        return seed % HOSTS_EVERY == 0
                ? new RemoteWorld(SCENE, settings(schedule), 1, line -> { }, links(seed, 2 + seed % 3), clock(seed))
                : new LocalWorld(SCENE, settings(schedule), 1, 1 + seed % 3, clock(seed));
    }

    @ParameterizedTest
    @EnumSource(Schedule.class)
    void randomClocks_giveTheSameBits(Schedule schedule) throws IOException {
        Solution expected = SameBitsTest.solve(new LocalWorld(SCENE, settings(schedule), 1), STOP);
        Set<List<Integer>> courses = new HashSet<>();
        for (int seed = 0; seed < CLOCKS; seed++) {
            int[] called = new int[2];
            try (World world = world(schedule, seed)) {
                ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, STOP);
                radiosity.run(saving(radiosity, clock(-seed), called));
                ColouredRoom.assertSame(expected, radiosity.solution());
            }
            courses.add(List.of(called[0], called[1]));
        }
        assertTrue(courses.size() > 3, "clocks decide on steps and savings: " + courses);
    }

    /** @param called how often it was called, and how often it has saved; modified */
    private static RoundListener saving(ProgressiveRadiosity radiosity, LongSupplier clock, int[] called) {
        long[] saved = {clock.getAsLong()};
        return progress -> {
            called[0]++;
            long now = clock.getAsLong();
            if (now - saved[0] > INTERVAL) {
                saved[0] = now;
                called[1]++;
                assertTrue(state(radiosity).length() > 0);
            }
            return true;
        };
    }

    private static SavedState state(ProgressiveRadiosity radiosity) {
        try {
            return radiosity.state();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
