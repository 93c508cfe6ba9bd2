package radiosity.distributed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.rmi.Remote;
import java.rmi.registry.LocateRegistry;
import java.rmi.registry.Registry;
import java.rmi.server.ExportException;
import java.rmi.server.UnicastRemoteObject;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import radiosity.master.RemoteWorld;
import radiosity.master.host.NoWorkerException;
import radiosity.rmi.HostAddress;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.testkit.ColouredRoom;
import radiosity.worker.PartitionPort;

/** Remote calls over the loopback interface: the same bits, and one line for whatever is wrong. */
@Tag("slow")
class LoopbackTest {

    private final List<String> notices = new CopyOnWriteArrayList<>();

    @ParameterizedTest
    @EnumSource(Schedule.class)
    void overRmi_givesTheSameBitsAsLocal(Schedule schedule) throws IOException {
        Solution local = Small.local(schedule);
        try (PartitionPort a = Small.serve(null, 1); PartitionPort b = Small.serve(null, 2);
                PartitionPort c = Small.serve(null, 1)) {
            ColouredRoom.assertSame(local, Small.remote(schedule, null, notices::add, a));
            ColouredRoom.assertSame(local, Small.remote(schedule, null, notices::add, a, b, c));
        }
        assertEquals(List.of(), notices);
    }

    @Test
    void lampsKeptApart_areTheSameOverRmi() throws IOException {
        Scene scene = new Scene("two lamps", Small.SCENE.points(), Small.SCENE.corners(), Small.SCENE.surfaceOf(),
                Small.SCENE.surfaces(), List.of(new Light("second", Light.Kind.POINT, Rgb.grey(0.1),
                        new Vec3(0.3, 0.5, 0.3), new Vec3(0, -1, 0), Vec3.ZERO, Vec3.ZERO, 1, 0, 0)), Optional.empty());
        RadiositySettings layered = Small.settings(Schedule.PREDICT).layers(true);
        Solution local = Small.solve(new LocalWorld(scene, layered, 2));
        assertEquals(6, local.channels());
        try (PartitionPort a = Small.serve(null, 1); PartitionPort b = Small.serve(null, 2);
                RemoteWorld world = new RemoteWorld(scene, layered, List.of(new HostAddress("localhost", a.port()),
                        new HostAddress("localhost", b.port())), null, 1, notices::add)) {
            ColouredRoom.assertSame(local, Small.solve(world));
        }
    }

    @Test
    void unreachableHost_isDoneWithout() throws IOException {
        int nobody = Small.freePort();
        try (PartitionPort a = Small.serve(null, 1);
                RemoteWorld world = new RemoteWorld(Small.SCENE, Small.settings(Schedule.PAPER),
                        List.of(new HostAddress("localhost", nobody), new HostAddress("localhost", a.port())), null, 1,
                        notices::add)) {
            ColouredRoom.assertSame(Small.local(Schedule.PAPER), Small.solve(world));
        }
        assertEquals(List.of("host localhost:" + nobody + ": no answer on port " + nobody
                + " (is PartitionServer running there?); starting without it"), notices);
    }

    /** A firewall that knows of one port only closes the way behind an rmiregistry. */
    @Test
    void hostThatTheRegistryNamesInVain_isNamedWithBothPorts() throws Exception {
        int port = Small.freePort();
        Registry registry = LocateRegistry.createRegistry(port);
        try {
            PartitionPort gone = PartitionPort.open(
                    new PartitionPort.Options(port, Small.freePort(), null, null, 1), line -> { });
            Remote stub = registry.lookup(PartitionPort.NAME);
            gone.close();
            registry.rebind(PartitionPort.NAME, stub);
            assertThrows(NoWorkerException.class, () -> new RemoteWorld(Small.SCENE, Small.settings(Schedule.PAPER),
                    List.of(new HostAddress("localhost", port)), null, 1, notices::add));
            assertEquals(List.of("host localhost:" + port + ": no answer on port " + gone.port()
                    + ", which the registry on port " + port + " names; starting without it"), notices);
        } finally {
            UnicastRemoteObject.unexportObject(registry, true);
        }
    }

    @Test
    void noHost_isOneLineEach() throws IOException {
        List<HostAddress> hosts = List.of(new HostAddress("localhost", Small.freePort()),
                new HostAddress("no-such-host.invalid", 1099));
        assertThrows(NoWorkerException.class, () -> new RemoteWorld(Small.SCENE, Small.settings(Schedule.PAPER), hosts,
                null, 1, notices::add));
        assertEquals(2, notices.size());
        assertTrue(notices.contains("host no-such-host.invalid: no machine of this name; starting without it"),
                notices::toString);
    }

