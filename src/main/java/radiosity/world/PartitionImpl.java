package radiosity.world;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import java.util.PriorityQueue;
import java.util.stream.IntStream;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.Gathering;
import radiosity.formfactor.RayCaster;
import radiosity.formfactor.Shooter;
import radiosity.patch.AdaptiveMeshing;
import radiosity.patch.Ambient;
import radiosity.patch.Block;
import radiosity.patch.Faces;
import radiosity.patch.RadiosityNodes;
import radiosity.patch.Weights;
import radiosity.visibility.RadiosityBounds;

/**
 * A partition in this process (section 4.5.5 of the paper).
 *
 * <p>Its threads share out runs of neighbouring vertices, then patches. A vertex reads only itself, the shots and the
 * original triangles, so neither threads nor the dealing of blocks have a part in the result.
 */
final class PartitionImpl implements Partition {

    /** Vertices that a thread takes at a time. */
    private static final int RUN = 64;

    private final InitialMesh mesh;
    private final Faces faces;
    private final int channels;
    private final List<Block> mine;
    private final double scale;
    private final double squaredSize;
    private final Crew crew;
    private final RadiosityBounds bounds;
    private final int rays;
    private final Burial burial;
    private final LightSources lights;
    private final AdaptiveMeshing meshing;
    private final RadiosityNodes nodes;
    private final BlockCosts costs;
    /** Nodes that shoot together: single patches in the paper's schedule, else those of a block. */
    private final int[][] shooters;
    /** The coarse mesh's vertices while their rows are made; else null. */
    private RadiosityNodes coarse;
    /** 1 per shooter: sum of |U| A over its elements and the channels, W. */
    private final double[] flux;

    PartitionImpl(InitialMesh mesh, List<Block> mine, int threads) {
        this(mesh, mine, threads, false);
    }

    /** @param restored whether the states of all blocks will be given to {@link #restore}, so none has to be found */
    PartitionImpl(InitialMesh mesh, List<Block> mine, int threads, boolean restored) {
        this.mesh = mesh;
        this.mine = mine;
        faces = mesh.faces;
        channels = faces.channels();
        scale = mesh.fluxScale();
        squaredSize = faces.size() * faces.size();
        crew = new Crew(threads);
        bounds = mesh.bounds();
        rays = mesh.rays();
        meshing = new AdaptiveMeshing(mesh.settings.meshing());
        burial = new Burial(faces, bounds, mesh.rooms::isHidden);
        lights = new LightSources(faces, bounds);
        nodes = new RadiosityNodes(mesh.patcher, mine);
        costs = new BlockCosts(nodes, mine);
        shooters = mesh.shootsBlocks() ? mine.stream().map(nodes::tops).toArray(int[][]::new) : patches();
        flux = new double[shooters.length];
        if (!restored) {
            bury(nodes, 0);
            light(0);
        }
    }

    private void bury(RadiosityNodes of, int first) {
        int count = of.vertices() - first;
        crew.run((count + RUN - 1) / RUN, i ->
                burial.look(of, first + i * RUN, Math.min(of.vertices(), first + (i + 1) * RUN)));
    }

    private int[][] patches() {
        return IntStream.range(0, nodes.patches()).mapToObj(i -> new int[] {nodes.patch(i)}).toArray(int[][]::new);
    }

