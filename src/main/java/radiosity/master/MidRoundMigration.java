package radiosity.master;

import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import radiosity.master.HaloExchange.Source;
import radiosity.master.balance.Balance;
import radiosity.master.host.Host;
import radiosity.protocol.PiggybackMessage;
import radiosity.protocol.Reply;
import radiosity.protocol.Wire;

/**
 * Points that hosts which are behind hand over in mid-round to hosts which are ahead: nobody waits, as what had arrived
 * there follows, and whoever got a point gathers then what it has missed. When all is told, everything is as before.
 */
final class MidRoundMigration {

    /** Neighbouring points that go together. */
    private static final int RUN = 8;

    private final int agreement;
    /** Per host: what it takes otherwise; not modified. */
    private final Map<Host, List<Source>> sources;
    private final Map<Host, Integer> given;
    private final Map<Host, Balance.Delay> delays;
    /** Places among what a host gives otherwise, and among what one takes. */
    private final Map<Host, List<Integer>> out = new LinkedHashMap<>();
    private final Map<Host, List<Integer>> in = new LinkedHashMap<>();
    /** Per host that takes over: where it stands among what another one has handed out. */
    private final Map<Host, List<Source>> from = new LinkedHashMap<>();
    private boolean isDone;

    private record Pair(Host from, Host to) { }

    /** Some neighbouring points that two hosts have: their places. */
    private record Run(Pair hosts, List<Integer> out, List<Integer> in) { }

    /**
     * @param sources per host: where what it takes comes from
     * @param given   per host: how many points it gives
     */
    MidRoundMigration(int agreement, Map<Host, List<Source>> sources, Map<Host, Integer> given, Map<Host,
            Balance.Delay> delays) {
        this.agreement = agreement;
        this.sources = sources;
        this.given = given;
        this.delays = new LinkedHashMap<>(delays);
        Map<Pair, Deque<Run>> runs = runs();
        boolean helps = true;
        while (helps) {
            helps = handOver(runs);
        }
    }

    /** Points that one of two hosts gives and only the other one takes. */
    private Map<Pair, Deque<Run>> runs() {
        Map<Source, Integer> takers = new HashMap<>();
        sources.values().forEach(all -> all.forEach(source -> takers.merge(source, 1, Integer::sum)));
        Map<Pair, Deque<Run>> runs = new LinkedHashMap<>();
        sources.forEach((to, all) -> {
            for (int i = 0; i < all.size(); i++) {
                if (takers.get(all.get(i)) == 1) {
                    add(all.get(i), to, i, runs);
                }
            }
        });
        return runs;
    }

    private static void add(Source source, Host to, int place, Map<Pair, Deque<Run>> runs) {
        Pair pair = new Pair(source.host(), to);
        Deque<Run> all = runs.computeIfAbsent(pair, p -> new ArrayDeque<>());
        if (all.isEmpty() || all.getLast().out.size() == RUN) {
            all.add(new Run(pair, new ArrayList<>(), new ArrayList<>()));
        }
        all.getLast().out.add(source.place());
        all.getLast().in.add(place);
    }

    /** One run, between the hosts that are farthest apart; whether that helps. */
    private boolean handOver(Map<Pair, Deque<Run>> runs) {
        Run best = null;
        double most = 0;
        for (Deque<Run> some : runs.values()) {
            Run next = some.peek();
            if (next != null && apart(next.hosts, 0) > most && apart(next.hosts, next.out.size()) >= 0) {
                most = apart(next.hosts, 0);
                best = next;
            }
        }
        if (best != null) {
            runs.get(best.hosts).remove();
            add(best);
        }
        return best != null;
    }

    /** By how much the first host is behind the second when so many points have gone, s. */
    private double apart(Pair hosts, int points) {
        return delays.get(hosts.from).with(-points).seconds() - delays.get(hosts.to).with(points).seconds();
    }

    private void add(Run run) {
        delays.computeIfPresent(run.hosts.from, (host, delay) -> delay.with(-run.out.size()));
        delays.computeIfPresent(run.hosts.to, (host, delay) -> delay.with(run.out.size()));
        List<Integer> handed = out.computeIfAbsent(run.hosts.from, h -> new ArrayList<>());
        for (int i = 0; i < run.out.size(); i++) {
            from.computeIfAbsent(run.hosts.to, h -> new ArrayList<>()).add(new Source(run.hosts.from, handed.size()));
            handed.add(run.out.get(i));
            in.computeIfAbsent(run.hosts.to, h -> new ArrayList<>()).add(run.in.get(i));
        }
    }

    /** With the next order of those that hand over or take over. */
    void tell() {
        isDone = out.isEmpty();
        sources.keySet().stream().filter(host -> out.containsKey(host) || in.containsKey(host)).forEach(host -> {
            List<Integer> its = out.getOrDefault(host, List.of());
            List<Integer> others = in.getOrDefault(host, List.of());
            host.tell(PiggybackMessage.HAND_OVER, Wire.bytes(bytes -> {
                bytes.writeInt(agreement);
                for (List<Integer> places : List.of(its, others)) {
                    bytes.writeInt(places.size());
                    for (int place : places) {
                        bytes.writeInt(place);
                    }
                }
            }));
        });
    }

    boolean isDone() {
        return isDone;
    }

    /** Hosts have done a step; the first one with what they handed out. */
    void done(Map<Host, Reply> replies, int bytesPerPoint) {
        boolean has = out.entrySet().stream().allMatch(one -> replies.containsKey(one.getKey())
                && replies.get(one.getKey()).given().length
                == Integer.BYTES + (long) bytesPerPoint * one.getValue().size());
        if (has) {
            from.forEach((host, all) -> host.tell(PiggybackMessage.HANDED_OVER,
                    HaloExchange.gift(agreement, all, replies, bytesPerPoint)));
            isDone = true;
        }
    }

    /** How many points a host tells about. */
    int told(Host host) {
        return given.getOrDefault(host, 0) + in.getOrDefault(host, List.of()).size();
    }

    /** Where what a host takes comes from: what it gathers itself now is its own, what it handed out comes last. */
    List<Source> sources(Host host) {
        List<Source> now = new ArrayList<>(sources.get(host));
        List<Integer> its = in.getOrDefault(host, List.of());
        for (int i = 0; i < its.size(); i++) {
            now.set(its.get(i), new Source(host, given.getOrDefault(host, 0) + i));
        }
        Source[] others = new Source[out.getOrDefault(host, List.of()).size()];
        from.forEach((to, all) -> {
            for (int i = 0; i < all.size(); i++) {
                if (all.get(i).host() == host) {
                    others[all.get(i).place()] = new Source(to, given.getOrDefault(to, 0) + i);
                }
            }
        });
        now.addAll(Arrays.asList(others));
        return now;
    }
}
