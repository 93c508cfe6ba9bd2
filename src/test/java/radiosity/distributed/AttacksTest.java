package radiosity.distributed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InvalidClassException;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.registry.LocateRegistry;
import java.rmi.registry.Registry;
import java.rmi.server.RemoteObjectInvocationHandler;
import java.rmi.server.UnicastRemoteObject;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.master.RemoteWorld;
import radiosity.master.host.NoWorkerException;
import radiosity.rmi.HostAddress;
import radiosity.rmi.RemotePartition;
import radiosity.rmi.SessionEndedException;
import radiosity.settings.Schedule;
import radiosity.util.Pieces;
import radiosity.worker.PartitionPort;

/**
 * What a stranger may send to a host, and a false host to its master: nothing is made of it, and honest calls go on.
 */
class AttacksTest {

    private static final int MOST_PIECE = 1 << 20;

    private static PartitionPort host;
    private static RawCall caller;

    @BeforeAll
    static void serve() throws Exception {
        host = Small.serve(null, 1);
        caller = new RawCall(host.port());
    }

    @AfterAll
    static void stop() throws IOException {
        host.close();
    }

    @BeforeEach
    void forget() {
        Gadget.MADE.set(0);
    }

    private static void assertServes() throws RemoteException {
        assertTrue(caller.honest().greet().length > 0);
        assertEquals(0, Gadget.MADE.get());
    }

    static Stream<Object> objects() throws Exception {
        Object[] deep = {1};
        for (int i = 0; i < 100; i++) {
            deep = new Object[] {deep};
        }
        Remote stub = LocateRegistry.getRegistry("localhost", host.port()).lookup("Partition");
        return Stream.of(new Gadget(), new ArrayList<>(List.of(new Gadget())), new HashMap<>(Map.of("k", new Gadget())),
                deep, 4711, new int[] {1}, new byte[][][] {{{1}}}, Thread.State.NEW, String.class,
                new Exception("no bytes"), stub,
                Proxy.newProxyInstance(Gadget.class.getClassLoader(), new Class<?>[] {Comparable.class},
                        (InvocationHandler) stub));
    }

    @ParameterizedTest
    @MethodSource("objects")
    void objectInsteadOfBytes_isRefusedBeforeItIsMade(Object object) throws Exception {
        RemoteException refused = assertThrows(RemoteException.class, () -> caller.send(object));
        assertTrue(refused.getCause().getCause() instanceof InvalidClassException, refused::toString);
        assertServes();
    }

    /** Text is made by the JDK itself, without asking filters; it goes no further. */
    @Test
    void textInsteadOfBytes_isRefused() throws Exception {
        assertThrows(IllegalArgumentException.class, () -> caller.send("text"));
        assertServes();
    }

    @Test
    void foreignObject_isNotBoundInTheRegistry() throws Exception {
        Registry registry = LocateRegistry.getRegistry("localhost", host.port());
        assertThrows(RemoteException.class, () -> registry.rebind("other", new Gadget()));
        assertServes();
    }

    @Test
    void wrongSession_isRefused() throws Exception {
        RemotePartition honest = caller.honest();
        assertThrows(RemoteException.class, () -> honest.round(1, 1, new byte[1][0]));
        assertThrows(RemoteException.class, () -> honest.send(1, new byte[1]));
        assertThrows(RemoteException.class, () -> honest.blocks(1, new byte[4]));
        assertServes();
    }

    /** Memory for an array is allocated before its bytes come, and a caller need not send them. */
    @Test
    void largeArray_isRefusedBeforeItsBytesCome() throws Exception {
        byte[] large = new byte[MOST_PIECE + 1];
        RemotePartition honest = caller.honest();
        for (Executable call : List.<Executable>of(() -> honest.send(1, large),
                () -> honest.round(1, 1, new byte[][] {{1}, large}))) {
            RemoteException refused = assertThrows(RemoteException.class, call);
            assertFalse(refused.getCause() instanceof SessionEndedException, refused::toString);
        }
        assertServes();
    }

