package radiosity.partition;

import java.util.Arrays;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.GatherSink;
import radiosity.formfactor.ShooterHierarchy;
import radiosity.mesh.Patcher;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.Weights;
import radiosity.protocol.Order;
import radiosity.setup.InitialMesh;
import radiosity.util.ParallelFor;

/**
 * Gathers light at vertices of a mesh that is divided already: the middle of an edge takes the mean of what the edge's
 * ends receive of a shooter where both receive nearly the same, as most shooters are far from most edges of a finely
 * divided mesh. Which edges, see {@link EdgeMiddles}.
 */
public final class EdgeInterpolation {

    /**
     * Largest difference between the light that the two ends of an edge receive of a shooter at which the edge's middle
     * takes the mean of the ends: as a part of the light that one ray may carry.
     */
    private static final double ALIKE = 0.125;

    private final InitialMesh mesh;
    private final Gatherer gatherer;
    private final RadiosityNodes nodes;
    private final ParallelFor parallel;
    private final int channels;
    private final EdgeMiddles middles;
    /**
     * Whether patches shoot as clusters, and light is not reflected so often that an error of interpolation would be
     * multiplied.
     */
    private final boolean interpolates;

    /** @param nodes the mesh, which may be divided later; its irradiance is added to */
    public EdgeInterpolation(InitialMesh mesh, Gatherer gatherer, RadiosityNodes nodes, ParallelFor parallel) {
        this.mesh = mesh;
        this.gatherer = gatherer;
        this.nodes = nodes;
        this.parallel = parallel;
        channels = nodes.channels();
        middles = new EdgeMiddles(nodes, mesh.patcher);
        interpolates = mesh.shootsClusters() && !mesh.rounding.exact();
    }

    /** Whether an order's light may be interpolated: where patches shoot, not where vertices tell where to divide. */
    boolean isFor(Order order) {
        return order.kind() == Order.Kind.SHOOT && interpolates;
    }

    /**
     * Adds to the irradiance of some vertices the light of some shooters times a factor.
     *
     * @param calculators one per value of {@link Patcher#slack}
     * @param rules       weights, and the light that one ray may carry
     * @param turn        0, or another number whenever the rays are to take other directions
     * @param costs       receives the processor time
     */
    public void add(ShooterHierarchy[] shooters, FormFactorCalculator[] calculators, Order.Rules rules, double factor,
            int[] vertices, int turn, Gatherer.Costs costs) {
        double[] irradiance = nodes.light().irradiance();
        double[] received = new double[channels * nodes.vertices()];
        int[][] waves = interpolates ? middles.waves(vertices) : new int[][] {vertices};
        double alike = ALIKE * rules.tolerance();
        Weights weights = new Weights(mesh.rooms, channels, rules.weight());
        for (ShooterHierarchy shooter : shooters) {
            for (int[] wave : waves) {
                parallel.run(wave.length, Gatherer.RUN, (from, to) -> {
                    int[] run = Arrays.copyOfRange(wave, from, to);
                    long begin = BlockCosts.now();
                    receive(shooter, calculators, alike, weights, run, turn, received);
                    costs.add(run, BlockCosts.now() - begin);
                });
            }
            for (int v : vertices) {
                for (int i = channels * v; i < channels * (v + 1); i++) {
                    irradiance[i] += factor * received[i];
                }
            }
        }
    }

    /**
     * @param alike    largest difference of weighted light between ends that receive alike, where the slack is 0
     * @param received modified: channels per vertex, what vertices receive of this shooter, W/m²
     */
    private void receive(ShooterHierarchy shooter, FormFactorCalculator[] calculators, double alike, Weights weights,
            int[] run, int turn, double[] received) {
        GatherSink.Irradiance sum = new GatherSink.Irradiance(channels);
        for (int v : run) {
            if (nodes.points().isBuried(v)) {
                continue;
            }
            int face = nodes.points().face(v);
            int slack = gatherer.slack(nodes, v);
            if (interpolates && areEndsAlike(v, weights, face, alike * (1 << slack), received)) {
                for (int c = 0; c < channels; c++) {
                    received[channels * v + c] = (received[channels * middles.end(v, 0) + c]
                            + received[channels * middles.end(v, 1) + c]) / 2;
                }
            } else {
                Arrays.fill(sum.value, 0);
                gatherer.gather(calculators[slack], shooter, nodes, v, turn, sum);
                System.arraycopy(sum.value, 0, received, channels * v, channels);
            }
        }
    }

    private boolean areEndsAlike(int v, Weights weights, int face, double alike, double[] received) {
        int p = middles.end(v, 0);
        int q = middles.end(v, 1);
        boolean areAlike = p >= 0 && !nodes.points().isBuried(p) && !nodes.points().isBuried(q);
        for (int c = 0; c < channels && areAlike; c++) {
            double difference = received[channels * p + c] - received[channels * q + c];
            areAlike = Math.abs(difference) * weights.at(face, c) <= alike;
        }
        return areAlike;
    }
}
