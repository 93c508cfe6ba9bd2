package radiosity.partition;

import java.io.DataInputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import radiosity.formfactor.LightSources;
import radiosity.mesh.Block;
import radiosity.mesh.PatchTree;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.face.Faces;
import radiosity.protocol.Answer;
import radiosity.protocol.BlockState;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.protocol.Wire;
import radiosity.setup.InitialMesh;
import radiosity.util.Hash;
import radiosity.util.ParallelFor;

/**
 * A partition in this process (section 4.5.5 of the paper).
 *
 * <p>Its threads share out runs of neighbouring vertices, then shooters. Gathering at a vertex reads only the vertex,
 * the ends of the edge whose middle it is, the shots and the original triangles, so the result depends neither on the
 * threads nor on how blocks are dealt.
 */
public final class PartitionImpl implements Partition {

    private final InitialMesh mesh;
    private final Faces faces;
    private final int channels;
    private final List<Block> mine;
    private final ParallelFor parallel;
    private final Gatherer receivers;
    private final LightSources lights;
    private final AdaptiveMeshing meshing;
    private final RadiosityNodes nodes;
    private final BlockCosts costs;
    /** 1 array per shooter, of its top nodes: all of a block where clusters shoot, else a single patch. */
    private final int[][] shooters;
    /** Top nodes of the blocks, by the subtree of a cluster that contains them. */
    private final Map<Shot.Place, List<Integer>> parts;
    private final Candidates candidates;
    private final GhostVertices ghosts;
    private final EdgeInterpolation interpolation;
    /** Work to be finished by {@link Order.Kind#REST}; null where there is none. */
    private Gatherer.Work rest;
    /** Receivers of the coarse mesh while their rows are made; else null. */
    private CoarseReceivers coarse;

    /** @param restored whether {@link #restore} will set all blocks, so no buried vertices or first light are needed */
    public PartitionImpl(InitialMesh mesh, List<Block> mine, ParallelFor parallel, boolean restored) {
        this.mesh = mesh;
        this.mine = mine;
        faces = mesh.faces;
        channels = faces.channels();
        this.parallel = parallel;
        receivers = new Gatherer(mesh, parallel);
        meshing = new AdaptiveMeshing(mesh.settings.meshing());
        lights = new LightSources(faces, mesh.bounds);
        nodes = new RadiosityNodes(mesh.patcher, mine);
        costs = new BlockCosts(nodes, mine);
        shooters = mesh.shootsClusters() ? mine.stream().map(nodes::tops).toArray(int[][]::new) : patches();
        parts = mesh.clusters.parts(nodes);
        candidates = new Candidates(mesh, nodes, shooters, parallel);
        ghosts = new GhostVertices(nodes);
        interpolation = new EdgeInterpolation(mesh, receivers, nodes, parallel);
        if (!restored) {
            receivers.bury(nodes, 0);
            light(from(0), mesh.tolerance(), 0);
        }
    }

    private int[][] patches() {
        return IntStream.range(0, nodes.patches()).mapToObj(i -> new int[] {nodes.patch(i)}).toArray(int[][]::new);
    }

    @Override
    public byte[] round(Order order) {
        return switch (order.kind()) {
            case TOTALS -> Wire.bytes(out -> Wire.write(totals(), channels, out));
            case UNSHOT -> Wire.bytes(out -> Wire.write(all(nodes.light()::unshotOfPositive).stream()
                    .map(mesh.rounding::upward).toList(), channels, out));
            case TREES -> Wire.bytes(out -> Wire.write(trees(), channels, out));
            case ROWS -> rows(order);
            case GATHER_AT -> gatherAt(order);
            default -> Wire.bytes(answer(order)::write);
        };
    }

