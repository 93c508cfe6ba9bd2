package radiosity.partition;

import java.util.Arrays;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.FormFactorCalculators;
import radiosity.formfactor.GatherSink;
import radiosity.formfactor.RayCaster;
import radiosity.formfactor.ShooterHierarchy;
import radiosity.mesh.BrightVertices;
import radiosity.mesh.Patcher;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.UniformRadiosity;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.protocol.Order;
import radiosity.setup.InitialMesh;
import radiosity.util.Hash;
import radiosity.util.ParallelFor;

/** Gathers light at the vertices of a mesh: adds to their irradiance the light that an order's shooters send there. */
public final class Gatherer {

    /** Largest number of neighbouring vertices that a thread takes at a time. */
    static final int RUN = 64;

    private final InitialMesh mesh;
    private final Faces faces;
    private final ParallelFor parallel;

    public Gatherer(InitialMesh mesh, ParallelFor parallel) {
        this.mesh = mesh;
        this.parallel = parallel;
        faces = mesh.faces;
    }

    /** Marks the vertices from {@code first} on that lie inside a solid as buried. */
    void bury(RadiosityNodes nodes, int first) {
        parallel.run(nodes.vertices() - first, RUN,
                (from, to) -> mesh.interior.markBuried(nodes, first + from, first + to));
    }

    /** Marks those of the given vertices that lie inside a solid as buried; the array is not modified. */
    public void bury(RadiosityNodes nodes, int[] vertices) {
        parallel.run(vertices.length, i -> mesh.interior.markBuried(nodes, vertices[i], vertices[i] + 1));
    }

    UniformRadiosity ambient(Order order) {
        return new UniformRadiosity(mesh.rooms, faces.channels(), order.rules().ambient());
    }

    Weights weights(Order order) {
        return new Weights(mesh.rooms, faces.channels(), order.rules().weight());
    }

    ShooterHierarchy[] shooters(Order order) {
        UniformRadiosity ambient = ambient(order);
        Weights weights = weights(order);
        ShooterHierarchy[] made = new ShooterHierarchy[order.shots().size()];
        parallel.run(made.length, i -> made[i] = order.shots().get(i).shooter(faces, weights, ambient));
        return made;
    }

    /** One calculator per value of {@link Patcher#slack}. */
    FormFactorCalculator[] calculators(Order order) {
        return FormFactorCalculators.perSlack(order.rules().tolerance(), tolerance -> order.rules().sparing()
                ? RayCaster.sparing(mesh.bounds, mesh.rays(), tolerance)
                : FormFactorCalculators.make(mesh.settings.factors(), mesh.bounds, mesh.rays(), tolerance));
    }

    /**
     * Adds to the irradiance of some vertices all the light of an order: its shots and its ambient light.
     *
     * @param turn 0, or another number whenever the rays are to take other directions
     */
    public void gather(Order order, RadiosityNodes nodes, int[] vertices, int turn) {
        gather(work(order), nodes, vertices, turn, (run, nanoseconds) -> { });
    }

    /** An order with its shooters and calculators, made once for both parts of a gathering. */
    record Work(Order order, ShooterHierarchy[] shooters, FormFactorCalculator[] calculators) { }

    Work work(Order order) {
        return new Work(order, shooters(order), calculators(order));
    }

    /** Receives the processor time of gathering at some neighbouring vertices, ns. */
    public interface Costs {
        void add(int[] run, long nanoseconds);
    }

    /** Gathers shooter by shooter at runs of neighbouring vertices: rays from neighbours to one shooter run alike. */
    void gather(Work work, RadiosityNodes nodes, int[] vertices, int turn, Costs costs) {
        receiveAmbient(work.order, nodes, vertices);
        parallel.run(vertices.length, RUN, (from, to) -> {
            int[] run = Arrays.copyOfRange(vertices, from, to);
            long begin = BlockCosts.now();
            for (ShooterHierarchy shooter : work.shooters) {
                gather(work.calculators, shooter, nodes, run, turn);
            }
            costs.add(run, BlockCosts.now() - begin);
        });
    }

    /**
     * Adds to the irradiance of some vertices the uniform light of closed rooms, and gives back the part of their
     * earlier irradiance that rays had lost. Does nothing where the round has begun: each round does it once.
     */
    void receiveAmbient(Order order, RadiosityNodes nodes, int[] vertices) {
        UniformRadiosity ambient = ambient(order);
        double[] back = order.rules().givenBack();
        if (order.begun() || ambient.isDark() && back.length == 0) {
            return;
        }
        int channels = faces.channels();
        for (int v : vertices) {
            for (int c = 0; c < channels && !nodes.points().isBuried(v); c++) {
                double before = nodes.light().irradiance()[channels * v + c];
                nodes.light().irradiance()[channels * v + c] = before * (1 + (back.length == 0 ? 0 : back[c]))
                        + ambient.at(nodes.points().face(v), c);
            }
        }
    }

    /**
     * Finds the bright vertices, see {@link BrightVertices}; none in white rooms, where rays must be the same in every
     * round.
     *
     * @param weight see {@link Weights}
     */
    public void findBright(RadiosityNodes nodes, double[] weight) {
        if (!mesh.rounding.exact()) {
            BrightVertices.find(nodes, new Weights(mesh.rooms, faces.channels(), weight));
        }
    }

    /** Powers of two by which the light that one ray may carry to a vertex is raised: the index of its calculator. */
    int slack(RadiosityNodes nodes, int v) {
        return Math.min(Patcher.MOST_SLACK, mesh.patcher.slack(nodes.points().face(v)) + nodes.points().bright(v));
    }

    /**
     * Adds to the irradiance of some neighbouring vertices the light of one shooter; buried vertices receive nothing.
     *
     * @param calculator one per {@link Patcher#slack}
     */
    private void gather(FormFactorCalculator[] calculator, ShooterHierarchy shooter, RadiosityNodes nodes, int[] run,
            int turn) {
        int channels = faces.channels();
        double[] irradiance = nodes.light().irradiance();
        GatherSink.Irradiance sum = new GatherSink.Irradiance(channels);
        for (int v : run) {
            if (!nodes.points().isBuried(v)) {
                System.arraycopy(irradiance, channels * v, sum.value, 0, channels);
                gather(calculator[slack(nodes, v)], shooter, nodes, v, turn, sum);
                System.arraycopy(sum.value, 0, irradiance, channels * v, channels);
            }
        }
    }

    /** Reports to {@code sum} the light that one vertex receives of one shooter; {@code turn} as for many vertices. */
    public void gather(FormFactorCalculator calculator, ShooterHierarchy shooter, RadiosityNodes nodes, int v, int turn,
            GatherSink sum) {
        float[] x = nodes.points().receivers();
        int f = nodes.points().plane(v);
        calculator.gather(x[3 * v], x[3 * v + 1], x[3 * v + 2],
                faces.normal(f, 0), faces.normal(f, 1), faces.normal(f, 2),
                turn == 0 ? nodes.points().key(v) : Hash.mix(nodes.points().key(v), turn), shooter, sum);
    }
}
