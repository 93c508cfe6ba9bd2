package radiosity.master.balance;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import radiosity.master.host.Host;

/**
 * Who owns which block (section 4.3 of the paper): hosts own as much as they are fast, and what lies side by side has
 * one owner where that costs no balance.
 */
public final class Dealing {

    /** Blocks are moved where that shortens the slowest host's time by this part. */
    private static final double WORTH = 0.03;

    /** 1 per block; null where the owner is lost. */
    private final Host[] owner;
    private final BlockCostModel forecast;
    private final Borders borders;

    public Dealing(BlockCostModel forecast, Borders borders) {
        this.forecast = forecast;
        this.borders = borders;
        owner = new Host[borders.blocks()];
    }

    /** A block that shall go from one host to another. */
    public record Move(int block, Host from, Host to) { }

    public List<Integer> blocks(Host of) {
        List<Integer> blocks = new ArrayList<>();
        for (int b = 0; b < owner.length; b++) {
            if (owner[b] == of) {
                blocks.add(b);
            }
        }
        return blocks;
    }

    public void give(int block, Host to) {
        owner[block] = to;
    }

    public void lose(Host host) {
        blocks(host).forEach(b -> owner[b] = null);
    }

    public List<Integer> orphans() {
        return blocks(null);
    }

    /** Gives every block without an owner to whom it delays least. */
    public void deal(List<Host> hosts) {
        boolean first = orphans().size() == owner.length;
        BlockAssignment shares = shares(hosts, false);
        shares.deal();
        if (first) {
            shares.improve();
        }
        int[] dealt = shares.owners();
        for (int b = 0; b < owner.length; b++) {
            owner[b] = hosts.get(dealt[b]);
        }
    }

    private BlockAssignment shares(List<Host> hosts, boolean gather) {
        double[] speed = hosts.stream().mapToDouble(host -> host.speed).toArray();
        int[] number = Arrays.stream(owner).mapToInt(hosts::indexOf).toArray();
        return new BlockAssignment(forecast.next(gather), borders, speed, number);
    }

    /**
     * What hosts will wait for the slowest one per shooter of the next round, s.
     *
     * @param gather whether only new points gather
     */
    double waiting(List<Host> hosts, boolean gather) {
        return shares(hosts, gather).waiting();
    }

    /** Per host what it has to do in the next rounds, counted in points of which all take the same time. */
    public Map<Host, Double> load(List<Host> hosts) {
        BlockAssignment shares = shares(hosts, false);
        Map<Host, Double> load = new LinkedHashMap<>();
        for (int h = 0; h < hosts.size(); h++) {
            load.put(hosts.get(h), shares.points(h));
        }
        return load;
    }

    /** What shortens the next rounds; empty where too little is to be won. */
    public List<Move> moves(List<Host> hosts, boolean gather) {
        BlockAssignment shares = shares(hosts, gather);
        double before = shares.slowest();
        if (shares.waiting() < WORTH * before) {
            return List.of();
        }
        shares.relieve();
        int[] after = shares.owners();
        List<Move> moves = new ArrayList<>();
        for (int b = 0; b < owner.length && shares.slowest() < (1 - WORTH) * before; b++) {
            if (owner[b] != hosts.get(after[b])) {
                moves.add(new Move(b, owner[b], hosts.get(after[b])));
            }
        }
        return moves;
    }
}