    @Override
    public Answer answer(Order order) {
        if (order.changes() || order.kind() == Order.Kind.REST) {
            candidates.changed();
        }
        switch (order.kind()) {
            case SHOOT -> shoot(order);
            case SPLIT -> split(order);
            case GATHER, REGATHER, MEND -> gather(order);
            case RENEW -> renew(order);
            case AVERAGE -> nodes.points().averageAside(order.rules().anew());
            case BALANCE -> receivers.receiveAmbient(order, nodes, from(0));
            case REST -> gatherRest();
            default -> { }
        }
        return order.question() instanceof Order.Question.Candidates asked ? candidates.answer(order.kind(), asked)
                : new Answer(faces, mesh.fluxScale());
    }

    /** Marks the shots as shot, gathers, and subdivides at the end of the round. */
    private void shoot(Order order) {
        order.shots().forEach(shot -> shot.markShot(nodes, parts));
        gather(order);
        if (!order.more()) {
            subdivide(order.number());
        }
    }

    /** The vertices that this partition shares with other hosts. */
    public GhostVertices ghosts() {
        return ghosts;
    }

    /**
     * Takes ghost values from other hosts.
     *
     * @return whether the values belong to the present agreement of the hosts; if not, no irradiance is changed
     * @throws IOException where there are fewer values than vertices at which other hosts gather
     */
    public boolean takeGhosts(DataInputStream values) throws IOException {
        candidates.changed();
        return ghosts.take(values);
    }

    /** Gathers an order's light at the vertices at which other hosts gather, as their ghost values have not arrived. */
    public void gatherAtGhosts(Order order) {
        candidates.changed();
        gather(receivers.work(order), ghosts.taken(points(order)));
    }

    /**
     * The vertices at which an order gathers, ghosts included: for {@link Order.Kind#GATHER} those that the round
     * before made, for {@link Order.Kind#MEND} those with negative irradiance, else all.
     */
    private int[] points(Order order) {
        return switch (order.kind()) {
            case GATHER -> nodes.points().madeBy(order.number() - 1);
            case MEND -> IntStream.range(0, nodes.vertices()).filter(this::isNegative).toArray();
            default -> from(0);
        };
    }

    /** The vertices from number {@code first} on. */
    private int[] from(int first) {
        return IntStream.range(first, nodes.vertices()).toArray();
    }

    private boolean isNegative(int vertex) {
        double least = 0;
        for (int i = channels * vertex; i < channels * (vertex + 1); i++) {
            least = Math.min(least, nodes.light().irradiance()[i]);
        }
        return least < 0;
    }

    /** Divides elements where interpolation errs, and marked ones; new vertices have light of bare sources only. */
    private void split(Order order) {
        int known = nodes.vertices();
        receivers.findBright(nodes, order.rules().weight());
        new MeshRefinement(nodes, receivers.weights(order), order.rules().meshError())
                .splitAll(order.number(), order.rules().marks(), parallel);
        receivers.bury(nodes, known);
        Arrays.fill(nodes.light().irradiance(), channels * known, channels * nodes.vertices(), 0);
        light(from(known), order.rules().tolerance(), 0);
    }

    private void renew(Order order) {
        order.shots().forEach(shot -> shot.markShot(nodes, parts));
        if (!order.begun()) {
            nodes.points().setAside();
            light(from(0), order.rules().tolerance(), order.number());
        }
    }

    /**
     * Adds the light of sources without geometry, such as the sun, to the irradiance of some vertices.
     *
     * @param tolerance irradiance that one ray may carry, relative to the mean
     * @param turn      0, or another number whenever the rays are to take other directions
     */
    private void light(int[] vertices, double tolerance, int turn) {
        if (!lights.isEmpty()) {
            parallel.run(vertices.length, i -> {
                if (!nodes.points().isBuried(vertices[i])) {
                    long key = nodes.points().key(vertices[i]);
                    lights.light(nodes, vertices[i], mesh.skyRays(tolerance, turn == 0 ? key : Hash.mix(key, turn)));
                }
            });
        }
    }

    @Override
    public List<Shot> totals() {
        return all(nodes.light()::shot);
    }

    private List<Shot> all(PatchTree.Quantity quantity) {
        Shot[] shots = new Shot[shooters.length];
        parallel.run(shots.length, i -> shots[i] = Shot.of(nodes, shooters[i], 0, quantity));
        return List.of(shots);
    }

