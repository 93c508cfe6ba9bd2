package radiosity.master;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import radiosity.master.InFlightSteps.Step;
import radiosity.master.host.Host;
import radiosity.master.host.HostCalls;
import radiosity.partition.GhostVertices;
import radiosity.partition.GhostVertices.Role;
import radiosity.protocol.Order;
import radiosity.protocol.Reply;
import radiosity.setup.InitialMesh;
import radiosity.util.ArraySize;
import radiosity.util.Hash;

/**
 * The master's side of {@link GhostVertices}: decides which host gathers at a vertex that several hosts have, and
 * passes the irradiance on to the others. This saves time, and no result depends on it: a host that receives no ghost
 * values gathers itself.
 */
final class HaloExchange {

    /**
     * Number of new elements, relative to all, up to which the new vertices gather without an agreement: each host
     * gathers at all its new vertices, which takes less time than to agree.
     */
    private static final double FEW = 0.01;

    private final HostCalls calls;
    private final InitialMesh mesh;
    /** Number of the last agreement, from 1. */
    private int agreement;
    private boolean isAgreed;
    /** Whether hosts have gathered for each other, and the ghost values are not delivered yet. */
    private boolean isUndelivered;
    /** Number of elements of all hosts at the last agreement, and after the last step. */
    private double agreedElements;
    private double elements;
    /** Per host: the sources of the ghost values that it takes, in the order in which the host expects them. */
    private final Map<Host, List<Source>> sources = new LinkedHashMap<>();
    /** Per host: the number of vertices at which it gathers for others. */
    private final Map<Host, Integer> given = new LinkedHashMap<>();

    /** A border vertex of a host: its place among the vertices that the host has named. */
    private record Holder(Host host, int place) { }

    /** The source of a ghost value: its place among the values that a host gives. */
    private record Source(Host host, int place) { }

    HaloExchange(HostCalls calls, InitialMesh mesh) {
        this.calls = calls;
        this.mesh = mesh;
        elements = mesh.patcher.patches();
    }

    /** Ends the agreement, as some hosts have other blocks now. */
    void forget() {
        isAgreed = false;
    }

    /** Whether some hosts gather for others when they carry out this order. */
    boolean isShared(Order order) {
        return order.gathers() && isAgreed && !given.isEmpty();
    }

    /** Whether hosts have to agree before they carry out this order. */
    boolean isOpen(Order order) {
        double few = order.kind() == Order.Kind.GATHER ? FEW * agreedElements : 0;
        return mesh.gathersOnce() && order.gathers() && (!isAgreed || elements - agreedElements > few);
    }

    /** Whether hosts have gathered for each other, and the ghost values are not delivered yet. */
    boolean isUndelivered() {
        return isUndelivered;
    }

    /** Notes that hosts were given this order. */
    void begun(Order order) {
        isUndelivered |= isShared(order);
    }

    /** Notes that all hosts have done a step. */
    void done(Step step) {
        elements = step.replies().values().stream().mapToInt(Reply::elements).sum();
    }

    /** Whether hosts have agreed, and since then no host was lost and no block has moved. */
    boolean isAgreed() {
        return isAgreed;
    }

    /** Makes an agreement between all hosts; there is none if a host is lost meanwhile. */
    void agree(List<Host> hosts) {
        agreement++;
        agreedElements = elements;
        Map<Host, byte[]> keys = calls.onAll(hosts, Host::border);
        Map<Host, byte[]> roles = new LinkedHashMap<>();
        keys.forEach((host, bytes) -> roles.put(host, new byte[bytes.length / Long.BYTES]));
        Map<Long, Holder> owners = assign(keys, roles);
        route(keys, roles, owners);
        calls.onAll(roles.keySet(), host -> host.share(agreement, roles.get(host)));
        isAgreed = !calls.isAnyLost();
    }

    /**
     * Chooses, by a hash of its key, the host that gathers at each vertex that several hosts have.
     *
     * @param keys  per host: keys of its border vertices, 8 bytes each
     * @param roles modified; per host: the {@link Role} of each border vertex, one byte each
     * @return the chosen host by the vertex's key
     */
    private static Map<Long, Holder> assign(Map<Host, byte[]> keys, Map<Host, byte[]> roles) {
        Map<Long, List<Holder>> holders = new LinkedHashMap<>();
        keys.forEach((host, bytes) -> {
            for (int i = 0; i < roles.get(host).length; i++) {
                holders.computeIfAbsent(key(bytes, i), k -> new ArrayList<>(2)).add(new Holder(host, i));
            }
        });
        Map<Long, Holder> owners = new HashMap<>();
        holders.forEach((key, all) -> {
            if (all.size() > 1) {
                Holder owner = all.get((int) Long.remainderUnsigned(Hash.mix(key, 0), all.size()));
                all.forEach(holder -> roles.get(holder.host)[holder.place] =
                        (byte) (holder == owner ? Role.GIVES : Role.TAKES).ordinal());
                owners.put(key, owner);
            }
        });
        return owners;
    }

    private static long key(byte[] keys, int place) {
        return ByteBuffer.wrap(keys).getLong(Long.BYTES * place);
    }

    /** Finds the source of each ghost value: hosts give and take values in the order in which they named vertices. */
    private void route(Map<Host, byte[]> keys, Map<Host, byte[]> roles, Map<Long, Holder> owners) {
        sources.clear();
        given.clear();
        Map<Holder, Source> places = new HashMap<>();
        roles.forEach((host, role) -> {
            for (int i = 0; i < role.length; i++) {
                if (role[i] == Role.GIVES.ordinal()) {
                    places.put(new Holder(host, i), new Source(host, given.merge(host, 1, Integer::sum) - 1));
                }
            }
        });
        roles.forEach((host, role) -> {
            List<Source> from = sources.computeIfAbsent(host, h -> new ArrayList<>());
            for (int i = 0; i < role.length; i++) {
                if (role[i] == Role.TAKES.ordinal()) {
                    from.add(places.get(owners.get(key(keys.get(host), i))));
                }
            }
        });
    }

    /**
     * Appends to each host's next order the ghost values for this host. Delivers none where a host is lost, or where
     * the values of a host do not belong to the agreement.
     *
     * @param step a step whose replies contain ghost values
     */
    void deliver(Step step) {
        Map<Host, Reply> said = step.replies();
        if (isAgreed && said.keySet().containsAll(sources.keySet())
                && sources.keySet().stream().allMatch(host -> isWhole(host, said.get(host).given()))) {
            sources.forEach((host, from) -> host.addGhostValues(values(from, said)));
        }
        isUndelivered = false;
    }

    private int bytesPerVertex() {
        return Double.BYTES * mesh.faces.channels();
    }

    /** Whether a host's ghost values belong to the agreement and are those of all vertices at which the host gives. */
    private boolean isWhole(Host host, byte[] values) {
        long bytes = Integer.BYTES + (long) bytesPerVertex() * given.getOrDefault(host, 0);
        return values.length == bytes && ByteBuffer.wrap(values).getInt() == agreement;
    }

    /** The message with the ghost values from some sources: number of the agreement, then the values. */
    private byte[] values(List<Source> from, Map<Host, Reply> said) {
        ByteBuffer values = ByteBuffer.allocate(ArraySize.of("bytes of ghost values",
                Integer.BYTES + (long) bytesPerVertex() * from.size())).putInt(agreement);
        from.forEach(source -> values.put(said.get(source.host).given(),
                Integer.BYTES + bytesPerVertex() * source.place, bytesPerVertex()));
        return values.array();
    }
}
