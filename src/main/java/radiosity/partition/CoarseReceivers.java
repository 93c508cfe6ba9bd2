package radiosity.partition;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.RayCaster;
import radiosity.formfactor.ShooterHierarchy;
import radiosity.mesh.Block;
import radiosity.mesh.RadiosityNodes;
import radiosity.prediction.CoarseRows;
import radiosity.prediction.CoarseSystem;
import radiosity.prediction.RowRecorder;
import radiosity.protocol.Order;
import radiosity.setup.InitialMesh;
import radiosity.util.ArraySize;
import radiosity.util.ParallelFor;

/**
 * Makes the rows of a {@link CoarseSystem} for which a partition is responsible, one group of shooters at a time. The
 * vertices of the coarse mesh are dealt evenly to all blocks; a partition makes the rows dealt to its own blocks.
 */
final class CoarseReceivers {

    private final InitialMesh mesh;
    private final Gatherer receivers;
    private final ParallelFor parallel;
    private final RadiosityNodes nodes;
    /** Vertices of the coarse mesh whose rows are made here. A face with another representative needs no rows. */
    private final int[] asked;

    CoarseReceivers(InitialMesh mesh, List<Block> blocks, Gatherer receivers, ParallelFor parallel) {
        this.mesh = mesh;
        this.receivers = receivers;
        this.parallel = parallel;
        nodes = new RadiosityNodes(mesh.coarse, mesh.clusters.clusters);
        BitSet mine = new BitSet();
        blocks.forEach(block -> mine.set(block.id()));
        asked = IntStream.range(0, nodes.vertices())
                .filter(v -> mesh.representatives.leader(nodes.points().face(v)) == nodes.points().face(v))
                .filter(v -> mine.get((int) ((long) v * mesh.blocks.size() / nodes.vertices()))).toArray();
        receivers.bury(nodes, asked);
    }

    /** @return number of rows, then each row as {@link CoarseRows#take} reads it */
    byte[] rows(Order order) {
        ShooterHierarchy[] all = receivers.shooters(order);
        FormFactorCalculator calculator = mesh.solvesAtOnce() ? receivers.calculators(order)[0]
                : new RayCaster(mesh.bounds, 1, order.rules().tolerance(), 1);
        byte[][] row = new byte[asked.length][];
        parallel.run(row.length, Gatherer.RUN, (from, to) -> rows(from, to, all, calculator, row));
        long size = Integer.BYTES + Arrays.stream(row).mapToLong(bytes -> bytes.length).sum();
        ByteBuffer joined = ByteBuffer.allocate(ArraySize.of("bytes of rows of the coarse system", size));
        joined.putInt(row.length);
        for (byte[] bytes : row) {
            joined.put(bytes);
        }
        return joined.array();
    }

    /** Records shooter by shooter: rays from neighbours to one shooter run alike. */
    private void rows(int from, int to, ShooterHierarchy[] all, FormFactorCalculator calculator, byte[][] row) {
        RowRecorder[] seen = new RowRecorder[to - from];
        Arrays.setAll(seen, i -> new RowRecorder(nodes));
        for (ShooterHierarchy shooter : all) {
            for (int i = from; i < to; i++) {
                if (!nodes.points().isBuried(asked[i])) {
                    receivers.gather(calculator, shooter, nodes, asked[i], 0, seen[i - from]);
                }
            }
        }
        for (int i = from; i < to; i++) {
            row[i] = seen[i - from].row(asked[i]);
        }
    }
}
