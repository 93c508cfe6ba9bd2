package radiosity.partition;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicLongArray;
import radiosity.mesh.Block;
import radiosity.mesh.RadiosityNodes;
import radiosity.protocol.BlockWork;

/**
 * Elements, receiving points and processor time of each block of a partition. The time is measured because the cost of
 * a point depends on where the point lies: an estimate from the number of elements is wrong by half. Any number of
 * threads may call {@link #add}, one thread at a time the other methods.
 */
public final class BlockCosts {

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final RadiosityNodes nodes;
    /** 1 array per block: its top nodes. */
    private final int[][] tops;
    private final int[] elements;
    private final int[] points;
    private final int[] gathered;
    /** 1 per block: processor time spent at receiving points since the last report, ns. */
    private final AtomicLongArray time;
    /** 1 per vertex: the last block that has the vertex, or -1. */
    private int[] blockOf = new int[0];
    /** Number of nodes at the last count; -1 before the first one. */
    private int known = -1;

    BlockCosts(RadiosityNodes nodes, List<Block> blocks) {
        this.nodes = nodes;
        tops = blocks.stream().map(nodes::tops).toArray(int[][]::new);
        elements = new int[tops.length];
        points = new int[tops.length];
        gathered = new int[tops.length];
        time = new AtomicLongArray(tops.length);
    }

    /** Processor time of the calling thread, ns; 0 where the JVM cannot measure it. */
    public static long now() {
        return THREADS.isCurrentThreadCpuTimeSupported() ? THREADS.getCurrentThreadCpuTime() : 0;
    }

    /** Counts vertices that are about to gather, each for one of the blocks that share the vertex. */
    void begin(int[] vertices) {
        recount();
        for (int v : vertices) {
            gathered[blockOf[v]]++;
        }
    }

    /** Adds the processor time of gathering at neighbouring vertices to their blocks, in equal parts per vertex. */
    void add(int[] vertices, long nanoseconds) {
        for (int i = 0, next; i < vertices.length; i = next) {
            int block = blockOf[vertices[i]];
            next = i + 1;
            while (next < vertices.length && blockOf[vertices[next]] == block) {
                next++;
            }
            time.addAndGet(block, nanoseconds * (next - i) / vertices.length);
        }
    }

    private void recount() {
        if (known == nodes.nodes()) {
            return;
        }
        known = nodes.nodes();
        blockOf = new int[nodes.vertices()];
        Arrays.fill(blockOf, -1);
        for (int b = 0; b < tops.length; b++) {
            elements[b] = points[b] = 0;
            for (int top : tops[b]) {
                count(b, top);
            }
        }
    }

    private void count(int b, int node) {
        if (!nodes.isElement(node)) {
            for (int k = 0; k < 4; k++) {
                count(b, nodes.child(node) + k);
            }
            return;
        }
        elements[b]++;
        for (int k = 0; k < 3; k++) {
            int v = nodes.corner(node, k);
            if (blockOf[v] != b) {
                blockOf[v] = b;
                points[b]++;
            }
        }
    }

    /**
     * Reports the work of each block since the last report, and begins a new period.
     *
     * @param all processor time of the partition since the last report, s; the part of it that was not spent at
     *            receiving points is shared out by number of elements
     * @return one per block, in the order of the blocks
     */
    public BlockWork[] report(double all) {
        recount();
        double atPoints = 0;
        for (int b = 0; b < tops.length; b++) {
            atPoints += time.get(b) * 1e-9;
        }
        double rest = Math.max(0, all - atPoints) / Math.max(1, nodes.elements());
        BlockWork[] report = new BlockWork[tops.length];
        for (int b = 0; b < tops.length; b++) {
            double seconds = time.getAndSet(b, 0) * 1e-9 + rest * elements[b];
            report[b] = new BlockWork(elements[b], points[b], gathered[b], (float) seconds);
            gathered[b] = 0;
        }
        return report;
    }
}
