package radiosity.distributed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import radiosity.master.RemoteWorld;
import radiosity.rmi.HostAddress;
import radiosity.settings.Schedule;
import radiosity.solution.Solution;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.testkit.ColouredRoom;

/**
 * Hosts in network namespaces of their own, on one switch: a pulled cable and a network that drops silently, which
 * neither end is told of.
 */
@Tag("slow")
@Timeout(120)
class NetworkTest {

    private static final int PORT = 1099;

    private final List<String> notices = new CopyOnWriteArrayList<>();
    private TestNetwork network;

    @BeforeEach
    void makeNetwork() throws IOException {
        assumeTrue(TestNetwork.isPossible(), "this machine allows no network namespaces (ip netns, as root)");
        network = new TestNetwork(2);
    }

    @AfterEach
    void removeNetwork() {
        if (network != null) {
            network.close();
        }
    }

    /** What happens to the network after the second round. */
    private interface Event {
        void happen() throws IOException;
    }

    @SuppressWarnings("try") // servers are there to be reached by the network
    private Solution solve(Event event) throws IOException {
        try (Server a = new Server(network.inside(0), PORT); Server b = new Server(network.inside(1), PORT);
                RemoteWorld world = new RemoteWorld(Small.SCENE, Small.settings(Schedule.PREDICT), addresses(), null, 1,
                        notices::add)) {
            ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, Small.STOP);
            int[] round = {0};
            rounds.run(progress -> {
                if (++round[0] == 2) {
                    happen(event);
                }
                return true;
            });
            return rounds.solution();
        }
    }

    private List<HostAddress> addresses() {
        List<HostAddress> addresses = new ArrayList<>();
        for (int host = 0; host < 2; host++) {
            addresses.add(new HostAddress(network.address(host), PORT));
        }
        return addresses;
    }

    private static void happen(Event event) {
        try {
            event.happen();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private void assertLost(String host) {
        assertEquals(1, notices.stream().filter(("host " + host + " silent for 3 s")::equals).count(),
                notices::toString);
        assertEquals(1, notices.stream()
                .filter(line -> line.startsWith("host " + host + " lost (silent for 10 s); its "))
                .count(), notices::toString);
    }

    @Test
    void pulledCable_losesNothing() throws Exception {
        Solution got = solve(() -> network.pull(1));
        ColouredRoom.assertSame(Small.local(Schedule.PREDICT), got);
        assertLost(network.address(1));
    }

    @Test
    void silentDrop_losesNothing() throws Exception {
        Solution got = solve(() -> network.drop(0));
        ColouredRoom.assertSame(Small.local(Schedule.PREDICT), got);
        assertLost(network.address(0));
    }
}
