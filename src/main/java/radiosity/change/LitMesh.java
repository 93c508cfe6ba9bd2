package radiosity.change;

import java.util.Arrays;
import java.util.List;
import radiosity.formfactor.LightSources;
import radiosity.mesh.RadiosityNodes;
import radiosity.partition.Gatherer;
import radiosity.protocol.BlockState;
import radiosity.protocol.Shot;
import radiosity.scene.Vec3;
import radiosity.setup.InitialMesh;
import radiosity.util.ParallelFor;

/** The elements of all blocks of a scene in one process, with their light. */
final class LitMesh {

    /** Number of vertices that a thread processes at a time. */
    private static final int RUN = 64;

    final RadiosityNodes nodes;
    final Gatherer gatherer;
    private final InitialMesh mesh;
    private final ParallelFor parallel;
    private final int channels;

    LitMesh(InitialMesh mesh, RadiosityNodes nodes, ParallelFor parallel) {
        this.mesh = mesh;
        this.nodes = nodes;
        this.parallel = parallel;
        channels = nodes.channels();
        gatherer = new Gatherer(mesh, parallel);
    }

    /** @param blocks state of each block, by block id */
    static LitMesh of(InitialMesh mesh, List<byte[]> blocks, ParallelFor parallel) {
        RadiosityNodes nodes = new RadiosityNodes(mesh.patcher, mesh.blocks);
        for (int b = 0; b < blocks.size(); b++) {
            BlockState.restore(nodes, nodes.tops(mesh.blocks.get(b)), blocks.get(b));
        }
        return new LitMesh(mesh, nodes, parallel);
    }

    /** Returns the state of each block, by block id. */
    List<byte[]> states() {
        byte[][] states = new byte[mesh.blocks.size()][];
        parallel.run(states.length, b -> states[b] = BlockState.write(nodes, nodes.tops(mesh.blocks.get(b))));
        return List.of(states);
    }

    /** Returns one shot per cluster that holds all radiosity its elements have shot so far. */
    List<Shot> totals() {
        Shot[] shots = new Shot[mesh.blocks.size()];
        parallel.run(shots.length,
                b -> shots[b] = Shot.of(nodes, nodes.tops(mesh.blocks.get(b)), 0, nodes.light()::shot));
        return mesh.clusters.join(List.of(shots), parallel);
    }

    /**
     * Adds to the irradiance of vertices the light of sources without geometry, times a factor.
     *
     * @param sources   of this scene or of the other scene
     * @param tolerance irradiance that one ray may carry, relative to the mean
     */
    void light(int[] vertices, LightSources sources, double factor, double tolerance) {
        if (sources.isEmpty()) {
            return;
        }
        double[] irradiance = nodes.light().irradiance();
        float[] x = nodes.points().receivers();
        parallel.run(vertices.length, RUN, (from, to) -> {
            double[] sum = new double[channels];
            for (int i = from; i < to; i++) {
                int v = vertices[i];
                Arrays.fill(sum, 0);
                int plane = nodes.points().plane(v); // of mesh: the scene of the sources may number faces otherwise
                sources.add(new Vec3(x[3 * v], x[3 * v + 1], x[3 * v + 2]), mesh.faces.unitNormal(plane), sum, 0,
                        mesh.skyRays(tolerance, nodes.points().key(v)));
                for (int c = 0; c < channels; c++) {
                    irradiance[channels * v + c] += factor * sum[c];
                }
            }
        });
    }
}
