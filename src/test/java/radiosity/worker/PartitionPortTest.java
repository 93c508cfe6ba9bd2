package radiosity.worker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.lang.reflect.Proxy;
import java.rmi.NoSuchObjectException;
import java.rmi.RemoteException;
import java.rmi.registry.Registry;
import java.rmi.server.UnicastRemoteObject;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import radiosity.protocol.Greeting;

/** What fails on a host leaves nothing behind, and keeps no later master out. */
class PartitionPortTest {

    private static final Consumer<String> BROKEN = line -> {
        throw new IllegalStateException("closed log");
    };

    @Test
    void partitionThatCannotBeBound_isNotExported() {
        RemoteException refused = new RemoteException("full");
        Registry registry = (Registry) Proxy.newProxyInstance(Registry.class.getClassLoader(),
                new Class<?>[] {Registry.class}, (proxy, method, arguments) -> {
                    throw refused;
                });
        ServedPartition served = new ServedPartition(1, line -> { });
        assertSame(refused, assertThrows(RemoteException.class,
                () -> PartitionPort.export(served, registry, false, 0, line -> { })));
        assertThrows(NoSuchObjectException.class, () -> UnicastRemoteObject.unexportObject(served, true));
    }

    @Test
    void lookThatFails_isLogged_andEndsNoLaterLook() {
        List<String> lines = new ArrayList<>();
        Runnable failing = () -> {
            throw new IllegalStateException("broken");
        };
        PartitionPort.once(failing, lines::add);
        PartitionPort.once(failing, BROKEN);
        assertEquals(List.of("look after masters and registry: expected no error, got "
                + "java.lang.IllegalStateException: broken"), lines);
    }

    @Test
    void lackOfMemory_isLogged_andTold() {
        List<String> lines = new ArrayList<>();
        ServedPartition host = new ServedPartition(1, lines::add);
        host.open(7, new byte[] {'a'});
        OutOfMemoryError full = new OutOfMemoryError("Java heap space");
        assertSame(full, assertThrows(OutOfMemoryError.class, () -> host.inSession(7, session -> {
            throw full;
        })));
        assertEquals(List.of("working for a", "out of memory: give it JAVA_OPTS=-Xmx with more"), lines);
    }

    @Test
    void masterWhoseEndCannotBeLogged_isGoneNevertheless() throws Exception {
        long[] now = {0};
        boolean[] broken = {false};
        ServedPartition host = new ServedPartition(1, line -> {
            if (broken[0]) {
                BROKEN.accept(line);
            }
        }, () -> now[0]);
        host.open(7, new byte[0]);
        broken[0] = true;
        now[0] = (ServedPartition.LEASE_SECONDS + 1) * 1_000_000_000L;
        assertThrows(IllegalStateException.class, host::expire);
        assertEquals("", Greeting.decode(host.greet()).busy());
    }
}
