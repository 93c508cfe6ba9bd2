package radiosity.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Who owns which block. Neighbours go to different hosts, as elements beside one that is subdivided are likely to be
 * subdivided too (section 4.3 of the paper); hosts own as much as they are fast.
 */
final class Dealing {

    /** Blocks are moved where that shortens the slowest host's time by this part. */
    private static final double WORTH = 0.03;

    /** 1 per block; null where the owner is lost. */
    private final Host[] owner;
    /** 1 per block: elements. */
    private final int[] work;

    Dealing(int blocks) {
        owner = new Host[blocks];
        work = new int[blocks];
        Arrays.fill(work, 1);
    }

    /** A block that shall go from one host to another. */
    record Move(int block, Host from, Host to) { }

    List<Integer> blocks(Host of) {
        List<Integer> blocks = new ArrayList<>();
        for (int b = 0; b < owner.length; b++) {
            if (owner[b] == of) {
                blocks.add(b);
            }
        }
        return blocks;
    }

    void note(Host host, int[] elements) {
        List<Integer> blocks = blocks(host);
        for (int i = 0; i < Math.min(blocks.size(), elements.length); i++) {
            work[blocks.get(i)] = elements[i];
        }
    }

    void give(int block, Host to) {
        owner[block] = to;
    }

    void lose(Host host) {
        blocks(host).forEach(b -> owner[b] = null);
    }

    List<Integer> orphans() {
        return blocks(null);
    }

    /** Every block without an owner goes to whom it delays least. */
    void deal(Collection<Host> hosts) {
        Map<Host, Double> time = new LinkedHashMap<>();
        hosts.forEach(host -> time.put(host, time(host)));
        for (int b : orphans()) {
            int elements = work[b];
            owner[b] = hosts.stream().min(Comparator.comparingDouble(h -> time.get(h) + elements / h.speed)).orElseThrow();
            time.merge(owner[b], elements / owner[b].speed, Double::sum);
        }
    }

    private double time(Host host) {
        double sum = 0;
        for (int b = 0; b < owner.length; b++) {
            sum += owner[b] == host ? work[b] : 0;
        }
        return sum / host.speed;
    }

    /** What shortens the next rounds; empty where too little is to be won. */
    List<Move> moves(List<Host> hosts) {
        double before = time(slowest(hosts));
        Host[] old = owner.clone();
        while (moveOne(hosts)) { }
        List<Move> moves = new ArrayList<>();
        for (int b = 0; b < owner.length; b++) {
            if (owner[b] != old[b]) {
                moves.add(new Move(b, old[b], owner[b]));
            }
        }
        boolean worth = time(slowest(hosts)) < (1 - WORTH) * before;
        System.arraycopy(old, 0, owner, 0, old.length);
        return worth ? moves : List.of();
    }

    private Host slowest(List<Host> hosts) {
        Host slowest = hosts.get(0);
        for (Host host : hosts) {
            slowest = time(host) > time(slowest) ? host : slowest;
        }
        return slowest;
    }

    /** From the slowest host, the block to the host that leaves the later of the two earliest; false where none does. */
    private boolean moveOne(List<Host> hosts) {
        Host from = slowest(hosts);
        double best = (1 - WORTH / 10) * time(from);
        int block = -1;
        Host to = null;
        for (Host host : hosts) {
            double there = time(host);
            double here = time(from);
            for (int b = 0; b < owner.length && host != from; b++) {
                double later = Math.max(here - work[b] / from.speed, there + work[b] / host.speed);
                if (owner[b] == from && later < best) {
                    best = later;
                    block = b;
                    to = host;
                }
            }
        }
        if (to != null) {
            owner[block] = to;
        }
        return to != null;
    }
}
