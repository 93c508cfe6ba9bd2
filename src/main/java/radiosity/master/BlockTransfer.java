package radiosity.master;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import radiosity.master.balance.Dealing;
import radiosity.master.host.Host;
import radiosity.master.host.HostCalls;
import radiosity.protocol.BlockTakeover;

/** Brings blocks to their owners, and their states to the master. */
final class BlockTransfer {

    private final Dealing dealing;
    private final ShotLog log;
    private final HostCalls calls;

    BlockTransfer(Dealing dealing, ShotLog log, HostCalls calls) {
        this.dealing = dealing;
        this.log = log;
        this.calls = calls;
    }

    /**
     * Deals all blocks without an owner, and brings them up to date.
     *
     * @return what each host that has got some answers to the orders of the log that are answered
     */
    Map<Host, List<byte[]>> adopt(List<Host> hosts) {
        List<Integer> orphans = dealing.orphans();
        dealing.deal(hosts);
        Map<Host, List<Integer>> heirs = new LinkedHashMap<>();
        for (Host host : hosts) {
            List<Integer> blocks = new ArrayList<>(dealing.blocks(host));
            blocks.retainAll(orphans);
            if (!blocks.isEmpty()) {
                heirs.put(host, blocks);
            }
        }
        return calls.onAll(heirs.keySet(), host -> host.take(log.adoption(heirs.get(host))));
    }

    /** From host to host, as they are; what a lost host had stays its own until it is adopted. */
    void move(List<Dealing.Move> moves) {
        Map<Host, List<Integer>> from = new LinkedHashMap<>();
        Map<Host, Map<Integer, byte[]>> to = new LinkedHashMap<>();
        moves.forEach(move -> from.computeIfAbsent(move.from(), h -> new ArrayList<>()).add(move.block()));
        Map<Host, List<byte[]>> states = calls.onAll(from.keySet(), host -> host.blocks(from.get(host)));
        states.keySet().forEach(host -> to.put(host, new TreeMap<>()));
        for (Dealing.Move move : moves) {
            if (states.containsKey(move.from())) {
                byte[] state = states.get(move.from()).get(from.get(move.from()).indexOf(move.block()));
                to.computeIfAbsent(move.to(), h -> new TreeMap<>()).put(move.block(), state);
                dealing.give(move.block(), move.to());
            }
        }
        calls.onAll(to.keySet(), host ->
                host.take(new BlockTakeover(to.get(host), List.of(), from.getOrDefault(host, List.of()))));
    }

    /** The states of all blocks, by id; fewer where a host is lost. */
    List<byte[]> states(List<Host> hosts) {
        Map<Integer, byte[]> all = new TreeMap<>();
        calls.onAll(hosts, host -> host.blocks(dealing.blocks(host))).forEach((host, some) -> {
            List<Integer> ids = dealing.blocks(host);
            for (int i = 0; i < ids.size(); i++) {
                all.put(ids.get(i), some.get(i));
            }
        });
        return List.copyOf(all.values());
    }

    /** Puts all blocks back to what is in the log. */
    void restore(List<Host> hosts) {
        calls.onAll(hosts, host -> host.take(log.adoption(dealing.blocks(host))));
    }
}