    @Override
    public byte[] round(byte[] bytes) {
        try {
            return round(Order.decode(bytes));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** @param order with all that is shot */
    byte[] round(Order order) {
        switch (order.kind()) {
            case SHOOT -> shoot(order);
            case SPLIT -> split(order);
            case GATHER -> gather(order, order.number() - 1);
            case TOTALS -> {
                return Wire.bytes(out -> Wire.write(totals(), channels, out));
            }
            case TREES -> {
                return Wire.bytes(out -> Wire.writeTrees(trees(), channels, out));
            }
            case ROWS -> {
                return rows(order);
            }
            default -> { }
        }
        Answer answer = order.isAnswered() ? answer(order) : new Answer(faces, scale);
        return Wire.bytes(answer::write);
    }

    /** Mark what has shot, gather, subdivide. */
    private void shoot(Order order) {
        order.shots().forEach(shot -> shot.markShot(nodes));
        gather(order, IntStream.range(0, nodes.vertices()).toArray());
        if (!order.more()) {
            subdivide(order.number());
        }
    }

    /** Subdivide where it pays. */
    private void split(Order order) {
        int known = nodes.vertices();
        new MeshRefinement(nodes, weights(order), order.meshError()).splitAll(order.number());
        costs.split(order.number());
        bury(nodes, known);
        Arrays.fill(nodes.irradiance(), channels * known, channels * nodes.vertices(), 0);
        light(known);
    }

    /** What has no geometry shoots first. */
    private void light(int first) {
        if (!lights.isEmpty()) {
            crew.run(nodes.vertices() - first, i -> {
                if (!nodes.isBuried(first + i)) {
                    lights.light(nodes, first + i);
                }
            });
        }
    }

    private List<Shot> totals() {
        Shot[] totals = new Shot[shooters.length];
        crew.run(totals.length, i -> totals[i] = Shot.total(nodes, shooters[i]));
        return List.of(totals);
    }

    private List<Shot> trees() {
        return Arrays.stream(shooters).map(tops -> Shot.of(nodes, tops, 0, (node, k, c) -> 0)).toList();
    }

    private void gather(Order order, int split) {
        costs.split(split);
        gather(order, nodes.verticesMade(split));
    }

    /** Neighbouring receiving points take turns at one shooter: their rays run alike. */
    private void gather(Order order, int[] vertices) {
        receiveAmbient(order, vertices);
        Shooter[] source = shooters(order);
        FormFactorCalculator calculator = calculator(order);
        costs.begin(vertices);
        crew.run((vertices.length + RUN - 1) / RUN, i -> {
            int[] run = Arrays.copyOfRange(vertices, i * RUN, Math.min(vertices.length, (i + 1) * RUN));
            long begin = BlockCosts.now();
            for (Shooter shooter : source) {
                gather(calculator, shooter, run);
            }
            costs.add(run, BlockCosts.now() - begin);
        });
    }

    /** Even light of closed rooms, at the beginning of a round. */
    private void receiveAmbient(Order order, int[] vertices) {
        Ambient ambient = ambient(order);
        double[] back = order.givenBack();
        if (order.begun() || ambient.isDark() && back.length == 0) {
            return;
        }
        for (int v : vertices) {
            for (int c = 0; c < channels && !nodes.isBuried(v); c++) {
                nodes.irradiance()[channels * v + c] += ambient.at(nodes.vertexFace(v), c)
                        + (back.length == 0 ? 0 : back[c]);
            }
        }
    }

    private Ambient ambient(Order order) {
        return new Ambient(mesh.rooms, channels, order.ambient());
    }

    private Weights weights(Order order) {
        return new Weights(mesh.rooms, channels, order.weight());
    }

    private FormFactorCalculator calculator(Order order) {
        return mesh.settings.factors().calculator(bounds, rays, order.tolerance());
    }

    private Shooter[] shooters(Order order) {
        Ambient ambient = ambient(order);
        Weights weights = weights(order);
        Shooter[] made = new Shooter[order.shots().size()];
        crew.run(made.length, i -> made[i] = order.shots().get(i).shooter(faces, weights, ambient));
        return made;
    }

    private void gather(FormFactorCalculator calculator, Shooter shooter, int[] run) {
        double[] irradiance = nodes.irradiance();
        Gathering.Irradiance sum = new Gathering.Irradiance(channels);
        for (int v : run) {
            if (!nodes.isBuried(v)) {
                System.arraycopy(irradiance, channels * v, sum.value, 0, channels);
                gather(calculator, shooter, nodes, v, sum);
                System.arraycopy(sum.value, 0, irradiance, channels * v, channels);
            }
        }
    }

    private void gather(FormFactorCalculator calculator, Shooter shooter, RadiosityNodes of, int v, Gathering sum) {
        float[] x = of.receivers();
        int f = faces.plane(of.vertexFace(v));
        calculator.gather(x[3 * v], x[3 * v + 1], x[3 * v + 2],
                faces.normal(f, 0), faces.normal(f, 1), faces.normal(f, 2), of.vertexKey(v), shooter, sum);
    }

    /** Rows of the coarse system for the vertices that this partition's blocks have in it, or parts of them. */
    private byte[] rows(Order order) {
        if (coarse == null) {
            coarse = coarse();
        }
        RadiosityNodes receivers = coarse;
        coarse = order.more() ? coarse : null;
        Shooter[] all = shooters(order);
        FormFactorCalculator calculator = mesh.solvesAtOnce() ? calculator(order)
                : new RayCaster(bounds, 1, order.tolerance(), 1);
        byte[][] row = new byte[receivers.vertices()][];
        crew.run(row.length, v -> {
            Rows seen = new Rows();
            for (int i = 0; i < all.length && !receivers.isBuried(v); i++) {
                gather(calculator, all[i], receivers, v, seen);
            }
            row[v] = Wire.bytes(out -> {
                out.writeLong(receivers.vertexKey(v));
                out.writeBoolean(receivers.isBuried(v));
                seen.write(out);
            });
        });
        return Wire.bytes(out -> {
            out.writeInt(row.length);
            for (byte[] bytes : row) {
                out.write(bytes);
            }
        });
    }

    private RadiosityNodes coarse() {
        RadiosityNodes made = new RadiosityNodes(mesh.coarse, mine);
        bury(made, 0);
        return made;
    }

    private void subdivide(int round) {
        if (!meshing.isOn()) {
            return;
        }
        int known = nodes.vertices();
        for (int node = 0, last = nodes.nodes(); node < last; node++) {
            if (meshing.wants(nodes, node)) {
                nodes.split(node, round);
            }
        }
        bury(nodes, known);
    }

    private Answer answer(Order order) {
        int runs = (shooters.length + RUN - 1) / RUN;
        Answer[] parts = new Answer[runs];
        crew.run(runs, i -> {
            parts[i] = new Answer(faces, scale);
            for (int p = i * RUN; p < Math.min(shooters.length, (i + 1) * RUN); p++) {
                flux[p] = 0;
                for (int top : shooters[p]) {
                    flux[p] += measure(top, parts[i]);
                }
            }
        });
        Answer answer = new Answer(faces, scale);
        for (Answer part : parts) {
            answer.addSums(part);
        }
        int[] named = largest(order.most(), order.least());
        Shot[] candidates = new Shot[named.length];
        crew.run(named.length, i -> candidates[i] = Shot.of(nodes, shooters[named[i]], flux[named[i]],
                (node, k, c) -> mesh.rounded(nodes.unshot(node, k, c))));
        answer.candidates.addAll(List.of(candidates));
        return answer;
    }

    /** Adds what lies below a node to the sums; returns its |U| A over the channels, W. */
    private double measure(int node, Answer sums) {
        double total = 0;
        if (!nodes.isElement(node)) {
            for (int k = 0; k < 4; k++) {
                total += measure(nodes.child(node) + k, sums);
            }
            return total;
        }
        for (int layer = 0; layer < faces.layers(); layer++) {
            total += measure(node, layer, sums);
        }
        sums.elements++;
        return total;
    }

    /** The same of one layer of an element. */
    private double measure(int node, int layer, Answer sums) {
        double total = 0;
        double area = nodes.area(node) * squaredSize;
        for (int c = layer * faces.colours(); c < (layer + 1) * faces.colours(); c++) {
            double u = 0;
            double h = 0;
            for (int k = 0; k < 3; k++) {
                u += nodes.unshot(node, k, c);
                h += nodes.irradiance(node, k, c);
            }
            u *= area / 3;
            h = (h / 3 + nodes.bulge(node, c)) * area;
            total += Math.abs(u);
            sums.unshot[c].add(u);
            sums.received[c].add(h);
            sums.absorbed[c].add(h - h * nodes.reflectance(node, c));
        }
        sums.unshotFlux[layer].add(total);
        return total;
    }

    /** Of those with so much flux at least, W. */
    private int[] largest(int most, double least) {
        boolean all = mesh.predicts() && mesh.rooms.count() > 0;
        PriorityQueue<Integer> best = new PriorityQueue<>((p, q) -> -order(p, q));
        for (int p = 0; p < flux.length && most > 0; p++) {
            if ((flux[p] > 0 || all) && flux[p] >= least && (best.size() < most || order(p, best.peek()) < 0)) {
                best.add(p);
                if (best.size() > most) {
                    best.poll();
                }
            }
        }
        return best.stream().sorted(this::order).mapToInt(Integer::intValue).toArray();
    }

    private int order(int p, int q) {
        int order = Double.compare(flux[q], flux[p]);
        order = order != 0 ? order : Integer.compare(nodes.face(shooters[p][0]), nodes.face(shooters[q][0]));
        return order != 0 ? order : Long.compare(nodes.path(shooters[p][0]), nodes.path(shooters[q][0]));
    }

    @Override
    public byte[] block(int id) {
        return BlockState.write(nodes, subtrees(id));
    }

    @Override
    public void restore(int id, byte[] state) {
        BlockState.restore(nodes, subtrees(id), state);
    }

    BlockCosts costs() {
        return costs;
    }

    private int[] subtrees(int id) {
        return nodes.tops(mine.stream().filter(block -> block.id() == id).findFirst().orElseThrow());
    }
}
