package radiosity.change;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import radiosity.formfactor.LightSources;
import radiosity.mesh.RadiosityNodes;
import radiosity.protocol.Order;
import radiosity.setup.InitialMesh;
import radiosity.util.ParallelFor;

/**
 * Vertices that have received less than nothing, as what was taken back of their light went along other rays than what
 * they had: they gather anew.
 */
public final class NegativeLight {

    private NegativeLight() { }

    /**
     * Has such vertices gather anew.
     *
     * @param blocks states of all blocks, by id
     * @param order  all that was ever shot
     * @return states of all blocks; empty where no vertex has less than nothing
     */
    public static List<byte[]> mended(InitialMesh mesh, List<byte[]> blocks, Order order, ParallelFor parallel) {
        LitMesh lit = LitMesh.of(mesh, blocks, parallel);
        RadiosityNodes nodes = lit.nodes;
        int channels = nodes.channels();
        double[] irradiance = nodes.light().irradiance();
        int[] negative = IntStream.range(0, nodes.vertices()).filter(v -> !nodes.isBuried(v)
                && Arrays.stream(irradiance, channels * v, channels * (v + 1)).min().orElse(0) < 0).toArray();
        if (negative.length == 0) {
            return List.of();
        }
        for (int v : negative) {
            Arrays.fill(irradiance, channels * v, channels * (v + 1), 0);
        }
        lit.gatherer.gather(order, nodes, negative, order.number());
        lit.light(negative, new LightSources(mesh.faces, mesh.bounds()), 1);
        for (int v : negative) {
            for (int i = channels * v; i < channels * (v + 1); i++) {
                irradiance[i] = Math.max(0, irradiance[i]);
            }
        }
        return lit.states();
    }
}