    private List<Shot> trees() {
        return Arrays.stream(shooters).map(tops -> Shot.of(nodes, tops, 0, (element, values, at) -> { })
                .withoutRadiosities()).toList();
    }

    /**
     * Gathers at all vertices at which no other host gathers. If the order asks for ghost values, gathers only at the
     * vertices that other hosts need too, and leaves the rest to {@link Order.Kind#REST}.
     */
    private void gather(Order order) {
        Gatherer.Work work = receivers.work(order);
        if (order.givesGhosts() && ghosts.isShared()) {
            gather(work, ghosts.given(points(order)));
            rest = work;
        } else {
            gather(work, ghosts.own(points(order)));
        }
    }

    private void gatherRest() {
        if (rest != null) {
            gather(rest, ghosts.alone(points(rest.order())));
            rest = null;
        }
    }

    /** Gathers an order's light at some points; counts what that costs. */
    private void gather(Gatherer.Work work, int[] points) {
        int[] vertices = IntStream.of(points).filter(v -> !nodes.points().isBuried(v)).toArray();
        Order order = work.order();
        boolean isMended = order.kind() == Order.Kind.MEND;
        boolean isAnother = isMended || order.kind() == Order.Kind.REGATHER || order.rules().sparing();
        int turn = isAnother ? order.number() : 0;
        if (vertices.length == 0) {
            return;
        }
        if (isMended) {
            discard(vertices, order);
        }
        costs.begin(vertices);
        if (interpolation.isFor(order)) {
            receivers.receiveAmbient(order, nodes, vertices);
            interpolation.add(work.shooters(), work.calculators(), order.rules(), 1, vertices, turn, costs::add);
        } else {
            receivers.gather(work, nodes, vertices, turn, costs::add);
        }
        if (isMended) {
            raise(vertices);
        }
    }

    /** Resets the irradiance of some vertices to the light of sources without geometry. */
    private void discard(int[] vertices, Order order) {
        for (int v : vertices) {
            Arrays.fill(nodes.light().irradiance(), channels * v, channels * (v + 1), 0);
        }
        light(vertices, order.rules().tolerance(), order.number());
    }

    /** Raises negative irradiances to 0: all shots of a corner may add up to less than 0, as shots take light back. */
    private void raise(int[] vertices) {
        for (int v : vertices) {
            for (int i = channels * v; i < channels * (v + 1); i++) {
                nodes.light().irradiance()[i] = Math.max(0, nodes.light().irradiance()[i]);
            }
        }
    }

    /** Rows of the coarse system for the order's shots, at the coarse vertices dealt to this partition's blocks. */
    private byte[] rows(Order order) {
        CoarseReceivers asked = coarse == null ? new CoarseReceivers(mesh, mine, receivers, parallel) : coarse;
        coarse = order.more() ? asked : null;
        return asked.rows(order);
    }

    private byte[] gatherAt(Order order) {
        if (!(order.question() instanceof Order.Question.Irradiance asked)) {
            throw new IllegalArgumentException("order: expected points to gather at, got " + order.question());
        }
        return new PointGatherer(mesh, mine, order, asked.points(), parallel)
                .irradiance(receivers.shooters(order));
    }

    private void subdivide(int round) {
        if (!meshing.isOn()) {
            return;
        }
        int known = nodes.vertices();
        nodes.beginSplits(0);
        for (int node = 0, last = nodes.nodes(); node < last; node++) {
            if (meshing.wants(nodes, node)) {
                nodes.split(node, round);
            }
        }
        receivers.bury(nodes, known);
    }

    @Override
    public byte[] block(int id) {
        return BlockState.write(nodes, subtrees(id));
    }

    @Override
    public void restore(int id, byte[] state) {
        candidates.changed();
        BlockState.restore(nodes, subtrees(id), state);
    }

    public BlockCosts costs() {
        return costs;
    }

    private int[] subtrees(int id) {
        return nodes.tops(mine.stream().filter(block -> block.id() == id).findFirst().orElseThrow());
    }
}
