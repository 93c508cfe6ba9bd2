package radiosity.master;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import radiosity.master.host.Host;
import radiosity.partition.GhostVertices.Role;

/** Who of several hosts gathers at a point that all of them have: whoever would be done first. */
final class VertexOwnership {

    /** Neighbouring points that one host gathers at: with fewer, more patches have corners of several hosts. */
    private static final int RUN = 8;

    private final Map<Host, byte[]> keys;
    private final Map<Host, byte[]> roles = new LinkedHashMap<>();
    /** Per host: points that it will gather at, half of those about which nothing is known yet. */
    private final Map<Host, Double> load;
    /** Of each point that several have. */
    private final List<List<Holder>> holders;

    /** One of the border points of a host. */
    private record Holder(Host host, int place) { }

    /**
     * @param keys of each host's border points, 8 bytes each
     * @param load per host: points that it has to gather at if every point on a border is half its own; modified
     * @param whole whether the load counts points on a border as if they were all its own
     */
    VertexOwnership(Map<Host, byte[]> keys, Map<Host, Double> load, boolean whole) {
        this.keys = keys;
        this.load = load;
        keys.forEach((host, bytes) -> roles.put(host, new byte[bytes.length / Long.BYTES]));
        holders = holders();
        holders.forEach(all -> all.forEach(holder -> load.merge(holder.host, whole ? -0.5 : 0, Double::sum)));
    }

    /** @return per host and point of its: number of a {@link Role} */
    Map<Host, byte[]> roles() {
        Map<List<Host>, List<List<Holder>>> alike = new LinkedHashMap<>();
        for (List<Holder> all : holders) {
            alike.computeIfAbsent(all.stream().map(Holder::host).toList(), hosts -> new ArrayList<>()).add(all);
        }
        alike.forEach((hosts, points) -> {
            for (int i = 0; i < points.size(); i += RUN) {
                share(points.subList(i, Math.min(points.size(), i + RUN)));
            }
        });
        return roles;
    }

    /** Who has each point that several have, in the order in which hosts name them. */
    private List<List<Holder>> holders() {
        Map<Long, List<Holder>> holders = new LinkedHashMap<>();
        keys.forEach((host, bytes) -> {
            for (int i = 0; i < roles.get(host).length; i++) {
                long key = ByteBuffer.wrap(bytes).getLong(Long.BYTES * i);
                holders.computeIfAbsent(key, k -> new ArrayList<>(2)).add(new Holder(host, i));
            }
        });
        return holders.values().stream().filter(all -> all.size() > 1).toList();
    }

    /** Some points that the same hosts have. */
    private void share(List<List<Holder>> points) {
        int giver = 0;
        List<Holder> hosts = points.get(0);
        for (int i = 1; i < hosts.size(); i++) {
            giver = load.get(hosts.get(i).host) < load.get(hosts.get(giver).host) ? i : giver;
        }
        for (int i = 0; i < hosts.size(); i++) {
            give(points, i, i == giver ? Role.GIVES : Role.TAKES);
        }
    }

    private void give(List<List<Holder>> points, int holder, Role role) {
        load.merge(points.get(0).get(holder).host, (role == Role.GIVES ? 0.5 : -0.5) * points.size(), Double::sum);
        for (List<Holder> point : points) {
            roles.get(point.get(holder).host)[point.get(holder).place] = (byte) role.ordinal();
        }
    }
}
