package radiosity.master;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.solver.SameBitsTest.SCENE;
import static radiosity.solver.SameBitsTest.shots;
import static radiosity.solver.SameBitsTest.solve;
import static radiosity.testkit.ColouredRoom.assertSame;

import java.io.IOException;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import radiosity.master.host.Link;
import radiosity.master.host.NoWorkerException;
import radiosity.protocol.Greeting;
import radiosity.rmi.Build;
import radiosity.rmi.RemotePartition;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.solution.Progress;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.solver.SameBitsTest;
import radiosity.testkit.TestLink;

/** The law of the house over hosts that come and go; their network is a method call. */
@Tag("slow")
class RemoteWorldTest {

    private static final int SHOTS = 90;
    private static final Map<Schedule, Solution> LOCAL = new EnumMap<>(Schedule.class);

    private final List<String> notices = new CopyOnWriteArrayList<>();

    private static RadiositySettings settings(Schedule schedule) {
        RadiositySettings settings = SameBitsTest.settings(schedule);
        return new RadiositySettings(settings.patchArea(), settings.rays(), settings.meshing(), schedule, 0.5, 8e-3);
    }

    private static Solution local(Schedule schedule) throws IOException {
        Solution solution = LOCAL.get(schedule);
        if (solution == null) {
            solution = solve(new LocalWorld(SCENE, settings(schedule), 2), shots(SHOTS));
            LOCAL.put(schedule, solution);
        }
        return solution;
    }

    private RemoteWorld world(Schedule schedule, List<Link> links) throws IOException {
        return new RemoteWorld(SCENE, settings(schedule), 1, notices::add, links, System::nanoTime);
    }

    private Solution remote(Schedule schedule, List<Link> links) throws IOException {
        try (RemoteWorld world = world(schedule, links)) {
            return solve(world, shots(SHOTS));
        }
    }

    private boolean said(String regex) {
        return notices.stream().anyMatch(line -> line.matches(regex));
    }

    private static List<Link> with(TestLink one, int others) {
        List<Link> links = new ArrayList<>(TestLink.sound(others, 1));
        links.add(one);
        return links;
    }

    @ParameterizedTest
    @CsvSource({"PAPER,1,1", "PAPER,2,2", "PAPER,3,1", "PAPER,7,1", "PREDICT,1,1", "PREDICT,2,2", "PREDICT,3,1",
            "PREDICT,7,1"})
    void anyNumberOfHosts_givesTheSameBitsAsLocal(Schedule schedule, int hosts, int threads) throws IOException {
        assertSame(local(schedule), remote(schedule, TestLink.sound(hosts, threads)));
        assertEquals(List.of(), notices);
    }

    @ParameterizedTest
    @CsvSource({"PAPER,1", "PAPER,2", "PAPER,16", "PAPER,21", "PAPER,22", "PREDICT,1", "PREDICT,3", "PREDICT,4"})
    void deadHost_losesNothing(Schedule schedule, int round) throws IOException {
        TestLink mortal = new TestLink("igge", 1, r -> r == round);
        assertSame(local(schedule), remote(schedule, with(mortal, 2)));
        assertTrue(mortal.isDead());
        assertTrue(said("host igge lost \\(no connection\\); its \\d+ blocks move to \\d hosts?, rebuilt in .* s"),
                notices::toString);
    }

    /** It is there, and waits for a round that never comes. */
    @ParameterizedTest
    @EnumSource(Schedule.class)
    @Timeout(60)
    void roundThatNeverReachesAHost_losesNothing(Schedule schedule) throws IOException {
        TestLink deaf = new TestLink("igge", 1, r -> false);
        deaf.unreached = 3;
        assertSame(local(schedule), remote(schedule, with(deaf, 2)));
        assertTrue(said("host igge lost \\(no connection\\); .*"), notices::toString);
    }

    @ParameterizedTest
    @EnumSource(Schedule.class)
    void allHostsDead_goesOnAlone(Schedule schedule) throws IOException {
        List<Link> links = List.of(new TestLink("andreas", 1, r -> r == 3), new TestLink("daniel", 1, r -> r == 4));
        assertSame(local(schedule), remote(schedule, links));
        assertTrue(said("host daniel lost .* move to this machine, .*"), notices::toString);
    }

    @ParameterizedTest
    @EnumSource(Schedule.class)
    void hostsThatDieInTheSameRound_loseNothing(Schedule schedule) throws IOException {
        List<Link> links = new ArrayList<>(TestLink.sound(1, 1));
        for (String name : List.of("andreas", "daniel", "igge")) {
            links.add(new TestLink(name, 1, r -> r == 4));
        }
        assertSame(local(schedule), remote(schedule, links));
        assertEquals(3, notices.stream().filter(line -> line.contains("lost")).count());
    }

    @ParameterizedTest
    @EnumSource(Schedule.class)
    void returningHost_isGivenBlocksAgain(Schedule schedule) throws IOException {
        TestLink mortal = new TestLink("igge", 1, r -> r == 3);
        try (RemoteWorld world = world(schedule, with(mortal, 1))) {
            ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, shots(SHOTS));
            rounds.run(progress -> {
                if (mortal.isDead()) {
                    mortal.revive();
                }
                return waitFor(progress, mortal);
            });
            assertSame(local(schedule), rounds.solution());
            assertTrue(said("host igge joined"), notices::toString);
            assertTrue(world.statistics().hosts().stream()
                    .anyMatch(host -> host.name().equals("igge") && host.blocks() > 0), "it works again");
        }
    }

    /** Gives the search for missing hosts its time. */
    private boolean waitFor(Progress progress, TestLink returned) {
        if (said("host igge lost.*") && !said("host igge joined") && !returned.isDead()) {
            try {
                Thread.sleep(500);
            } catch (InterruptedException e) {
                return false;
            }
        }
        return true;
    }

    @ParameterizedTest
    @EnumSource(Schedule.class)
    void resumedOnOtherHosts_givesTheSameBitsAsAtOnce(Schedule schedule) throws IOException {
        Solution first = solve(world(schedule, TestLink.sound(2, 1)), shots(53));
        ProgressiveRadiosity rest = new ProgressiveRadiosity(world(schedule, TestLink.sound(3, 1)), shots(SHOTS));
        rest.resume(first.state());
        rest.run(progress -> true);
        assertSame(local(schedule), rest.solution());
    }

    @Test
    void noHost_isRefused() {
        TestLink dead = new TestLink("igge", 1, r -> false);
        dead.behind = null;
        assertThrows(NoWorkerException.class, () -> world(Schedule.PAPER, List.of()));
    }

    @Test
    void otherVersion_isRefused_withOneLine() {
        TestLink other = new TestLink("igge", 1, r -> false);
        byte[] greeting = new Greeting("0.9", "another", 1, "", 1).encode();
        RemotePartition real = other.behind;
        other.behind = (RemotePartition) java.lang.reflect.Proxy.newProxyInstance(Link.class.getClassLoader(),
                new Class<?>[] {RemotePartition.class},
                (proxy, method, arguments) -> method.getName().equals("greet") ? greeting
                        : method.invoke(real, arguments));
        assertThrows(NoWorkerException.class, () -> world(Schedule.PAPER, List.of(other)));
        assertEquals(List.of("host igge runs 0.9, this is " + Build.version() + ": copy the jar there"), notices);
    }
}
