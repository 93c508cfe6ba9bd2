package radiosity.master;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import radiosity.master.HaloExchange.Source;
import radiosity.master.host.Host;
import radiosity.partition.Seam;
import radiosity.protocol.Order;
import radiosity.protocol.Reply;
import radiosity.protocol.Wire;
import radiosity.util.ParallelFor;

/** What the master answers itself: for patches between hosts, see {@link Seam}. */
final class Seams {

    private final ParallelFor crew;
    private int agreement;
    private Map<Host, SeamPatches> patches = Map.of();

    Seams(int threads) {
        crew = new ParallelFor(threads);
    }

    /** @param left what each host leaves to the master */
    void agree(int number, Map<Host, SeamPatches> left) {
        agreement = number;
        patches = left;
        Map<Long, Source> gathering = new HashMap<>();
        left.forEach((host, some) -> some.addTo(gathering, host));
        left.values().forEach(some -> some.find(gathering));
    }

    /**
     * What is to be added to answers of hosts.
     *
     * @param replies of hosts that were not lost
     */
    Map<Host, byte[]> answers(Order order, Map<Host, Reply> replies) {
        Map<Host, byte[]> said = new LinkedHashMap<>();
        if (!order.changes() && order.kind() != Order.Kind.ASK) {
            return said;
        }
        replies.forEach((host, reply) -> {
            if (patches.containsKey(host) && patches.get(host).isOf(agreement, reply.given())) {
                said.put(host, reply.given());
            }
        });
        List<Host> hosts = List.copyOf(said.keySet());
        byte[][] answers = new byte[hosts.size()][];
        crew.run(answers.length, i -> answers[i] = Wire.bytes(patches.get(hosts.get(i)).answer(order, said)::write));
        Map<Host, byte[]> byHost = new LinkedHashMap<>();
        hosts.forEach(host -> byHost.put(host, answers[byHost.size()]));
        return byHost;
    }
}
