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
 * What the blocks of a partition hold and take. Measured, as what a receiving point takes depends on where it lies: a
 * guess by the number of elements is wrong by half.
 */
public final class BlockCosts {

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final RadiosityNodes nodes;
    /** Top nodes per block. */
    private final int[][] tops;
    private final int[] elements;
    private final int[] points;
    private final int[] gathered;
    /** 1 per block: processor time since it was reported, ns. */
    private final AtomicLongArray time;
    /** 1 per vertex: a block that has it. */
    private int[] blockOf = new int[0];
    private int known = -1;

    BlockCosts(RadiosityNodes nodes, List<Block> blocks) {
        this.nodes = nodes;
        tops = blocks.stream().map(nodes::tops).toArray(int[][]::new);
        elements = new int[tops.length];
        points = new int[tops.length];
        gathered = new int[tops.length];
        time = new AtomicLongArray(tops.length);
    }

    /** Processor time of this thread, ns; 0 where the machine does not say. */
    public static long now() {
        return THREADS.isCurrentThreadCpuTimeSupported() ? THREADS.getCurrentThreadCpuTime() : 0;
    }

    /** Before points gather. */
    void begin(int[] vertices) {
        recount();
        for (int v : vertices) {
            gathered[blockOf[v]]++;
        }
    }

    /** Some points have gathered: neighbours, which take about the same. Any thread. */
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
     * One per block, since the last report.
     *
     * @param all processor time, s: what was not spent at points is shared out by elements
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
