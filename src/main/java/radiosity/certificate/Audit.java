package radiosity.certificate;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.function.LongFunction;
import java.util.stream.IntStream;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.FormFactorCalculators;
import radiosity.formfactor.GatherSink;
import radiosity.formfactor.LightSources;
import radiosity.formfactor.ShooterHierarchy;
import radiosity.mesh.PatchTree;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.UniformRadiosity;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.protocol.BlockState;
import radiosity.protocol.Order;
import radiosity.protocol.Partitions;
import radiosity.protocol.Shot;
import radiosity.settings.Accuracy;
import radiosity.setup.InitialMesh;
import radiosity.solution.Certificate;
import radiosity.solution.EnergyLedger;
import radiosity.util.ParallelFor;
import radiosity.util.R2;

/** Estimates the error of a solution by gathering its light anew at points of every surface: a {@link Certificate}. */
public final class Audit {

    /**
     * Number of points per batch: one per this number of elements, within the least and the most; a few more where a
     * scene has many surfaces, as each has points of its own.
     */
    private static final int ELEMENTS_PER_POINT = 20;
    private static final int LEAST_POINTS = 960;
    private static final int MOST_POINTS = 6000;
    /** Number of rounds after which the same points would be chosen again. */
    private static final int ROUNDS = 100_000;
    /**
     * Where each batch begins within the sampling step, as a fraction of the step. The second batch is added where the
     * relative standard error of the mean square error is above {@link #ENOUGH}, see {@link #certificate}.
     */
    private static final double[] START = {0.5, 0};
    private static final double ENOUGH = 0.3;
    /** The limit where the error exceeds the one asked for: the excess says how much finer the mesh must be. */
    private static final double ENOUGH_TO_REFINE = 0.15;
    /** Standard errors by which the mean square error must differ from the square of the error asked for. */
    private static final double CLEAR = 2;
    /**
     * Unshot flux, relative to the emitted flux, above which a calculation counts as only begun: nearly all of its
     * error is then unshot flux, for which the least number of points is enough.
     */
    private static final double MOSTLY = 0.5;
    /** Number of elements whose light is gathered at a time; all points are sent with each of these orders. */
    private static final int ELEMENTS_AT_A_TIME = 64_000;
    /** Form factor that a ray may carry where sums of form factors are calculated. */
    private static final double FACTOR_TOLERANCE = 0.05;
    /** Number of other patches with which the patch of each point is compared for reciprocity. */
    private static final int PARTNERS = 2;
    /** Weight of an emitter in the mean radiosity of a room, relative to a surface that does not emit. */
    private static final double NOTHING = 1e-9;

    private final InitialMesh mesh;
    private final Partitions partitions;
    private final Faces faces;
    private final List<byte[]> states;
    private final EnergyLedger ledger;
    /** Relative error of radiosity that the user asks for. */
    private final double asked;
    private final ParallelFor parallel;
    private final AuditPlaces places;
    private final NearbyPoints nearby;
    private final boolean isBegun;
    private final int wanted;
    private final List<AuditPoint> points = new ArrayList<>();
    private int batches;
    /** The points combined, after {@link #certificate}. */
    private AuditResult result;
    private final int round;
    /** Number of points that earlier audits may have used, but for the few more that many surfaces ask for. */
    private final int used;

    /**
     * @param partitions which gather light at the audit's points
     * @param states     encoded state of each block, by block id
     * @param ledger     flux at the time of the states
     * @param elements   number of elements in the scene
     * @param asked      relative error of radiosity that is asked for
     * @param round      number of rounds so far: after other rounds, other points are chosen, so that points by which
     *                   the mesh was divided do not tell how well it is divided
     */
    public Audit(InitialMesh mesh, Partitions partitions, List<byte[]> states, EnergyLedger ledger, int elements,
                 double asked, int round, ParallelFor parallel) {
        this.partitions = partitions;
        this.round = round;
        used = round % ROUNDS * START.length * MOST_POINTS;
        this.mesh = mesh;
        this.states = states;
        this.ledger = ledger;
        faces = mesh.faces;
        this.asked = asked;
        this.parallel = parallel;
        places = new AuditPlaces(mesh, this::nodes, reflected(), leaving(), parallel);
        nearby = new NearbyPoints(faces, mesh.bounds, places);
        isBegun = Arrays.stream(ledger.unshot()).map(Math::abs).sum()
                > MOSTLY * Arrays.stream(ledger.emitted()).sum();
        wanted = isBegun ? LEAST_POINTS
                : Math.max(LEAST_POINTS, Math.min(MOST_POINTS, elements / ELEMENTS_PER_POINT));
    }

    private RadiosityNodes nodes(int block) {
        return BlockState.nodes(mesh.patcher, mesh.blocks.get(block), states.get(block));
    }