    /** An order of many megabytes: what has come of it is all that a host has memory for. */
    @Test
    void largeOrderInPieces_isNotRefusedForItsSize() throws Exception {
        RemotePartition honest = caller.honest();
        RemoteException refused = assertThrows(RemoteException.class,
                () -> honest.round(1, 1, Pieces.cut(new byte[9 * MOST_PIECE + 1], MOST_PIECE)));
        assertTrue(refused.getCause() instanceof SessionEndedException, refused::toString);
    }

    /** Counts that promise more than comes: nothing is allocated for them. */
    @ParameterizedTest
    @ValueSource(ints = {0, 3, 17, 40, 41})
    void scenesWithWrongCounts_areRefused(int bytes) throws Exception {
        RemotePartition honest = caller.honest();
        honest.open(7, "attacker".getBytes(StandardCharsets.UTF_8));
        try {
            byte[] message = new byte[bytes + 4];
            java.util.Arrays.fill(message, bytes, bytes + 4, (byte) 0x7F);
            honest.send(7, message);
            assertThrows(Exception.class, () -> honest.mesh(7));
            assertThrows(Exception.class, () -> honest.round(7, 1, new byte[][] {message}));
        } finally {
            honest.close(7);
        }
        assertServes();
    }

    @Test
    void garbageAndSilence_keepNobodyWaiting() throws Exception {
        List<Socket> idle = new ArrayList<>();
        for (int i = 0; i < 50; i++) {
            Socket socket = new Socket("localhost", host.port());
            idle.add(socket);
            if (i % 2 == 0) {
                DataOutputStream out = new DataOutputStream(socket.getOutputStream());
                out.write(new byte[] {'J', 'R', 'M', 'I', 0, 2, 0x4B, (byte) i, 1, 2, 3, 4, 5});
                out.flush();
            }
        }
        assertServes();
        for (Socket socket : idle) {
            socket.close();
        }
        assertServes();
    }

    @Test
    void otherProtocols_areNotServed() throws Exception {
        try (Socket socket = new Socket("localhost", host.port())) {
            socket.getOutputStream().write("GET / HTTP/1.1\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
            socket.setSoTimeout(5000);
            byte[] answer = socket.getInputStream().readNBytes(5);
            assertTrue(!new String(answer, StandardCharsets.US_ASCII).startsWith("HTTP"));
        }
        assertServes();
    }

    /** Where a registry hands out something else than a stub. */
    @Test
    void falseRegistry_makesNothingInTheMaster() throws Exception {
        int port = Small.freePort();
        Registry registry = LocateRegistry.createRegistry(port);
        try {
            registry.rebind("Partition", new Gadget());
            assertNobodyIsUsed(port);
        } finally {
            UnicastRemoteObject.unexportObject(registry, true);
        }
        assertEquals(0, Gadget.MADE.get());
    }

    /** Where a host answers with an error that carries an object. */
    @Test
    void falseHost_makesNothingInTheMaster() throws Exception {
        int port = Small.freePort();
        Registry registry = LocateRegistry.createRegistry(port);
        RemotePartition evil = (RemotePartition) Proxy.newProxyInstance(RemotePartition.class.getClassLoader(),
                new Class<?>[] {RemotePartition.class}, (proxy, method, arguments) -> answer(proxy, method.getName()));
        Remote stub = UnicastRemoteObject.exportObject(evil, port);
        try {
            registry.rebind("Partition", (RemoteObjectInvocationHandler) Proxy.getInvocationHandler(stub));
            assertNobodyIsUsed(port);
        } finally {
            UnicastRemoteObject.unexportObject(evil, true);
            UnicastRemoteObject.unexportObject(registry, true);
        }
        assertEquals(0, Gadget.MADE.get());
    }

    private static Object answer(Object proxy, String method) {
        return switch (method) {
            case "hashCode" -> System.identityHashCode(proxy);
            case "equals" -> false;
            case "toString" -> "a false host";
            default -> throw new IllegalStateException("with a gift", new Gadget());
        };
    }

    private static void assertNobodyIsUsed(int port) {
        List<String> notices = new CopyOnWriteArrayList<>();
        assertThrows(NoWorkerException.class, () -> new RemoteWorld(Small.SCENE, Small.settings(Schedule.PAPER),
                List.of(new HostAddress("localhost", port)), null, 1, notices::add));
        assertEquals(1, notices.size());
    }
}
