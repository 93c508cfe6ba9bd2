package radiosity.master;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import radiosity.master.balance.Dealing;
import radiosity.master.host.Host;
import radiosity.master.host.HostCalls;
import radiosity.partition.GhostReport;
import radiosity.partition.GhostVertices;
import radiosity.partition.GhostVertices.Role;
import radiosity.protocol.Order;
import radiosity.protocol.Reply;
import radiosity.setup.InitialMesh;
import radiosity.util.ArraySize;

/**
 * Who of several hosts gathers at a point that all of them have, and how the others get to know: what {@link
 * GhostVertices} are for the master. It saves time, and nothing depends on it: a host that is given nothing gathers
 * itself.
 */
final class HaloExchange {

    /** New elements of all. */
    private static final double FEW = 0.01;

    private final HostCalls calls;
    private final InitialMesh mesh;
    private final Seams seams;
    private int agreement;
    /** Whether hosts have not told each other yet what they have gathered for each other. */
    private boolean owed;
    /** Whether blocks are dealt as they were when this was agreed, and about all points. */
    private boolean isAgreed;
    private boolean isWhole;
    /** How many there were when about all points something was agreed, and now. */
    private int agreedElements;
    private int elements;
    /** Per host: what it takes, in its order. */
    private final Map<Host, List<Source>> sources = new LinkedHashMap<>();
    /** How many points each host gathers at for others. */
    private final Map<Host, Integer> given = new LinkedHashMap<>();
    /** What hosts have said last. */
    private Map<Host, Reply> said = Map.of();

    /** Where what a host takes comes from: place among what the other gives. */
    record Source(Host host, int place) { }

    HaloExchange(HostCalls calls, InitialMesh mesh, Seams seams) {
        this.seams = seams;
        this.calls = calls;
        this.mesh = mesh;
    }

    /** Some hosts have other blocks now. */
    void forget() {
        isAgreed = false;
    }

    /** Whether an order makes some hosts gather for others. */
    boolean isShared(Order order) {
        return order.gathers() && isAgreed && (isWhole || order.kind() != Order.Kind.GATHER)
                && sources.values().stream().anyMatch(all -> !all.isEmpty());
    }

    /**
     * Whether by an order points may be gathered at about which nothing was agreed. Where few elements are new, every
     * host gathers once at all points that it has got: that takes less time than to agree and to tell each other.
     */
    boolean isOpen(Order order) {
        double few = order.kind() == Order.Kind.GATHER ? FEW * agreedElements : 0;
        return mesh.gathersOnce() && order.gathers() && (!isAgreed || !isWhole && elements - agreedElements > few);
    }

    /** Whether hosts have not told each other yet what they have gathered for each other. */
    boolean isOwed() {
        return owed;
    }

    /** Hosts were told to do this. */
    void begun(Order order) {
        owed |= isShared(order);
        if (isWhole && order.kind() == Order.Kind.SPLIT) {
            isWhole = false;
            agreedElements = elements;
        }
    }

    /** Hosts have done this. */
    void done(Order order, Map<Host, Reply> replies) {
        said = replies;
        elements = replies.values().stream().mapToInt(Reply::elements).sum();
        if (order.most() == Order.GIVE) {
            deliver();
        }
    }

    /** Agrees on what nothing was agreed about; a loss then is for the caller to see to. */
    void agree(List<Host> hosts, Dealing dealing) {
        boolean anew = !isAgreed;
        agreement++;
        Map<Host, byte[]> keys = calls.onAll(hosts, host -> host.border(anew));
        if (anew) {
            sources.clear();
            given.clear();
        }
        Map<Host, byte[]> roles = new VertexOwnership(keys, dealing.load(hosts), !mesh.hasSeams()).roles();
        route(keys, roles);
        Map<Host, SeamPatches> left = calls.onAll(roles.keySet(), host -> share(host, keys.get(host), roles.get(host)));
        isAgreed = !calls.isAnyLost();
        isWhole = true;
        if (isAgreed && mesh.hasSeams()) {
            seams.agree(agreement, left);
        }
    }

    /** @return what the host leaves to the master */
    private SeamPatches share(Host host, byte[] keys, byte[] roles) throws IOException {
        byte[] left = host.share(agreement, roles);
        return mesh.hasSeams() ? new SeamPatches(mesh, GhostReport.decode(left, mesh),
                with(Role.GIVES, keys, roles), with(Role.TAKES, keys, roles)) : null;
    }

    private static Set<Long> with(Role wanted, byte[] keys, byte[] roles) {
        return IntStream.range(0, roles.length).filter(i -> roles[i] == wanted.ordinal()).mapToObj(i -> key(keys, i))
                .collect(Collectors.toSet());
    }

    /** Whether nobody was lost since this was agreed, and no blocks have moved. */
    boolean isAgreed() {
        return isAgreed;
    }

    private static long key(byte[] keys, int place) {
        return ByteBuffer.wrap(keys).getLong(Long.BYTES * place);
    }

    /** Hosts give and take in the order in which they have named points. */
    private void route(Map<Host, byte[]> keys, Map<Host, byte[]> roles) {
        Map<Long, Source> gifts = new HashMap<>();
        roles.forEach((host, role) -> {
            sources.computeIfAbsent(host, h -> new ArrayList<>());
            for (int i = 0; i < role.length; i++) {
                if (role[i] == Role.GIVES.ordinal()) {
                    gifts.put(key(keys.get(host), i), new Source(host, given.merge(host, 1, Integer::sum) - 1));
                }
            }
        });
        roles.forEach((host, role) -> {
            for (int i = 0; i < role.length; i++) {
                if (role[i] == Role.TAKES.ordinal()) {
                    sources.get(host).add(gifts.get(key(keys.get(host), i)));
                }
            }
        });
    }

    /**
     * Gives to each host with its next order what others have gathered for it, as far as they have told in the last
     * step; nothing where somebody has not.
     */
    void deliver() {
        boolean all = isAgreed && said.keySet().containsAll(sources.keySet())
                && sources.keySet().stream().allMatch(host -> isWhole(host, said.get(host).given()));
        sources.forEach((host, from) -> {
            if (all) {
                host.tell(gift(from));
            }
        });
        owed = false;
    }

    private int bytesPerPoint() {
        return Double.BYTES * mesh.faces.channels();
    }

    /** Whether a host has told of all points of which it was to tell. */
    private boolean isWhole(Host host, byte[] told) {
        long bytes = Integer.BYTES + (long) bytesPerPoint() * given.getOrDefault(host, 0);
        return told.length >= bytes && ByteBuffer.wrap(told).getInt() == agreement;
    }

    /** What others have gathered for a host that takes it from these places. */
    private byte[] gift(List<Source> from) {
        int bytes = bytesPerPoint();
        byte[] gift = Arrays.copyOf(ByteBuffer.allocate(Integer.BYTES).putInt(agreement).array(),
                ArraySize.of("bytes of the light at points of a border", Integer.BYTES + (long) bytes * from.size()));
        for (int i = 0; i < from.size(); i++) {
            System.arraycopy(said.get(from.get(i).host).given(), Integer.BYTES + bytes * from.get(i).place, gift,
                    Integer.BYTES + bytes * i, bytes);
        }
        return gift;
    }
}
