package radiosity.master.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.solver.SameBitsTest.SCENE;
import static radiosity.solver.SameBitsTest.settings;
import static radiosity.solver.SameBitsTest.shots;
import static radiosity.solver.SameBitsTest.solve;
import static radiosity.testkit.ColouredRoom.assertSame;

import java.io.EOFException;
import java.io.IOException;
import java.io.InvalidClassException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.net.SocketException;
import java.rmi.AccessException;
import java.rmi.ConnectException;
import java.rmi.ConnectIOException;
import java.rmi.MarshalException;
import java.rmi.NoSuchObjectException;
import java.rmi.RemoteException;
import java.rmi.ServerError;
import java.rmi.ServerException;
import java.rmi.StubNotFoundException;
import java.rmi.UnexpectedException;
import java.rmi.UnknownHostException;
import java.rmi.UnmarshalException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import radiosity.master.RemoteWorld;
import radiosity.rmi.HostFailure;
import radiosity.rmi.RemotePartition;
import radiosity.rmi.SessionEndedException;
import radiosity.settings.Schedule;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.testkit.TestLink;
import radiosity.worker.ServedPartition;

/** Whatever a call to a host ends in: the user is notified once, on one line, in plain words. */
@Tag("slow")
class HostNoticesTest {

    private static final int SHOTS = 12;
    private static final List<String> BEFORE_BLOCKS = List.of("connect", "greet", "open", "send", "mesh");
    private static final List<String> WITH_BLOCKS = List.of("take", "round");

    private static final String REFUSED =
            "a message was refused for its size or kind: give both sides JAVA_OPTS=-Xmx with more";

    /** Time within which a host is sought again that may come back, ms. */
    private static final long SOUGHT_WITHIN = 2500;

    private static Solution local;

    private static Solution local() throws IOException {
        if (local == null) {
            local = solve(new LocalWorld(SCENE, settings(Schedule.PREDICT), 2), shots(SHOTS));
        }
        return local;
    }

    /** What RMI throws, with the messages that it makes, and the words for it. */
    static Stream<Arguments> errors() {
        return Stream.of(
                Arguments.of(new ConnectException("Connection refused to host: igge", new SocketException("refused")),
                        "no connection"),
                Arguments.of(new ConnectIOException("error during JRMP connection", new EOFException()),
                        "no connection"),
                Arguments.of(new UnknownHostException("Unknown host: igge", new java.net.UnknownHostException("igge")),
                        "no machine of this name"),
                Arguments.of(new UnmarshalException("Error unmarshaling return header", new EOFException()),
                        "connection closed"),
                Arguments.of(new UnmarshalException("error unmarshalling return", new InvalidClassException("filter")),
                        REFUSED),
                Arguments.of(new UnmarshalException("error unmarshalling return", new ClassNotFoundException("Evil")),
                        "no sound answer"),
                Arguments.of(new MarshalException("error marshalling arguments", new SocketException("Broken pipe")),
                        "connection closed"),
                Arguments.of(new NoSuchObjectException("no such object in table"), "it was started anew"),
                Arguments.of(new AccessException("disallowed", new SecurityException("no\nway")), "it refuses calls"),
                Arguments.of(new ServerError("Error occurred in server thread",
                        new OutOfMemoryError("Java heap space")),
                        "out of memory there: give it JAVA_OPTS=-Xmx with more"),
                Arguments.of(new ServerError("Error occurred in server thread", new StackOverflowError()),
                        "internal error there, StackOverflowError"),
                Arguments.of(new ServerException("RemoteException occurred in server thread",
                        new SessionEndedException()),
                        "the session has ended there"),
                Arguments.of(new ServerException("RemoteException occurred in server thread",
                        new UnmarshalException("error unmarshalling arguments", new InvalidClassException("filter"))),
                        REFUSED),
                Arguments.of(new SessionEndedException(), "the session has ended there"),
                Arguments.of(new StubNotFoundException("stub", new ClassNotFoundException("stub")), "no sound answer"),
                Arguments.of(new UnexpectedException("unexpected", new Exception("a\nb")), "no sound answer"),
                Arguments.of(new RemoteException("first\n\tsecond", new Exception("third")), "no sound answer"),
                Arguments.of(new IllegalStateException("round 7: \u001B[31mfailed\nand more"),
                        "internal error there, IllegalStateException: round 7:  [31mfailed"),
                Arguments.of(new NullPointerException(), "internal error there, NullPointerException"));
    }

    /** A host whose calls of one method end in an error, and that cannot be reached any more from then on. */
    private record Failing(String method, Exception error, ServedPartition behind, boolean[] failed) implements Link {

        @Override
        public String name() {
            return "igge";
        }

        @Override
        public RemotePartition connect() throws IOException {
            check("connect");
            return (RemotePartition) Proxy.newProxyInstance(Link.class.getClassLoader(),
                    new Class<?>[] {RemotePartition.class}, (proxy, called, arguments) -> {
                        check(called.getName());
                        try {
                            return called.invoke(behind, arguments);
                        } catch (InvocationTargetException e) {
                            throw e.getCause();
                        }
                    });
        }

