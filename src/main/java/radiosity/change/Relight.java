package radiosity.change;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.GatherSink;
import radiosity.formfactor.LightSources;
import radiosity.formfactor.RayCaster;
import radiosity.formfactor.ShooterHierarchy;
import radiosity.formfactor.VisibilityChange;
import radiosity.mesh.PatchTree;
import radiosity.mesh.Patcher;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.Weights;
import radiosity.partition.Gatherer;
import radiosity.prediction.AmbientLevel;
import radiosity.protocol.BlockState;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.scene.Vec3;
import radiosity.setup.InitialMesh;
import radiosity.util.Aabb;
import radiosity.util.ParallelFor;
import radiosity.visibility.RadiosityBounds;

/**
 * The light of a solution on the elements of an edited scene, before anybody shoots: what has no longer a way is taken
 * back, what has a way now is sent, and what surfaces lack to radiate by their new materials and by that is unshot.
 *
 * <p>All of it is done in the process of the master, and so is the same however the elements are dealt afterwards.
 */
public final class Relight {

    /** Vertices that a thread takes at a time. */
    private static final int RUN = 64;
    /** By what part of its diagonal a box of what has come or gone is larger for surfaces that are cut otherwise. */
    private static final double AROUND = 0.1;

    private final InitialMesh before;
    private final InitialMesh now;
    private final SceneChange change;
    private final ParallelFor parallel;
    private final int channels;
    private final Gatherer gatherer;
    private RadiosityNodes nodes;
    private MeshTransfer transfer;

    public Relight(InitialMesh before, InitialMesh now, SceneChange change, ParallelFor parallel) {
        this.before = before;
        this.now = now;
        this.change = change;
        this.parallel = parallel;
        channels = now.faces.channels();
        gatherer = new Gatherer(now, parallel);
    }

    /**
     * Makes the elements of the later scene.
     *
     * @param blocks    states of the earlier scene's blocks, by id
     * @param isSettled whether what the elements have not shot is only the noise of rays: then it counts as shot
     * @param rules     how closely to look; weights are the earlier scene's
     * @param weight    those of the later scene
     * @return states of the later scene's blocks, by id
     */
    public List<byte[]> blocks(List<byte[]> blocks, boolean isSettled, Order.Rules rules, double[] weight) {
        RadiosityNodes old = MeshTransfer.nodes(before, blocks);
        if (isSettled) {
            settle(old);
        }
        transfer = new MeshTransfer(change, old, rules, before, now);
        nodes = transfer.made;
        bury();
        int[] kept = IntStream.range(0, nodes.vertices())
                .filter(v -> !transfer.fresh.get(v) && !nodes.isBuried(v)).toArray();
        if (change.isOfGeometry()) {
            correct(old, kept, rules);
        }
        if (change.isOfGeometry() || change.isOfLights()) {
            light(kept, new LightSources(before.faces, before.bounds()), -1);
            light(kept, new LightSources(now.faces, now.bounds()), 1);
        }
        int[] fresh = transfer.fresh.stream().filter(v -> !nodes.isBuried(v)).toArray();
        gather(fresh, new Order.Rules(rules.tolerance(), weight, rules.meshError(), new double[0], new double[0]));
        return states();
    }

    private List<byte[]> states() {
        byte[][] states = new byte[now.blocks.size()][];
        parallel.run(states.length, b -> states[b] = BlockState.write(nodes, nodes.tops(now.blocks.get(b))));
        return List.of(states);
    }

    /** All that surfaces radiate counts as shot: the noise by which they differ is nothing to be sent. */
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

    /*---- Which vertices are looked at ----*/