    /** Returns the mean reflected radiosity, one per channel, W/m²; a black scene has a small positive one. */
    private double[] reflected() {
        double[] mean = new double[faces.channels()];
        Arrays.setAll(mean, c -> Math.max(Faces.LEAST_IMPORTANCE * ledger.received()[c],
                ledger.received()[c] - ledger.absorbed()[c]) / (faces.area() * faces.size() * faces.size()));
        return mean;
    }

    /** Returns the mean radiosity that leaves surfaces, emitted or reflected, one per channel, W/m². */
    private double[] leaving() {
        double[] mean = new double[faces.channels()];
        Arrays.setAll(mean, c -> ledger.shot()[c] / (faces.area() * faces.size() * faces.size()));
        return mean;
    }

    /*---- Gathering anew ----*/

    /**
     * Adds batches of points while a few points make up most of the error, while the error may lie on either side of
     * the error asked for, or while it exceeds the error asked for by no more than the uncertainty of its bias.
     *
     * @param unshotFlux flux not shot yet, all channels, W
     */
    public Certificate certificate(double unshotFlux) throws IOException {
        List<AuditPoint> first = places.pick(wanted, start(0), used);
        UniformRadiosity ambient = ambient(first);
        gatherBatch(first, ambient);
        result = result();
        while (!isBegun && batches < START.length && !isClear()) {
            gatherBatch(places.pick(wanted, start(batches), used + points.size()), ambient);
            result = result();
        }
        return result.certificate(unshotFlux, reciprocity());
    }

    /**
     * The elements on which a point of the {@link #certificate}, which must precede this call, errs by more than
     * interpolation on one element may.
     *
     * @param meshError largest error times square root of the share of area that an element may have, above 0
     */
    public Marked marked(double meshError) {
        return result.marked(meshError);
    }

    /** Where a batch begins within the sampling step: elsewhere after each round. */
    private double start(int batch) {
        return (START[batch] + R2.u(round)) % 1;
    }

    private boolean isClear() {
        double uncertainty = result.uncertainty();
        double found = result.expected() * result.expected();
        double doubt = result.biasUncertainty() * result.biasUncertainty();
        double enough = result.expected() > asked ? ENOUGH_TO_REFINE : ENOUGH;
        return uncertainty <= enough && Math.abs(found - asked * asked) >= CLEAR * uncertainty * found
                && (found <= asked * asked || found - doubt > asked * asked);
    }

    private AuditResult result() {
        return new AuditResult(mesh, points, batches, ledger);
    }

    private void gatherBatch(List<AuditPoint> batch, UniformRadiosity ambient) throws IOException {
        LightSources lights = new LightSources(faces, mesh.bounds);
        List<NearbyPoints.Near> near = nearby.around(batch);
        LongFunction<LightSources.SkyRays> rays = key -> mesh.skyRays(Accuracy.tolerance(asked), key);
        parallel.run(near.size(), i -> near.get(i).point().light(lights, ambient, rays));
        parallel.run(batch.size(), i -> {
            AuditPoint point = batch.get(i);
            point.light(lights, ambient, rays);
            point.lost = point.isBuried ? 1 : mesh.rooms.room(point.face) >= 0 ? 0
                    : mesh.escaping.share(point.place, point.face, point.number);
        });
        gather(batch, near, ambient);
        points.addAll(batch);
        batches++;
    }

    /** Returns a radiosity per closed room: about the mean over its points, without emitters if it has others. */
    private UniformRadiosity ambient(List<AuditPoint> some) {
        int channels = faces.channels();
        double[] sum = new double[channels * mesh.rooms.count()];
        double[] area = new double[mesh.rooms.count()];
        for (AuditPoint point : some) {
            int room = mesh.rooms.room(point.face);
            if (room >= 0) {
                double its = point.emits() ? NOTHING * point.area : point.area;
                area[room] += its;
                for (int c = 0; c < channels; c++) {
                    sum[channels * room + c] += its * point.had(c);
                }
            }
        }
        for (int i = 0; i < sum.length; i++) {
            sum[i] = area[i / channels] > 0 ? sum[i] / area[i / channels] : 0;
        }
        return new UniformRadiosity(mesh.rooms, channels, sum);
    }

    /** Has partitions gather the light of all elements, and the form factors to all elements, at a batch. */
    private void gather(List<AuditPoint> batch, List<NearbyPoints.Near> near, UniformRadiosity ambient)
            throws IOException {
        Weights weights = Weights.of(weight());
        AuditGather light = new AuditGather();
        AuditGather factors = new AuditGather();
        for (AuditPoint point : batch) {
            if (!point.isBuried) {
                int bright = point.bright(weights);
                point.gather(light, bright);
                if (point.isDetailed) {
                    point.gatherAtVertex(light, bright);
                    point.gatherFactors(factors);
                }
            }
        }
        for (NearbyPoints.Near at : near) {
            at.point().gather(light, at.point().bright(weights), at.time());
        }
        int corners = 3 * faces.channels();
        gather(light, new Order.Rules(Accuracy.tolerance(asked), weights.value(), 0, ambient.level()),
                nodes -> nodes.light()::leaving);
        gather(factors, new Order.Rules(FACTOR_TOLERANCE, ones(faces.channels()), 0), nodes -> (element, values, at) ->
                Arrays.fill(values, at, at + corners, isVisible(nodes, element) ? 1 : 0));
    }

