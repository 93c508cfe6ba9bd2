package radiosity.distributed;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.AccessException;
import java.rmi.NotBoundException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.registry.LocateRegistry;
import java.rmi.registry.Registry;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.function.Executable;
import radiosity.settings.Schedule;
import radiosity.testkit.ColouredRoom;
import radiosity.worker.PartitionPort;

/** A name that masters look for stays bound, whatever other processes of the machine ask the registry to do. */
@Tag("slow")
@Timeout(60)
class RegistryTest {

    private static final String NAME = "Partition";

    private final List<String> notices = new CopyOnWriteArrayList<>();

    private static Registry registryOf(PartitionPort host) throws RemoteException {
        return LocateRegistry.getRegistry("localhost", host.port());
    }

    private static void assertRefused(Executable call) {
        RemoteException refused = assertThrows(RemoteException.class, call);
        assertInstanceOf(AccessException.class, refused.getCause(), refused::toString);
    }

    private void assertServes(PartitionPort host) throws IOException {
        ColouredRoom.assertSame(Small.local(Schedule.PAPER), Small.remote(Schedule.PAPER, null, notices::add, host));
        assertEquals(List.of(), notices);
    }

    @Test
    void unbind_isRefusedByTheWorkersOwnRegistry() throws Exception {
        try (PartitionPort host = Small.serve(null, 1)) {
            Registry registry = registryOf(host);
            assertRefused(() -> registry.unbind(NAME));
            assertServes(host);
        }
    }

    @Test
    void bindAndRebind_areRefusedByTheWorkersOwnRegistry() throws Exception {
        try (PartitionPort host = Small.serve(null, 1)) {
            Registry registry = registryOf(host);
            Remote stub = registry.lookup(NAME);
            assertRefused(() -> registry.bind("other", stub));
            assertRefused(() -> registry.rebind("other", stub));
            assertRefused(() -> registry.rebind(NAME, stub));
            assertArrayEquals(new String[] {NAME}, registry.list());
            assertServes(host);
        }
    }

    /** A process of its own, which needs nothing of this one. */
    @Test
    void unbindByAnotherProcess_isRefused() throws Exception {
        try (Server server = new Server()) {
            Registry registry = LocateRegistry.getRegistry("localhost", server.port());
            assertRefused(() -> registry.unbind(NAME));
            assertRefused(() -> registry.rebind(NAME, registry.lookup(NAME)));
            assertArrayEquals(new String[] {NAME}, registry.list());
        }
    }

    /** Appendix C.3 starts an rmiregistry first, which obeys every process of the machine. */
    @Test
    void nameUnboundInAnRmiregistry_isBoundAgain() throws Exception {
        int port = Small.freePort();
        Process rmiregistry = rmiregistry(port);
        List<String> log = new CopyOnWriteArrayList<>();
        try (PartitionPort host = PartitionPort.open(new PartitionPort.Options(port, 0, null, null, 1), log::add)) {
            Registry registry = LocateRegistry.getRegistry("localhost", port);
            registry.unbind(NAME);
            awaitName(registry);
            awaitLine(log, 1, "the registry had lost the name Partition, which is bound again");
            rmiregistry.destroyForcibly().waitFor();
            awaitLine(log, 2, "the registry does not answer: masters cannot find this PartitionServer");
            rmiregistry = rmiregistry(port);
            awaitName(registry);
            awaitLine(log, 3, "the registry had lost the name Partition, which is bound again");
        } finally {
            rmiregistry.destroyForcibly().waitFor();
        }
    }

    private static Process rmiregistry(int port) throws Exception {
        Path program = Path.of(System.getProperty("java.home"), "bin", "rmiregistry");
        assumeTrue(Files.isExecutable(program), "needs the JDK's rmiregistry, got a JRE");
        Process process = new ProcessBuilder(program.toString(), "" + port).redirectErrorStream(true).start();
        while (process.isAlive() && !isListening(port)) {
            Thread.sleep(50);
        }
        assertTrue(process.isAlive());
        return process;
    }

    private static boolean isListening(int port) {
        try (Socket socket = new Socket("localhost", port)) {
            return socket.isConnected();
        } catch (IOException e) {
            return false;
        }
    }

    private static void awaitName(Registry registry) throws Exception {
        while (true) {
            try {
                registry.lookup(NAME);
                return;
            } catch (NotBoundException e) {
                Thread.sleep(50);
            }
        }
    }

    /** A name is bound before the line that says so is written. */
    private static void awaitLine(List<String> log, int lines, String last) throws InterruptedException {
        while (log.size() < lines) {
            Thread.sleep(50);
        }
        assertEquals(lines, log.size(), log::toString);
        assertEquals(last, log.get(lines - 1));
    }
}
