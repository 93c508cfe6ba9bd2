package radiosity.partition;

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
import radiosity.protocol.Wire;
import radiosity.setup.InitialMesh;
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
                : new RayCaster(mesh.bounds(), 1, order.rules().tolerance(), 1);
        byte[][] row = new byte[asked.length][];
        parallel.run(row.length, i -> row[i] = row(asked[i], all, calculator));
        return Wire.bytes(out -> {
            out.writeInt(row.length);
            for (byte[] bytes : row) {
                out.write(bytes);
            }
        });
    }

    private byte[] row(int v, ShooterHierarchy[] all, FormFactorCalculator calculator) {
        RowRecorder seen = new RowRecorder();
        for (int i = 0; i < all.length && !nodes.points().isBuried(v); i++) {
            receivers.gather(calculator, all[i], nodes, v, 0, seen);
        }
        return Wire.bytes(out -> {
            out.writeLong(nodes.points().key(v));
            out.writeBoolean(nodes.points().isBuried(v));
            seen.write(nodes, out);
        });
    }
}
