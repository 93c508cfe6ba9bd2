package radiosity.distributed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import radiosity.master.RemoteWorld;
import radiosity.output.gltf.SceneFile;
import radiosity.rmi.HostAddress;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Progress;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.solver.World;
import radiosity.testkit.ColouredRoom;
import radiosity.testkit.Edits;

/** Hosts that are processes of their own, and what may happen to them: always the same bits, never a hang. */
@Tag("slow")
@Timeout(120)
class ProcessesTest {

    private static final RadiositySettings CHANGED = RadiositySettings.defaults().accurate(0.05);
    private static final StopRule TO_THE_END = new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT);

    private final List<String> notices = new CopyOnWriteArrayList<>();

    /** What happens after a round. */
    private interface Event {
        void after(int round) throws IOException, InterruptedException;
    }

    private Solution solve(Schedule schedule, Event event, Server... servers) throws IOException {
        List<HostAddress> addresses = new ArrayList<>();
        for (Server server : servers) {
            addresses.add(new HostAddress("localhost", server.port()));
        }
        try (RemoteWorld world = new RemoteWorld(Small.SCENE, Small.settings(schedule), addresses, null, 1,
                notices::add)) {
            ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, Small.STOP);
            int[] round = {0};
            rounds.run(progress -> happen(event, ++round[0], progress));
            return rounds.solution();
        }
    }

    private Solution changed(Scene scene, SavedState old, Event event, Server... servers) throws IOException {
        List<HostAddress> addresses = Stream.of(servers).map(s -> new HostAddress("localhost", s.port())).toList();
        try (World world = servers.length == 0 ? new LocalWorld(scene, CHANGED, 2)
                : new RemoteWorld(scene, CHANGED, addresses, null, 1, notices::add)) {
            ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, TO_THE_END);
            assertEquals(Optional.empty(), old.isEmpty() ? Optional.empty() : rounds.change(old));
            int[] round = {0};
            rounds.run(progress -> happen(event, ++round[0], progress));
            return rounds.solution();
        }
    }

    private static boolean happen(Event event, int round, Progress progress) {
        try {
            event.after(round);
            return true;
        } catch (IOException | InterruptedException e) {
            throw new IllegalStateException(progress.toString(), e);
        }
    }

    private long said(String regex) {
        return notices.stream().filter(line -> line.matches(regex)).count();
    }

    @Test
    void killedHosts_loseNothing() throws Exception {
        try (Server a = new Server(); Server b = new Server(); Server c = new Server()) {
            Solution got = solve(Schedule.PREDICT, round -> {
                if (round == 2) {
                    a.kill();
                }
            }, a, b, c);
            ColouredRoom.assertSame(Small.local(Schedule.PREDICT), got);
            assertEquals(1, said("host localhost:" + a.port()
                    + " lost \\(.*\\); its \\d+ blocks move to \\d hosts?, .*"),
                    notices::toString);
            Solution alone = solve(Schedule.PAPER, round -> {
                if (round == 20) {
                    b.kill();
                    c.kill();
                }
            }, b, c);
            ColouredRoom.assertSame(Small.local(Schedule.PAPER), alone);
            assertTrue(said(".* move to this machine, .*") >= 1, notices::toString);
        }
    }

    /** A block is moved and a wall repainted: the light follows on any hosts, and where one of them is killed. */
    @Test
    void changedScene_isTheSameOnAnyHosts() throws Exception {
        SavedState old = changed(Small.SCENE, SavedState.NONE, round -> { }).state();
        Scene scene = Edits.repainted(Edits.moved(Small.SCENE, Edits.surface(Small.SCENE, "block"),
                new Vec3(-0.05, 0, 0.25)), Edits.surface(Small.SCENE, "wall 4"), new Rgb(.2, .3, .6));
        int[] steps = {0};
        Solution local = changed(scene, old, round -> steps[0] = round);
        try (Server a = new Server(); Server b = new Server(); Server c = new Server()) {
            ColouredRoom.assertSame(local, changed(scene, old, round -> { }, a));
            ColouredRoom.assertSame(local, changed(scene, old, round -> { }, a, b, c));
            assertEquals(List.of(), notices);
            ColouredRoom.assertSame(local, changed(scene, old, round -> {
                if (round == steps[0] / 2) {
                    b.kill();
                }
            }, a, b, c));
            assertEquals(1, said("host localhost:" + b.port() + " lost .*"), notices::toString);
        }
    }

    @Test
    void stoppedHost_isTold_andGoesOn() throws Exception {
        assumeTrue(Files.isExecutable(Path.of("/bin/kill")) || Files.isExecutable(Path.of("/usr/bin/kill")),
                "needs the kill command");
        try (Server a = new Server(); Server b = new Server()) {
            Solution got = solve(Schedule.PAPER, round -> {
                if (round == 10) {
                    b.signal("STOP");
                    wakeLater(b, 8);
                }
            }, a, b);
            ColouredRoom.assertSame(Small.local(Schedule.PAPER), got);
            assertEquals(List.of("host localhost:" + b.port() + " silent for 3 s"), notices);
        }
    }

    @Test
    void hostThatStaysStopped_isLost() throws Exception {
        assumeTrue(Files.isExecutable(Path.of("/bin/kill")) || Files.isExecutable(Path.of("/usr/bin/kill")),
                "needs the kill command");
        try (Server a = new Server(); Server b = new Server()) {
            Solution got = solve(Schedule.PREDICT, round -> {
                if (round == 3) {
                    b.signal("STOP");
                }
            }, a, b);
            ColouredRoom.assertSame(Small.local(Schedule.PREDICT), got);
            assertEquals(1, said("host .* lost \\(silent for 10 s\\); its .*"), notices::toString);
        }
    }

    private static void wakeLater(Server server, int seconds) {
        Thread thread = new Thread(() -> {
            try {
                Thread.sleep(1000L * seconds);
                server.signal("CONT");
            } catch (IOException | InterruptedException e) {
                throw new IllegalStateException(e);
            }
        });
        thread.setDaemon(true);
        thread.start();
    }

    /** A line that comes where a phase takes longer than a moment. */
    private static boolean isProgress(String line) {
        return line.equals("setting up") || line.startsWith("reading ");
    }

    @Test
    void renderer_withoutAnyHost_ends4() throws Exception {
        Process process = Server.start("radiosity.cli.RadiosityRenderer", "-h", "1", "localhost:" + Small.freePort(),
                "scenes/cornell-box.lws", Files.createTempDirectory("radiosity").resolve("foobar.scene").toString());
        String said = new String(process.getInputStream().readAllBytes());
        assertEquals(4, process.waitFor(), said);
        assertTrue(said.contains("(is PartitionServer running there?); starting without it"), said);
        assertEquals(2, said.lines().filter(line -> !isProgress(line)).count(), said);
    }

    @Test
    void server_onATakenPort_ends1() throws Exception {
        try (Server a = new Server()) {
            Process second = Server.start("radiosity.cli.PartitionServer", "-port", "" + a.port());
            String said = new String(second.getInputStream().readAllBytes());
            assertEquals(1, second.waitFor(), said);
            assertEquals("-port: expected a port that is free or an rmiregistry's, got " + a.port()
                    + ", which is taken", said.strip());
        }
    }

    @Test
    void server_thatIsEnded_saysSo() throws Exception {
        try (Server server = new Server()) {
            server.signal("TERM");
            String rest = server.rest();
            assertTrue(rest.matches("\\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d:\\d\\d ended"), rest);
            assertEquals(143, server.exitCode());
        }
    }

    /** The same command goes on from the journal, and the hosts have noticed that their master is gone. */
    @Test
    void killedMaster_isResumed(@TempDir Path directory) throws Exception {
        Path output = directory.resolve("foobar.scene");
        Path journal = directory.resolve("foobar.scene.journal");
        String[] local = {"-it", "600", "-pa", "1500", "-nr", "60", "scenes/cornell-box.lws",
            directory.resolve("local.scene").toString()};
        String[] there = {"-h", "1", "", "-it", "600", "-pa", "1500", "-nr", "60", "scenes/cornell-box.lws",
            output.toString()};
        Process reference = Server.start("radiosity.cli.RadiosityRenderer", local);
        String said = new String(reference.getInputStream().readAllBytes());
        assertEquals(0, reference.waitFor(), said);
        try (Server host = new Server()) {
            there[2] = host.address();
            Process master = Server.start("radiosity.cli.RadiosityRenderer", there);
            while (master.isAlive() && !Files.exists(journal)) {
                Thread.sleep(20);
            }
            master.destroyForcibly().waitFor();
            assertTrue(Files.exists(journal), "cut off before its end");
            Process second = Server.start("radiosity.cli.RadiosityRenderer", there);
            String secondSaid = new String(second.getInputStream().readAllBytes());
            assertEquals(0, second.waitFor(), secondSaid);
            assertTrue(secondSaid.contains("foobar.scene.journal: going on after "), secondSaid);
        }
        assertFalse(Files.exists(journal));
        try (SceneFile expected = SceneFile.open(directory.resolve("local.scene"));
                SceneFile got = SceneFile.open(output)) {
            assertEquals(expected.state(), got.state());
        }
    }
}