    /** Where nothing has come or gone, a vertex is inside a solid if it was. */
    private void bury() {
        List<Aabb> boxes = change.isOfGeometry() ? change.boxes() : List.of();
        if (change.isOfGeometry()) {
            gatherer.bury(nodes, IntStream.range(0, nodes.vertices()).toArray());
        } else {
            transfer.wasBuried.stream().forEach(nodes::bury);
        }
        transfer.moved.stream().filter(v -> isNear(v, boxes)).forEach(transfer.fresh::set);
        transfer.fresh.or(transfer.wasBuried);
        double[] irradiance = nodes.light().irradiance();
        transfer.fresh.stream().forEach(v -> Arrays.fill(irradiance, channels * v, channels * (v + 1), 0));
    }

    /** Near what has come or gone. */
    private boolean isNear(int v, List<Aabb> boxes) {
        float[] x = nodes.receivers();
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

    /*---- What changes of the light they had ----*/

    private void light(int[] vertices, LightSources lights, double sign) {
        if (lights.isEmpty()) {
            return;
        }
        double[] irradiance = nodes.light().irradiance();
        parallel.run(vertices.length, RUN, (from, to) -> {
            double[] sum = new double[channels];
            for (int i = from; i < to; i++) {
                int v = vertices[i];
                Arrays.fill(sum, 0);
                lights.add(place(v), normal(v), sum, 0);
                for (int c = 0; c < channels; c++) {
                    irradiance[channels * v + c] += sign * sum[c];
                }
            }
        });
    }

    private Vec3 place(int v) {
        float[] x = nodes.receivers();
        return new Vec3(x[3 * v], x[3 * v + 1], x[3 * v + 2]);
    }

    private Vec3 normal(int v) {
        int f = nodes.vertexPlane(v);
        return new Vec3(now.faces.normal(f, 0), now.faces.normal(f, 1), now.faces.normal(f, 2));
    }

    /** Adds what changed visibility makes of all that was shot, and takes back what was shot by what is gone. */
    private void correct(RadiosityNodes old, int[] vertices, Order.Rules rules) {
        boolean[] gone = change.goneFaces();
        ShooterHierarchy[] kept = shooters(old, rules, tree -> !gone[tree.face()]);
        ShooterHierarchy[] vanished = shooters(old, rules, tree -> gone[tree.face()]);
        VisibilityChange visibility = new VisibilityChange(before.bounds(), now.bounds(),
                new RadiosityBounds(change.goneCorners()), new RadiosityBounds(change.comeCorners()), change.boxes());
        FormFactorCalculator[] differences = new FormFactorCalculator[Patcher.MOST_SLACK + 1];
        FormFactorCalculator[] whole = new FormFactorCalculator[differences.length];
        for (int slack = 0; slack < differences.length; slack++) {
            double tolerance = rules.tolerance() * (1 << slack);
            differences[slack] = new RayCaster(visibility, now.rays(), tolerance);
            whole[slack] = new RayCaster(before.bounds(), now.rays(), tolerance);
        }
        double[] irradiance = nodes.light().irradiance();
        parallel.run(vertices.length, RUN, (from, to) -> {
            for (int i = from; i < to; i++) {
                int v = vertices[i];
                int slack = now.patcher.slack(nodes.vertexFace(v));
                GatherSink.Irradiance come = new GatherSink.Irradiance(channels);
                for (ShooterHierarchy shooter : kept) {
                    gatherer.gather(differences[slack], shooter, nodes, v, 0, come);
                }
                GatherSink.Irradiance back = new GatherSink.Irradiance(channels);
                for (ShooterHierarchy shooter : vanished) {
                    gatherer.gather(whole[slack], shooter, nodes, v, 0, back);
                }
                for (int c = 0; c < channels; c++) {
                    irradiance[channels * v + c] += come.value[c] - back.value[c];
                }
            }
        });
    }

    /** Those trees of all shooters that are wanted, with all that they have shot. */
    private ShooterHierarchy[] shooters(RadiosityNodes old, Order.Rules rules, Predicate<PatchTree> wanted) {
        Weights weights = new Weights(before.rooms, channels, rules.weight());
        List<ShooterHierarchy> made = new ArrayList<>();
        for (Shot shot : totals(before, old)) {
            List<PatchTree> trees = shot.trees().stream().filter(wanted).toList();
            if (!trees.isEmpty()) {
                made.add(new ShooterHierarchy(before.faces, trees, weights));
            }
        }
        return made.toArray(ShooterHierarchy[]::new);
    }

    private List<Shot> totals(InitialMesh mesh, RadiosityNodes of) {
        Shot[] shots = new Shot[mesh.blocks.size()];
        parallel.run(shots.length,
                b -> shots[b] = Shot.of(of, of.tops(mesh.blocks.get(b)), 0, of.light()::shot));
        return mesh.clusters.join(List.of(shots), parallel);
    }

    /*---- Vertices that have nothing ----*/

    /** They gather all that was ever shot, along two sets of rays, and get the mean. */
    private void gather(int[] vertices, Order.Rules rules) {
        if (vertices.length == 0) {
            return;
        }
        List<Shot> totals = totals(now, nodes);
        Order order = new Order(Order.Kind.GATHER, totals, new Order.Rules(rules.tolerance(), rules.weight(),
                rules.meshError(), AmbientLevel.of(now, totals), new double[0]), Order.Question.NOTHING);
        double[] irradiance = nodes.light().irradiance();
        for (int turn = 0; turn < 2; turn++) {
            gatherer.gather(order, nodes, vertices, turn);
        }
        for (int v : vertices) {
            for (int i = channels * v; i < channels * (v + 1); i++) {
                irradiance[i] *= 0.5;
            }
        }
        light(vertices, new LightSources(now.faces, now.bounds()), 1);
    }

    /*---- What has become of it ----*/

    /** Flux that surfaces have shot, one per channel, W: that of the elements summed. */
    public double[] shot() {
        double[] sum = new double[channels];
        for (Shot shot : totals(now, nodes)) {
            double[] flux = shot.flux(now.faces);
            for (int c = 0; c < channels; c++) {
                sum[c] += flux[c] * now.faces.size() * now.faces.size();
            }
        }
        return sum;
    }

    /** |U| A summed over elements and channels, W. */
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

    /** Flux of sources without geometry that arrives at the elements, one per channel, W. */
    public double[] lights() {
        LightSources sources = new LightSources(now.faces, now.bounds());
        double[] sum = new double[channels];
        double[] at = new double[channels * nodes.vertices()];
        if (sources.isEmpty()) {
            return sum;
        }
        parallel.run(nodes.vertices(), v -> {
            if (!nodes.isBuried(v)) {
                sources.add(place(v), normal(v), at, channels * v);
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

    /*---- Afterwards ----*/

    /**
     * Has vertices that have received less than nothing gather anew: what was taken back of their light went along
     * other rays than what they had.
     *
     * @param blocks states of all blocks, by id
     * @param order  all that was ever shot
     * @return states of all blocks; empty where no vertex has less than nothing
     */
    public static List<byte[]> mended(InitialMesh mesh, List<byte[]> blocks, Order order, ParallelFor parallel) {
        Relight world = new Relight(mesh, mesh, null, parallel);
        world.nodes = MeshTransfer.nodes(mesh, blocks);
        double[] irradiance = world.nodes.light().irradiance();
        int[] negative = IntStream.range(0, world.nodes.vertices()).filter(v -> !world.nodes.isBuried(v)
                && Arrays.stream(irradiance, world.channels * v, world.channels * (v + 1)).min().orElse(0) < 0)
                .toArray();
        if (negative.length == 0) {
            return List.of();
        }
        for (int v : negative) {
            Arrays.fill(irradiance, world.channels * v, world.channels * (v + 1), 0);
        }
        world.gatherer.gather(order, world.nodes, negative, order.number());
        world.light(negative, new LightSources(mesh.faces, mesh.bounds()), 1);
        for (int v : negative) {
            for (int i = world.channels * v; i < world.channels * (v + 1); i++) {
                irradiance[i] = Math.max(0, irradiance[i]);
            }
        }
        return world.states();
    }
}