    /** Has partitions gather at some places what all elements send, in orders of some clusters each. */
    private void gather(AuditGather gather, Order.Rules rules, Function<RadiosityNodes, PatchTree.Quantity> sent)
            throws IOException {
        if (gather.isEmpty()) {
            return;
        }
        Order.Question question = new Order.Question.Irradiance(gather.points(places.elements()));
        partitions.ask(clusters().stream()
                .map(some -> new Order(Order.Kind.GATHER_AT, shots(some, sent), rules, question)).iterator(),
                (order, answers) -> gather.take(answers), parallel.goOn());
    }

    /** The numbers of all clusters, in runs of about {@link #ELEMENTS_AT_A_TIME} elements. */
    private List<int[]> clusters() {
        int[] elements = places.elements();
        List<int[]> runs = new ArrayList<>();
        int from = 0;
        int some = 0;
        for (int cluster = 0; cluster < mesh.clusters.clusters.size(); cluster++) {
            some += mesh.clusters.blocks(cluster).stream().mapToInt(block -> elements[block.id()]).sum();
            if (some >= ELEMENTS_AT_A_TIME || cluster == mesh.clusters.clusters.size() - 1) {
                runs.add(IntStream.rangeClosed(from, cluster).toArray());
                from = cluster + 1;
                some = 0;
            }
        }
        return runs;
    }

    /** One shot per cluster: what its elements send. */
    private List<Shot> shots(int[] some, Function<RadiosityNodes, PatchTree.Quantity> sent) {
        Shot[] shots = new Shot[some.length];
        parallel.run(some.length, i -> shots[i] = mesh.clusters.join(some[i],
                mesh.clusters.blocks(some[i]).stream().map(block -> {
                    RadiosityNodes nodes = nodes(block.id());
                    return mesh.rounding.finely(Shot.of(nodes, nodes.tops(), 0, sent.apply(nodes)));
                }).toList()));
        return List.of(shots);
    }

    /** Whether an element has a corner that lies outside of solids, and that no surface in the same place covers. */
    private static boolean isVisible(RadiosityNodes nodes, int element) {
        return IntStream.range(0, 3).anyMatch(k -> !nodes.points().isBuried(nodes.corner(element, k)));
    }

    private FormFactorCalculator factors() {
        return FormFactorCalculators.make(mesh.settings.factors(), mesh.bounds, mesh.rays(), FACTOR_TOLERANCE);
    }

    private static double[] ones(int count) {
        double[] ones = new double[count];
        Arrays.fill(ones, 1);
        return ones;
    }

    /** Returns 1 / mean reflected radiosity, one per channel, m²/W; 0 in a channel without light. */
    private double[] weight() {
        return Arrays.stream(reflected()).map(mean -> mean > 0 ? 1 / mean : 0).toArray();
    }

    /*---- Reciprocity: area times form factor from one patch to another, compared with the opposite direction ----*/

    private double reciprocity() {
        List<AuditPoint> seen = points.stream().filter(p -> p.isDetailed && !p.isBuried).toList();
        double[] difference = new double[PARTNERS * seen.size()];
        double[] sum = new double[difference.length];
        parallel.run(difference.length, i -> {
            AuditPoint p = seen.get(i / PARTNERS);
            AuditPoint q = seen.get((i / PARTNERS + seen.size() / (2 + i % PARTNERS)) % seen.size());
            double there = exchange(p, q);
            double back = exchange(q, p);
            difference[i] = p.area * q.area * Math.abs(there - back);
            sum[i] = p.area * q.area * (there + back) / 2;
        });
        double all = Arrays.stream(sum).sum();
        return all == 0 ? 0 : Arrays.stream(difference).sum() / all;
    }

    /** Area of one point's patch times its form factor to another's, as a mean over three points of the patch. */
    private double exchange(AuditPoint from, AuditPoint to) {
        PatchTree tree = new PatchTree(to.face, to.top, new int[] {-1}, ones(3 * faces.channels()));
        ShooterHierarchy shooter = new ShooterHierarchy(faces, List.of(tree), Weights.of(ones(faces.channels())));
        float[] corner = faces.corners(from.face, from.top);
        GatherSink.Irradiance sum = new GatherSink.Irradiance(faces.channels());
        for (int k = 0; k < 3; k++) {
            double[] weight = {1 / 6.0, 1 / 6.0, 1 / 6.0};
            weight[k] = 2 / 3.0;
            float[] x = AuditPlaces.within(corner, weight);
            factors().gather(x[0], x[1], x[2], faces.normal(from.face, 0), faces.normal(from.face, 1),
                    faces.normal(from.face, 2), k, shooter, sum);
        }
        return sum.value[0] / 3 * faces.area(from.face, from.top);
    }
}
