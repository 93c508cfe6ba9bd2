package radiosity.master.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Proxy;
import java.rmi.ConnectException;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.protocol.Greeting;
import radiosity.protocol.Reply;
import radiosity.rmi.Build;
import radiosity.rmi.RemotePartition;

/** How sessions end, and what is said of hosts that have done nothing or cannot measure it. */
class HostEndsTest {

    /** A host whose answers the test gives. */
    private interface Answers {
        Object to(String method) throws Exception;
    }

    private static RemotePartition remote(Answers answers) {
        return (RemotePartition) Proxy.newProxyInstance(RemotePartition.class.getClassLoader(),
                new Class<?>[] {RemotePartition.class}, (proxy, method, arguments) -> answers.to(method.getName()));
    }

    private static Link link(RemotePartition remote, Runnable cut) {
        return new Link() {
            @Override
            public String name() {
                return "igge";
            }

            @Override
            public RemotePartition connect() {
                return remote;
            }

            @Override
            public void cut() {
                cut.run();
            }
        };
    }

    /** Its heartbeat would keep it busy. The call that opens the session notices no interrupt, and returns late. */
    @Test
    @Tag("slow")
    void sessionThatOpensTooLate_isClosed() throws InterruptedException {
        CountDownLatch cut = new CountDownLatch(1);
        CountDownLatch closed = new CountDownLatch(1);
        RemotePartition late = remote(method -> {
            switch (method) {
                case "greet":
                    return new Greeting(Build.version(), Build.id(), 1, cut.getCount() > 0 ? "" : "busy", 1)
                            .encode();
                case "open":
                    while (cut.getCount() > 0) {
                        Thread.onSpinWait();
                    }
                    Thread.interrupted();
                    return null;
                case "close":
                    closed.countDown();
                    return null;
                default:
                    return null;
            }
        });
        try (HostFinder finder = new HostFinder(new byte[0], "", line -> { })) {
            finder.lookFor(link(late, cut::countDown));
            finder.open(List.of());
            assertTrue(closed.await(20, TimeUnit.SECONDS));
            assertFalse(finder.hasCome());
        }
    }

    /** A host that opens a session as soon as it may, and counts the sessions that are closed. */
    private static Link willing(CountDownLatch free, CountDownLatch closed) {
        return link(remote(method -> {
            free.await();
            switch (method) {
                case "greet":
                    return new Greeting(Build.version(), Build.id(), 1, "", 1).encode();
                case "mesh":
                    return new byte[0];
                case "close":
                    closed.countDown();
                    return null;
                default:
                    return null;
            }
        }), () -> { });
    }

    @Test
    void hostsBesideOneWhoseFailureCannotBeTold_areClosed() throws InterruptedException {
        CountDownLatch closed = new CountDownLatch(1);
        RemotePartition gone = remote(method -> {
            throw new ConnectException("gone");
        });
        try (HostFinder finder = new HostFinder(new byte[0], "", line -> {
            throw new IllegalStateException("no terminal");
        })) {
            List<Link> links = List.of(willing(new CountDownLatch(0), closed), link(gone, () -> { }));
            assertThrows(IllegalStateException.class, () -> finder.open(links));
            assertTrue(closed.await(20, TimeUnit.SECONDS));
        }
    }

    @Test
    void interruptAtTheStart_isKept_andSessionsThatOpenLaterAreClosed() throws InterruptedException {
        CountDownLatch free = new CountDownLatch(1);
        CountDownLatch closed = new CountDownLatch(1);
        try (HostFinder finder = new HostFinder(new byte[0], "", line -> { })) {
            Thread.currentThread().interrupt();
            assertThrows(IllegalStateException.class, () -> finder.open(List.of(willing(free, closed))));
            assertTrue(Thread.interrupted());
            free.countDown();
            assertTrue(closed.await(20, TimeUnit.SECONDS));
        }
    }

    @Test
    void hostThatCannotBeClosed_interruptsNobody() {
        RemotePartition gone = remote(method -> {
            throw new ConnectException("gone");
        });
        Link stuck = link(gone, () -> {
            throw new IllegalStateException("no socket to cut");
        });
        HostCalls.close(List.of(new Host(stuck, gone, 1, line -> { })));
        assertFalse(Thread.interrupted());
    }

    @Test
    void hostThatCannotMeasureProcessorTime_isNotIdle() {
        HostLoad load = new HostLoad();
        load.add(new Reply(new byte[0], 0, 1, List.of(), new byte[0]), 0);
        assertEquals(0, load.statistics("igge", "working", 1, 0).idle());
    }
}
