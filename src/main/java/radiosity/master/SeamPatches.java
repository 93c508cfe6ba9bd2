package radiosity.master;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.LongBuffer;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.LongStream;
import radiosity.master.HaloExchange.Source;
import radiosity.master.host.Host;
import radiosity.partition.GhostReport;
import radiosity.partition.PartitionImpl;
import radiosity.partition.Seam;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.setup.InitialMesh;

/** The patches of a host's {@link Seam}, as the master keeps them: hosts gather at their corners. */
final class SeamPatches {

    private final PartitionImpl partition;
    private final int bytesPerPoint;
    /** Keys of the points of which the host says what has arrived there. */
    private final long[] given;
    /** 1 per point of these patches. */
    private Source[] sources;

    /**
     * @param gives keys of the points at which the host gathers for others
     * @param takes of those at which others gather for it
     * @throws IOException where it does not tell of all points that it has to tell of
     */
    SeamPatches(InitialMesh mesh, GhostReport report, Set<Long> gives, Set<Long> takes) throws IOException {
        partition = new PartitionImpl(mesh, List.of(report.patches()), 1, true);
        partition.restore(report.patches().id(), report.state());
        bytesPerPoint = Double.BYTES * mesh.faces.channels();
        given = report.given();
        Set<Long> missing = new HashSet<>(gives);
        LongBuffer own = ByteBuffer.wrap(partition.border().keys()).asLongBuffer();
        while (own.hasRemaining()) {
            missing.add(own.get());
        }
        missing.removeAll(takes);
        LongStream.of(given).forEach(missing::remove);
        if (!missing.isEmpty()) {
            throw new IOException("seam: expected to be told of all points, got " + missing.size() + " too few");
        }
    }

    /** Adds where this host gathers. */
    void addTo(Map<Long, Source> gathering, Host host) {
        for (int i = 0; i < given.length; i++) {
            gathering.put(given[i], new Source(host, i));
        }
    }

    /** Who gathers at each point; every one has somebody. */
    void find(Map<Long, Source> gathering) {
        ByteBuffer keys = ByteBuffer.wrap(partition.border().keys());
        sources = new Source[keys.remaining() / Long.BYTES];
        for (int v = 0; v < sources.length; v++) {
            sources[v] = gathering.get(keys.getLong());
        }
    }

    /** Whether the host has said this under an agreement. */
    boolean isOf(int agreement, byte[] said) {
        return said.length == Integer.BYTES + (long) bytesPerPoint * given.length && ByteBuffer.wrap(said)
                .getInt() == agreement;
    }

    /**
     * Does a step, gathering where a host is lost that would have.
     *
     * @param said what hosts have gathered up to now
     */
    Answer answer(Order order, Map<Host, byte[]> said) {
        BitSet heard = new BitSet();
        for (int v = 0; v < sources.length; v++) {
            heard.set(v, said.containsKey(sources[v].host()));
        }
        partition.border().take(heard);
        partition.answer(order.naming(-1));
        heard.stream().forEach(v -> partition.border().irradiance().put(v, ByteBuffer.wrap(said.get(sources[v].host())),
                Integer.BYTES + bytesPerPoint * sources[v].place()));
        return partition.answer(Order.plain(Order.Kind.ASK, order.most()).from(order.least()));
    }
}
