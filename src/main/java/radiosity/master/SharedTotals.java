package radiosity.master;

import java.util.List;
import radiosity.master.host.Host;
import radiosity.master.host.HostCalls;
import radiosity.prediction.ShotsOnDemand;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.protocol.Wire;
import radiosity.setup.InitialMesh;
import radiosity.util.ParallelFor;
import radiosity.worker.ShotHistory;

/** What was shot so far as the master has it, and which hosts have it too; only prediction has use for it. */
final class SharedTotals {

    private final InitialMesh mesh;
    private final HostCalls calls;
    private final ShotHistory totals;

    SharedTotals(InitialMesh mesh, HostCalls calls) {
        this.mesh = mesh;
        this.calls = calls;
        totals = new ShotHistory(mesh.faces.channels());
    }

    /** A host that begins now knows everything if nobody has shot. */
    void welcome(Host host) {
        host.knows = totals.isEmpty();
    }

    /** Hosts that were told this order have counted it themselves. */
    void count(Order order) {
        if (mesh.predicts() && order.marks()) {
            totals.add(order.shots());
        }
    }

    /** Instead of what was counted. @param now what all have shot */
    void set(List<Shot> now, List<Host> hosts) {
        totals.set(now);
        hosts.forEach(host -> host.knows = false);
    }

    /** Tells hosts that have come later what was shot before. */
    void tell(List<Host> hosts) {
        List<Host> late = hosts.stream().filter(host -> !host.knows).toList();
        if (!late.isEmpty()) {
            byte[] all = Wire.bytes(out -> Wire.write(totals.all(), mesh.faces.channels(), out));
            calls.onAll(late, host -> host.know(all)).keySet().forEach(host -> host.knows = true);
        }
    }

    /**
     * To be used before anybody shoots again.
     *
     * @param trees of all that shoots together: how they are divided
     */
    List<Shot> of(List<Shot> trees, ParallelFor crew) {
        return new ShotsOnDemand(trees.size(), i -> totals.of(trees.get(i)), crew);
    }
}
