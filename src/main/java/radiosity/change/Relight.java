package radiosity.change;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.FormFactorCalculators;
import radiosity.formfactor.LightSources;
import radiosity.formfactor.RayCaster;
import radiosity.formfactor.ShooterHierarchy;
import radiosity.formfactor.VisibilityChange;
import radiosity.mesh.PatchTree;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.Weights;
import radiosity.partition.EdgeInterpolation;
import radiosity.prediction.AmbientLevel;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.setup.InitialMesh;
import radiosity.util.Aabb;
import radiosity.util.ParallelFor;
import radiosity.visibility.RadiosityBounds;

/**
 * Transfers the light of a solution to the elements of an edited scene, before any patch shoots: subtracts light whose
 * way is blocked now, adds light whose way is free now, and leaves unshot what surfaces then radiate and have not shot.
 *
 * <p>The process of the master does all of this, so the result does not depend on how blocks are assigned to hosts.
 */
public final class Relight {

    /** Margin around a changed object's box in which vertices of recut faces gather anew, part of the diagonal. */
    private static final double AROUND = 0.1;
    /**
     * Light that a ray may carry which compares both scenes, over the light of other rays: nearly all such rays see the
     * same in both scenes, and only the others add noise.
     */
    private static final double COMPARED = 4;

    private final InitialMesh before;
    private final InitialMesh now;
    private final SceneChange change;
    private final ParallelFor parallel;
    private final BooleanSupplier goOn;
    private final int channels;
    private RadiosityNodes nodes;
    private LitMesh lit;
    private MeshTransfer transfer;

    /** @param goOn asked now and then; where it returns false, methods throw a {@link CancellationException} */
    public Relight(InitialMesh before, InitialMesh now, SceneChange change, ParallelFor parallel,
                   BooleanSupplier goOn) {
        this.before = before;
        this.now = now;
        this.change = change;
        this.parallel = parallel;
        this.goOn = goOn;
        channels = now.faces.channels();
    }

    /**
     * Makes the elements of the later scene.
     *
     * @param blocks    state of each block of the earlier scene, by block id
     * @param isSettled whether the unshot radiosity of the elements is only noise of rays, and so counts as shot
     * @param rules     tolerance of rays and refinement; weights are those of the earlier scene
     * @param weight    weights of the later scene, see {@link Weights}
     * @return state of each block of the later scene, by block id
     * @throws CancellationException where {@code goOn} returned false
     */
    public List<byte[]> blocks(List<byte[]> blocks, boolean isSettled, Order.Rules rules, double[] weight) {
        LitMesh earlier = LitMesh.of(before, blocks, parallel);
        RadiosityNodes old = earlier.nodes;
        if (isSettled) {
            settle(old);
        }
        transfer = new MeshTransfer(change, old, rules, before, now);
        nodes = transfer.made;
        lit = new LitMesh(now, nodes, parallel);
        bury();
        int[] kept = IntStream.range(0, nodes.vertices())
                .filter(v -> !transfer.fresh.get(v) && !nodes.points().isBuried(v)).toArray();
        if (change.isOfGeometry()) {
            correct(earlier, kept, rules, weight);
        }
        if (change.isOfGeometry() || change.isOfLights()) {
            lit.light(kept, new LightSources(before.faces, before.bounds), -1, rules.tolerance());
            lit.light(kept, new LightSources(now.faces, now.bounds), 1, rules.tolerance());
        }
        int[] fresh = transfer.fresh.stream().filter(v -> !nodes.points().isBuried(v)).toArray();
        gather(fresh, rules, weight);
        lit.gatherer.findBright(nodes, weight);
        return lit.states();
    }

    /** Marks all radiosity leaving the elements as shot: the rest is noise of rays and need not be sent. */
    private static void settle(RadiosityNodes old) {
        double[] leaving = new double[3 * old.channels()];
        for (int node = 0; node < old.nodes(); node++) {
            if (old.isElement(node)) {
                old.light().leaving(node, leaving, 0);
                for (int i = 0; i < leaving.length; i++) {
                    old.light().setShot(node, i / old.channels(), i % old.channels(), leaving[i]);
                }
            }
        }
    }

    /*---- Vertices that gather anew ----*/

    /**
     * Marks vertices inside solids: as in the earlier scene where no geometry has changed. Clears the light of vertices
     * that gather anew.
     */
    private void bury() {
        List<Aabb> boxes = change.isOfGeometry() ? change.boxes() : List.of();
        if (change.isOfGeometry()) {
            lit.gatherer.bury(nodes, IntStream.range(0, nodes.vertices()).toArray());
        } else {
            transfer.wasBuried.stream().forEach(nodes.points()::bury);
        }
        transfer.moved.stream().filter(v -> isNear(v, boxes)).forEach(transfer.fresh::set);
        transfer.fresh.or(transfer.wasBuried);
        double[] irradiance = nodes.light().irradiance();
        transfer.fresh.stream().forEach(v -> Arrays.fill(irradiance, channels * v, channels * (v + 1), 0));
    }

    /** Whether a vertex lies near an object that has come or gone. */
    private boolean isNear(int v, List<Aabb> boxes) {
        float[] x = nodes.points().receivers();
        for (Aabb box : boxes) {
            double far = AROUND * box.diagonal();
            boolean isInside = true;
            for (int a = 0; a < 3; a++) {
                isInside &= x[3 * v + a] >= box.low().coordinate(a) - far
                        && x[3 * v + a] <= box.high().coordinate(a) + far;
            }
            if (isInside) {
                return true;
            }
        }
        return false;
    }

