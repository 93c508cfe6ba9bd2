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
 * Which host gathers at a vertex that several hosts have, and how the irradiance comes to the others: what {@link
 * GhostVertices} are for the master. It saves time, and nothing depends on it: a host that receives no ghost values
 * gathers itself.
 */
final class HaloExchange {

    /**
     * The part of new elements up to which hosts need not agree before the new vertices gather: each gathers once at
     * those that it has, which takes less time.
     */
    private static final double FEW = 0.01;

    private final HostCalls calls;
    private final InitialMesh mesh;
    private int agreement;
    private boolean isAgreed;
    /** Whether hosts have gathered for each other, and the values have not been delivered. */
    private boolean isUndelivered;
    /** How many elements there were at the last agreement, and are now. */
    private double agreedElements;
    private double elements;
    /** Per host: where the vertices come from that it takes, in its order. */
    private final Map<Host, List<Source>> sources = new LinkedHashMap<>();
    /** Per host: at how many vertices it gathers for others. */
    private final Map<Host, Integer> given = new LinkedHashMap<>();

    /** One of the border vertices of a host: its place among those that the host has named. */
    private record Holder(Host host, int place) { }

    /** Where a ghost value comes from: its place among what a host gives. */
    private record Source(Host host, int place) { }

    HaloExchange(HostCalls calls, InitialMesh mesh) {
        this.calls = calls;
        this.mesh = mesh;
        elements = mesh.patcher.patches();
    }

    /** Some hosts have other blocks now. */
    void forget() {
        isAgreed = false;
    }

    /** Whether by an order some hosts gather for others. */
    boolean isShared(Order order) {
        return order.gathers() && isAgreed && !given.isEmpty();
    }

    /** Whether hosts have to agree before an order. */
    boolean isOpen(Order order) {
        double few = order.kind() == Order.Kind.GATHER ? FEW * agreedElements : 0;
        return mesh.gathersOnce() && order.gathers() && (!isAgreed || elements - agreedElements > few);
    }

    /** Whether hosts have gathered for each other, and the values have not been delivered. */
    boolean isUndelivered() {
        return isUndelivered;
    }

    /** Hosts were given this order. */
    void begun(Order order) {
        isUndelivered |= isShared(order);
    }

    /** All hosts have done a step. */
    void done(Step step) {
        elements = step.replies().values().stream().mapToInt(Reply::elements).sum();
    }

    /** Whether nobody was lost since hosts have agreed, and no blocks have moved. */
    boolean isAgreed() {
        return isAgreed;
    }

    /** Has all hosts agree; where one is lost meanwhile, they have not. */
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
     * A hash of the vertex says which of the hosts that have it gathers there.
     *
     * @param roles modified
     * @return by key of each vertex that several hosts have
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

    /** Hosts give and take in the order in which they have named vertices. */
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
     * Gives to each host with its next order what others have gathered for it; nothing where a host is lost, or its
     * values are not those that were agreed on.
     *
     * @param step whose replies bring what hosts have gathered for each other
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

    /** Whether a host has sent the values of all vertices at which it gathers for others. */
    private boolean isWhole(Host host, byte[] values) {
        long bytes = Integer.BYTES + (long) bytesPerVertex() * given.getOrDefault(host, 0);
        return values.length == bytes && ByteBuffer.wrap(values).getInt() == agreement;
    }

    /** The ghost values for a host, from these sources. */
    private byte[] values(List<Source> from, Map<Host, Reply> said) {
        ByteBuffer values = ByteBuffer.allocate(ArraySize.of("bytes of ghost values",
                Integer.BYTES + (long) bytesPerVertex() * from.size())).putInt(agreement);
        from.forEach(source -> values.put(said.get(source.host).given(),
                Integer.BYTES + bytesPerVertex() * source.place, bytesPerVertex()));
        return values.array();
    }
}