        private void check(String called) throws IOException {
            failed[0] |= called.equals(method);
            if (!failed[0]) {
                return;
            }
            if (error instanceof RuntimeException unchecked) {
                throw unchecked;
            }
            throw (IOException) error;
        }

        @Override
        public void cut() { }
    }

    private static Failing failing(String method, Exception error) {
        return new Failing(method, error, new ServedPartition(1, line -> { }), new boolean[1]);
    }

    private static List<String> notices(Link bad) throws IOException {
        List<String> notices = new CopyOnWriteArrayList<>();
        try (RemoteWorld world = new RemoteWorld(SCENE, settings(Schedule.PREDICT), 1, notices::add,
                List.of(TestLink.sound(1, 1).get(0), bad), System::nanoTime)) {
            assertSame(local(), solve(world, shots(SHOTS)));
        }
        return notices;
    }

    @ParameterizedTest
    @MethodSource("errors")
    void hostThatCannotBeUsed_isOneLine(Exception error, String words) throws IOException {
        for (String method : BEFORE_BLOCKS) {
            assertEquals(List.of("host igge: " + words + "; starting without it"), notices(failing(method, error)),
                    method);
        }
    }

    @ParameterizedTest
    @MethodSource("errors")
    void hostThatIsLost_isOneLine(Exception error, String words) throws IOException {
        for (String method : WITH_BLOCKS) {
            List<String> notices = notices(failing(method, error));
            String expected = words;
            if (error instanceof ConnectIOException && method.equals("round")) {
                // a connection that cannot be made is tried again for longer than a host may be silent
                assertEquals("host igge silent for 3 s", notices.remove(0));
                expected = "silent for 10 s";
            }
            assertEquals(1, notices.size(), notices::toString);
            assertTrue(notices.get(0).startsWith("host igge lost (" + expected + "); it"), notices::toString);
            assertTrue(notices.get(0).matches(".*\\); (its \\d+ blocks? moves? to 1 host, rebuilt in \\d+\\.\\d s"
                    + "|it had no blocks)"), notices::toString);
        }
    }

    /** The same message would be refused again: the host would be lost and join without end. */
    @Test
    void hostThatRefusesAMessage_isNotSoughtAgain() throws Exception {
        InvalidClassException filter = new InvalidClassException("filter status: REJECTED");
        UnmarshalException refusal = new UnmarshalException("error unmarshalling arguments", filter);
        for (String method : List.of("send", "round")) {
            AtomicInteger connections = new AtomicInteger();
            Link bad = new Link() {
                @Override
                public String name() {
                    return "igge";
                }

                @Override
                public RemotePartition connect() throws IOException {
                    connections.incrementAndGet();
                    return failing(method, refusal).connect();
                }

                @Override
                public void cut() { }
            };
            List<String> notices = new CopyOnWriteArrayList<>();
            try (RemoteWorld world = new RemoteWorld(SCENE, settings(Schedule.PREDICT), 1, notices::add,
                    List.of(TestLink.sound(1, 1).get(0), bad), System::nanoTime)) {
                solve(world, shots(SHOTS));
                TimeUnit.MILLISECONDS.sleep(SOUGHT_WITHIN);
            }
            assertEquals(1, notices.size(), notices::toString);
            assertTrue(notices.get(0).contains(REFUSED), notices::toString);
            assertEquals(1, connections.get(), method);
        }
    }

    @Test
    void computationThatFailsEverywhere_endsInOneLine() {
        ServerError error = new ServerError("Error occurred in server thread", new StackOverflowError());
        List<String> notices = new CopyOnWriteArrayList<>();
        IOException end = assertThrows(IOException.class, () -> {
            try (RemoteWorld world = new RemoteWorld(SCENE, settings(Schedule.PREDICT), 1, notices::add,
                    List.of(failing("round", error), failing("round", error)), System::nanoTime)) {
                solve(world, shots(SHOTS));
            }
        });
        assertEquals("host igge: expected the round to be computed there or elsewhere, got internal error there, "
                + "StackOverflowError", end.getMessage());
    }

    @Test
    void memoryThatTheMasterLacks_isNoFailureOfTheHost() {
        assertThrows(OutOfMemoryError.class, () -> HostFailure.because(new OutOfMemoryError("Java heap space")));
    }

    /** Its heartbeat would keep the host from this master, and from every other. */
    @Test
    void hostThatCannotTakeTheScene_isFreeAgain() throws IOException {
        ServerError full = new ServerError("Error occurred in server thread", new OutOfMemoryError());
        List<String> said = new CopyOnWriteArrayList<>();
        ServedPartition behind = new ServedPartition(1, said::add);
        Link small = new Link() {
            @Override
            public String name() {
                return "igge";
            }

            @Override
            public RemotePartition connect() {
                return (RemotePartition) Proxy.newProxyInstance(Link.class.getClassLoader(),
                        new Class<?>[] {RemotePartition.class}, (proxy, called, arguments) -> {
                            if (called.getName().equals("mesh")) {
                                throw full;
                            }
                            return called.invoke(behind, arguments);
                        });
            }

            @Override
            public void cut() { }
        };
        notices(small);
        assertTrue(said.size() % 2 == 0 && said.get(1).endsWith(" has finished"), said::toString);
    }
}
