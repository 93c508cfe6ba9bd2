package radiosity.master;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static radiosity.solver.SameBitsTest.SCENE;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.master.host.Link;
import radiosity.protocol.Order;
import radiosity.rmi.RemotePartition;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Certificate;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;
import radiosity.solver.SameBitsTest;
import radiosity.solver.World;
import radiosity.testkit.TestLink;

/** Hosts gather the light for an estimate of the error; the estimate has the same bits as that of one process. */
class EstimateOnHostsTest {

    private static final RadiositySettings SETTINGS = SameBitsTest.settings(Schedule.PREDICT).accurate(.05);
    private static Certificate local;

    private final List<String> notices = new CopyOnWriteArrayList<>();

    /** A host that counts the orders to gather for an estimate, and dies after the one with a number. */
    private static final class Gathering {
        final AtomicInteger orders = new AtomicInteger();
        final TestLink link;

        Gathering(String name, int last) {
            link = new TestLink(name, 1, round -> orders.get() == last);
            RemotePartition behind = link.behind;
            link.behind = (RemotePartition) Proxy.newProxyInstance(getClass().getClassLoader(),
                    new Class<?>[] {RemotePartition.class}, (proxy, method, arguments) -> {
                        if (method.getName().equals("round")
                                && ((byte[][]) arguments[2])[0][0] == Order.Kind.GATHER_AT.ordinal()) {
                            orders.incrementAndGet();
                        }
                        try {
                            return method.invoke(behind, arguments);
                        } catch (InvocationTargetException e) {
                            throw e.getCause();
                        }
                    });
        }
    }

    @BeforeAll
    static void estimateAlone() throws IOException {
        local = certificate(new LocalWorld(SCENE, SETTINGS, 2));
    }

    private static Certificate certificate(World world) throws IOException {
        StopRule stop = new StopRule(1_000_000, StopRule.DEFAULT_UNSENT);
        ProgressiveRadiosity radiosity = new ProgressiveRadiosity(world, stop);
        radiosity.run(progress -> true);
        return radiosity.certificate(1).orElseThrow();
    }

    private Certificate remote(List<Gathering> hosts) throws IOException {
        List<Link> links = new ArrayList<>();
        hosts.forEach(host -> links.add(host.link));
        try (RemoteWorld world = new RemoteWorld(SCENE, SETTINGS, 1, notices::add, links, System::nanoTime)) {
            return certificate(world);
        }
    }

    @Test
    void threeHosts_gatherTheLight() throws IOException {
        List<Gathering> hosts = List.of(new Gathering("andreas", -1), new Gathering("daniel", -1),
                new Gathering("igge", -1));
        assertEquals(local, remote(hosts));
        hosts.forEach(host -> assertTrue(host.orders.get() >= 2, "orders: " + host.orders));
        assertEquals(List.of(), notices);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void hostThatDiesInAnEstimate_changesNothing(int order) throws IOException {
        assertEquals(local, remote(List.of(new Gathering("andreas", -1), new Gathering("igge", order))));
        assertTrue(notices.stream().anyMatch(line -> line.startsWith("host igge lost")), notices::toString);
    }

    @Test
    void withoutHosts_theMasterGathers() throws IOException {
        assertEquals(local, remote(List.of(new Gathering("daniel", 1), new Gathering("igge", 1))));
        assertEquals(2, notices.stream().filter(line -> line.contains("lost")).count(), notices::toString);
    }
}