    /*---- Corrections of transferred light ----*/

    /** Adds the effect of changed visibility on all light shot, and subtracts the light shot by removed surfaces. */
    private void correct(LitMesh old, int[] vertices, Order.Rules rules, double[] weight) {
        boolean[] gone = change.goneFaces();
        ShooterHierarchy[] kept = shooters(old, rules, tree -> !gone[tree.face()]);
        ShooterHierarchy[] vanished = shooters(old, rules, tree -> gone[tree.face()]);
        VisibilityChange visibility = new VisibilityChange(before.bounds, now.bounds,
                new RadiosityBounds(change.goneCorners()), new RadiosityBounds(change.comeCorners()), change.boxes());
        FormFactorCalculator[] differences = FormFactorCalculators.perSlack(rules.tolerance(),
                tolerance -> new RayCaster(visibility, now.rays(), COMPARED * tolerance));
        FormFactorCalculator[] whole = FormFactorCalculators.perSlack(rules.tolerance(),
                tolerance -> new RayCaster(before.bounds, now.rays(), tolerance));
        EdgeInterpolation interpolation = new EdgeInterpolation(now, lit.gatherer, nodes, parallel);
        Order.Rules later = new Order.Rules(rules.tolerance(), weight, rules.meshError());
        interpolation.add(kept, differences, later, 1, vertices, 0, (run, nanoseconds) -> checkWanted());
        interpolation.add(vanished, whole, later, -1, vertices, 0, (run, nanoseconds) -> checkWanted());
    }

    /** Returns shooters with all radiosity shot so far, restricted to the wanted trees. */
    private ShooterHierarchy[] shooters(LitMesh old, Order.Rules rules, Predicate<PatchTree> wanted) {
        Weights weights = new Weights(before.rooms, channels, rules.weight());
        List<ShooterHierarchy> made = new ArrayList<>();
        for (Shot shot : old.totals()) {
            List<PatchTree> trees = shot.trees().stream().filter(wanted).toList();
            if (!trees.isEmpty()) {
                made.add(new ShooterHierarchy(before.faces, trees, weights));
            }
        }
        return made.toArray(ShooterHierarchy[]::new);
    }

    /*---- Vertices without light ----*/

    /** Gathers all light shot so far at some vertices, along two sets of rays: the mean is the irradiance. */
    private void gather(int[] vertices, Order.Rules rules, double[] weight) {
        if (vertices.length == 0) {
            return;
        }
        List<Shot> totals = lit.totals();
        Order order = new Order(Order.Kind.GATHER, totals, new Order.Rules(rules.tolerance(), weight,
                rules.meshError(), AmbientLevel.of(now, totals)), Order.Question.NOTHING);
        double[] irradiance = nodes.light().irradiance();
        for (int turn = 0; turn < 2; turn++) {
            checkWanted();
            lit.gatherer.gather(order, nodes, vertices, turn);
        }
        for (int v : vertices) {
            for (int i = channels * v; i < channels * (v + 1); i++) {
                irradiance[i] *= 0.5;
            }
        }
        lit.light(vertices, new LightSources(now.faces, now.bounds), 1, rules.tolerance());
    }

    private void checkWanted() {
        if (!goOn.getAsBoolean()) {
            throw new CancellationException("change: ended before its end");
        }
    }

    /*---- Sums over the elements ----*/

    /** Returns the flux that all elements have shot, one per channel, W. */
    public double[] shot() {
        double[] sum = new double[channels];
        for (Shot shot : lit.totals()) {
            double[] flux = shot.flux(now.faces);
            for (int c = 0; c < channels; c++) {
                sum[c] += flux[c] * now.faces.size() * now.faces.size();
            }
        }
        return sum;
    }

    /** Returns the sum of |U| A over elements and channels, W. */
    public double unshot() {
        double squared = now.faces.size() * now.faces.size();
        double[] values = new double[3 * channels];
        double sum = 0;
        for (int node = 0; node < nodes.nodes(); node++) {
            if (nodes.isElement(node)) {
                nodes.light().unshot(node, values, 0);
                for (double value : values) {
                    sum += Math.abs(value) * nodes.area(node) * squared / 3;
                }
            }
        }
        return sum;
    }

    /** Returns the flux of sources without geometry that arrives at the elements, one per channel, W. */
    public double[] lights() {
        LightSources sources = new LightSources(now.faces, now.bounds);
        double[] sum = new double[channels];
        double[] at = new double[channels * nodes.vertices()];
        if (sources.isEmpty()) {
            return sum;
        }
        parallel.run(nodes.vertices(), v -> {
            if (!nodes.points().isBuried(v)) {
                sources.add(nodes.points().receivers(), 3 * v, nodes.points().plane(v), at, channels * v,
                        now.skyRays(now.tolerance(), nodes.points().key(v)));
            }
        });
        double squared = now.faces.size() * now.faces.size();
        for (int node = 0; node < nodes.nodes(); node++) {
            for (int i = 0; i < 3 * channels && nodes.isElement(node); i++) {
                sum[i % channels] += at[channels * nodes.corner(node, i / channels) + i % channels]
                        * nodes.area(node) * squared / 3;
            }
        }
        return sum;
    }
}
