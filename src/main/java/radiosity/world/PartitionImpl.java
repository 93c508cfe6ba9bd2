package radiosity.world;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.PriorityQueue;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.RayCaster;
import radiosity.formfactor.Shooter;
import radiosity.patch.AdaptiveMeshing;
import radiosity.patch.Block;
import radiosity.patch.Faces;
import radiosity.patch.RadiosityNodes;
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

    private final Faces faces;
    private final int channels;
    private final List<Block> mine;
    private final double scale;
    private final double squaredSize;
    private final Crew crew;
    private final FormFactorCalculator calculator;
    private final Burial burial;
    private final AdaptiveMeshing meshing;
    private final RadiosityNodes nodes;
    /** 1 per patch: sum of |U| A over its elements and the channels, W. */
    private final double[] flux;

    PartitionImpl(InitialMesh mesh, List<Block> mine, int threads) {
        this.mine = mine;
        faces = mesh.faces;
        channels = faces.channels();
        scale = mesh.totalEmitted();
        squaredSize = faces.size() * faces.size();
        crew = new Crew(threads);
        RadiosityBounds bounds = new RadiosityBounds(faces.occluders());
        calculator = new RayCaster(bounds, mesh.settings.rays(), Double.POSITIVE_INFINITY);
        meshing = new AdaptiveMeshing(mesh.settings.meshing());
        burial = new Burial(faces, bounds);
        nodes = new RadiosityNodes(mesh.patcher, mine);
        flux = new double[nodes.patches()];
        bury(0);
    }

    private void bury(int first) {
        int count = nodes.vertices() - first;
        crew.run((count + RUN - 1) / RUN, i ->
                burial.look(nodes, first + i * RUN, Math.min(nodes.vertices(), first + (i + 1) * RUN)));
    }

    @Override
    public byte[] shoot(byte[] shots, int most) {
        try {
            Answer answer = update(Wire.shots(shots), most);
            return Wire.bytes(answer::write);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** One round: mark what has shot, gather, subdivide, and see who has most to shoot. */
    private Answer update(List<Shot> shots, int most) {
        if (!shots.isEmpty()) {
            markShot(shots);
            gather(shots);
            subdivide();
        }
        return answer(most);
    }

    private void markShot(List<Shot> shots) {
        for (Shot shot : shots) {
            int patch = nodes.find(shot.face(), shot.path());
            if (patch >= 0) {
                shot.markShot(nodes, patch);
            }
        }
    }

    /** Neighbouring receiving points take turns at one shooter: their rays run alike. */
    private void gather(List<Shot> shots) {
        Shooter[] shooters = shots.stream().map(shot -> shot.shooter(faces)).toArray(Shooter[]::new);
        crew.run((nodes.vertices() + RUN - 1) / RUN, i -> {
            int first = i * RUN;
            int last = Math.min(nodes.vertices(), first + RUN);
            for (Shooter shooter : shooters) {
                gather(shooter, first, last);
            }
        });
    }

    private void gather(Shooter shooter, int first, int last) {
        float[] x = nodes.receivers();
        double[] irradiance = nodes.irradiance();
        double[] sum = new double[channels];
        for (int v = first; v < last; v++) {
            if (nodes.isBuried(v)) {
                continue;
            }
            int f = nodes.vertexFace(v);
            System.arraycopy(irradiance, channels * v, sum, 0, channels);
            calculator.gather(x[3 * v], x[3 * v + 1], x[3 * v + 2],
                    faces.normal(f, 0), faces.normal(f, 1), faces.normal(f, 2), nodes.vertexKey(v), shooter, sum);
            System.arraycopy(sum, 0, irradiance, channels * v, channels);
        }
    }

    private void subdivide() {
        if (!meshing.isOn()) {
            return;
        }
        int known = nodes.vertices();
        for (int node = 0, last = nodes.nodes(); node < last; node++) {
            if (meshing.wants(nodes, node)) {
                nodes.split(node);
            }
        }
        bury(known);
    }

    private Answer answer(int most) {
        int runs = (nodes.patches() + RUN - 1) / RUN;
        Answer[] parts = new Answer[runs];
        crew.run(runs, i -> {
            parts[i] = new Answer(channels, scale);
            for (int p = i * RUN; p < Math.min(nodes.patches(), (i + 1) * RUN); p++) {
                flux[p] = measure(nodes.patch(p), parts[i]);
            }
        });
        Answer answer = new Answer(channels, scale);
        for (Answer part : parts) {
            answer.addSums(part);
        }
        for (int p : largest(most)) {
            answer.candidates.add(Shot.of(nodes, nodes.patch(p), flux[p]));
        }
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
        double area = nodes.area(node) * squaredSize;
        for (int c = 0; c < channels; c++) {
            double u = 0;
            double h = 0;
            for (int k = 0; k < 3; k++) {
                u += nodes.unshot(node, k, c);
                h += nodes.irradiance(node, k, c);
            }
            u *= area / 3;
            h *= area / 3;
            total += Math.abs(u);
            sums.unshot[c].add(u);
            sums.received[c].add(h);
            sums.absorbed[c].add(h - h * faces.reflectance(nodes.face(node), c));
        }
        sums.unshotFlux.add(total);
        sums.elements++;
        return total;
    }

    private int[] largest(int most) {
        PriorityQueue<Integer> best = new PriorityQueue<>((p, q) -> -order(p, q));
        for (int p = 0; p < flux.length && most > 0; p++) {
            if (flux[p] > 0 && (best.size() < most || order(p, best.peek()) < 0)) {
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
        order = order != 0 ? order : Integer.compare(nodes.face(nodes.patch(p)), nodes.face(nodes.patch(q)));
        return order != 0 ? order : Long.compare(nodes.path(nodes.patch(p)), nodes.path(nodes.patch(q)));
    }

    @Override
    public byte[] block(int id) {
        return BlockState.write(nodes, subtrees(id));
    }

    @Override
    public void restore(int id, byte[] state) {
        BlockState.restore(nodes, subtrees(id), state);
    }

    private int[] subtrees(int id) {
        return nodes.tops(mine.stream().filter(block -> block.id() == id).findFirst().orElseThrow());
    }
}