    @Test
    void secondMaster_isTurnedAway() throws IOException {
        try (PartitionPort a = Small.serve(null, 1);
                RemoteWorld first = new RemoteWorld(Small.SCENE, Small.settings(Schedule.PAPER),
                        List.of(new HostAddress("localhost", a.port())), null, 1, notices::add)) {
            assertThrows(NoWorkerException.class, () -> Small.remote(Schedule.PAPER, null, notices::add, a));
            assertTrue(notices.get(0)
                    .matches("host localhost:\\d+: busy for \\S+ since \\d\\d:\\d\\d; starting without it"),
                    notices::toString);
            ColouredRoom.assertSame(Small.local(Schedule.PAPER), Small.solve(first));
        }
    }

    @Test
    void hostWithTwoNames_isUsedOnce_andNamed() throws IOException {
        try (PartitionPort a = Small.serve(null, 1);
                RemoteWorld world = new RemoteWorld(Small.SCENE, Small.settings(Schedule.PAPER),
                        List.of(new HostAddress("localhost", a.port()), new HostAddress("127.0.0.1", a.port())), null,
                        1, notices::add)) {
            ColouredRoom.assertSame(Small.local(Schedule.PAPER), Small.solve(world));
        }
        String name = "(localhost|127.0.0.1):\\d+";
        assertEquals(1, notices.size(), notices::toString);
        assertTrue(notices.get(0).matches("host " + name + " is " + name + ", which is used already"),
                notices::toString);
    }

    @Test
    void hostServes_anyNumberOfRenders() throws IOException {
        Solution local = Small.local(Schedule.PREDICT);
        try (PartitionPort a = Small.serve(null, 1)) {
            for (int i = 0; i < 3; i++) {
                ColouredRoom.assertSame(local, Small.remote(Schedule.PREDICT, null, notices::add, a));
            }
        }
    }

    /** Appendix C.3 starts an rmiregistry first. */
    @Test
    void runningRegistry_isUsed() throws IOException {
        int port = Small.freePort();
        Registry registry = LocateRegistry.createRegistry(port);
        try (PartitionPort a = PartitionPort.open(new PartitionPort.Options(port, 0, null, null, 1), line -> { });
                RemoteWorld world = new RemoteWorld(Small.SCENE, Small.settings(Schedule.PAPER),
                        List.of(new HostAddress("localhost", port)), null, 1, notices::add)) {
            assertNotEquals(port, a.port());
            ColouredRoom.assertSame(Small.local(Schedule.PAPER), Small.solve(world));
        } finally {
            UnicastRemoteObject.unexportObject(registry, true);
        }
    }

    @Test
    void takenPort_isRefused() throws IOException {
        try (PartitionPort a = Small.serve(null, 1)) {
            assertThrows(ExportException.class, () -> PartitionPort.open(
                    new PartitionPort.Options(a.port(), 0, null, null, 1), line -> { }));
        }
    }

    /** A name for others, behind a router that translates addresses, need not lead back to the machine itself. */
    @Test
    void takenPort_isRefused_whereTheNameOfItsServerLeadsElsewhere() throws IOException {
        String property = "java.rmi.server.hostname";
        String before = System.getProperty(property);
        System.setProperty(property, "no-such-host.invalid");
        int port = Small.freePort();
        Registry registry = LocateRegistry.createRegistry(port);
        try (PartitionPort own = Small.serve(null, 1); PartitionPort behind = behind(port)) {
            assertNotEquals(port, behind.port());
            for (int taken : List.of(own.port(), port)) {
                assertThrows(ExportException.class, () -> behind(taken).close());
            }
        } finally {
            UnicastRemoteObject.unexportObject(registry, true);
            if (before == null) {
                System.clearProperty(property);
            } else {
                System.setProperty(property, before);
            }
        }
    }

    private static PartitionPort behind(int registry) throws IOException {
        return PartitionPort.open(new PartitionPort.Options(registry, 0, null, null, 1), line -> { });
    }

    @Test
    void addresses_areReadAsTyped() {
        assertEquals(new HostAddress("igge", 1099), HostAddress.parse("igge"));
        assertEquals(new HostAddress("igge", 4000), HostAddress.parse("igge:4000"));
        assertEquals(new HostAddress("fe80::1", 1099), HostAddress.parse("fe80::1"));
        assertEquals(new HostAddress("fe80::1", 4000), HostAddress.parse("[fe80::1]:4000"));
        for (String same : List.of("igge", "igge:4000", "fe80::1", "[fe80::1]:4000")) {
            assertEquals(same, HostAddress.parse(same).toString());
        }
        List<String> refused = new ArrayList<>();
        for (String wrong : List.of("", "igge:", "igge:0", "igge:70000", ":4000")) {
            refused.add(assertThrows(IllegalArgumentException.class, () -> HostAddress.parse(wrong)).getMessage());
        }
        assertEquals(5, refused.stream().filter(line -> line.startsWith("expected host or host:port")).count());
    }
}
