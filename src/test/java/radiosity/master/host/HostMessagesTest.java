package radiosity.master.host;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.IOException;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.protocol.BlockTakeover;
import radiosity.protocol.Reply;
import radiosity.rmi.RemotePartition;
import radiosity.testkit.TestLink;
import radiosity.util.Pieces;

/** What a host is sent arrives whole in parts, however much it is, and is counted. */
class HostMessagesTest {

    private static final int MOST_PART_BYTES = 1 << 20;

    /** Answers nothing to whatever is asked, and gives away the parts that it is sent. */
    private static Host host(Consumer<byte[]> sent) {
        byte[] reply = new Reply(new byte[0], 0, 0, List.of(), new byte[0]).encode();
        RemotePartition remote = (RemotePartition) Proxy.newProxyInstance(RemotePartition.class.getClassLoader(),
                new Class<?>[] {RemotePartition.class}, (proxy, method, arguments) -> {
                    if (method.getName().equals("send")) {
                        sent.accept((byte[]) arguments[1]);
                    }
                    return method.getName().equals("round") ? reply : new byte[0];
                });
        return new Host(new TestLink("igge", 1, round -> false), remote, 1, line -> { });
    }

    private static byte[] random(int length) {
        byte[] bytes = new byte[length];
        new Random(length).nextBytes(bytes);
        return bytes;
    }

    @Test
    void takeover_arrivesWholeInParts() throws IOException {
        Map<Integer, byte[]> states = new TreeMap<>(Map.of(3, random(5), 7, random(3 * MOST_PART_BYTES + 17), 8,
                BlockTakeover.INITIAL));
        List<byte[]> parts = new ArrayList<>();
        Host host = host(parts::add);
        assertEquals(List.of(), host.take(new BlockTakeover(states, List.of(random(100), random(2)), List.of(4))));
        assertTrue(parts.size() >= 4 && parts.size() <= 6, parts.size() + " parts");
        assertTrue(parts.stream().allMatch(part -> part.length > 0 && part.length <= MOST_PART_BYTES));
        BlockTakeover got = BlockTakeover.read(new DataInputStream(Pieces.open(parts)));
        assertEquals(states.keySet(), got.states().keySet());
        states.forEach((id, state) -> assertArrayEquals(state, got.states().get(id)));
        assertEquals(2, got.orders().size());
        assertArrayEquals(random(100), got.orders().get(0));
        assertEquals(List.of(4), got.leave());
        assertEquals(Pieces.length(parts), host.load.bytes.get());
    }

    /** More bytes than one array can hold; the states are one array, so that the test needs little memory. */
    @Test
    @Tag("slow")
    void takeoverOfMoreThanAnArrayHolds_isSent() throws IOException {
        byte[] state = new byte[64 << 20];
        Map<Integer, byte[]> states = new TreeMap<>();
        for (int id = 0; id < 33; id++) {
            states.put(id, state);
        }
        long[] sent = new long[1];
        host(part -> sent[0] += part.length).take(new BlockTakeover(states, List.of(), List.of()));
        assertTrue(sent[0] > 33L * state.length, sent[0] + " bytes");
        assertTrue(sent[0] > Integer.MAX_VALUE);
    }

    /** Several orders are under way to a host at once, each on a thread of its own. */
    @Test
    void bytesOfSeveralThreads_areAllCounted() throws Exception {
        int threads = 8;
        int rounds = 5000;
        Host host = host(part -> { });
        byte[] order = new byte[11];
        int each = order.length + new Reply(new byte[0], 0, 0, List.of(), new byte[0]).encode().length;
        ExecutorService executor = Executors.newFixedThreadPool(threads);
        try {
            List<Callable<Void>> calls = new ArrayList<>();
            for (int t = 0; t < threads; t++) {
                calls.add(() -> {
                    for (int i = 0; i < rounds; i++) {
                        host.round(i, order);
                    }
                    return null;
                });
            }
            for (Future<Void> call : executor.invokeAll(calls)) {
                call.get();
            }
        } finally {
            executor.shutdownNow();
        }
        assertEquals((long) threads * rounds * each, host.load.bytes.get());
    }
}
