package radiosity.partition;

import java.util.List;
import java.util.PriorityQueue;
import java.util.stream.IntStream;
import radiosity.mesh.ElementLight;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.face.Faces;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;
import radiosity.setup.InitialMesh;
import radiosity.util.ParallelFor;

/** The shooters of a partition: sums of light over their elements, and the shooters with the most unshot flux. */
final class Candidates {

    /** Largest number of shooters that a thread measures at a time. */
    private static final int RUN = 64;

    private final InitialMesh mesh;
    private final Faces faces;
    private final double squaredSize;
    private final RadiosityNodes nodes;
    private final int[][] shooters;
    private final ParallelFor parallel;
    /** 1 per shooter: sum of |U| A over its elements and the channels, W. */
    private final double[] flux;
    /** Sums over all shooters, without candidates; null where light or elements have changed since. */
    private Answer sums;
    /** 1 per shooter: its unshot light, or null where no question has asked for the shooter yet. */
    private Shot[] shots;

    /** @param shooters 1 array per shooter: the top nodes that shoot together; not modified */
    Candidates(InitialMesh mesh, RadiosityNodes nodes, int[][] shooters, ParallelFor parallel) {
        this.mesh = mesh;
        faces = mesh.faces;
        squaredSize = faces.size() * faces.size();
        this.nodes = nodes;
        this.shooters = shooters;
        this.parallel = parallel;
        flux = new double[shooters.length];
    }

    /** Answers a question: sums over all shooters, and those candidates that have the flux asked for. */
    Answer answer(Order.Kind kind, Order.Question.Candidates asked) {
        if (sums == null) {
            sums = sumAll();
            shots = new Shot[shooters.length];
        }
        Answer answer = new Answer(faces, mesh.fluxScale());
        answer.addSums(sums);
        int[] named = largest(asked.most(), asked.flux());
        parallel.run(named.length, i -> find(named[i]));
        boolean means = kind == Order.Kind.MEANS;
        IntStream.of(named).mapToObj(p -> means ? shots[p].mean(mesh.coarse) : shots[p])
                .forEach(answer.candidates::add);
        return answer;
    }

    private void find(int shooter) {
        if (shots[shooter] == null) {
            Shot whole = Shot.of(nodes, shooters[shooter], flux[shooter], nodes.light()::unshot);
            shots[shooter] = mesh.rounding.of(mesh.shootsClusters() ? whole.pruned(mesh.coarse) : whole);
        }
    }

    /** Forgets all sums and shots; to be called when an element has shot, gathered or been divided. */
    void changed() {
        sums = null;
        shots = null;
    }

    private Answer sumAll() {
        Answer all = new Answer(faces, mesh.fluxScale());
        parallel.run(shooters.length, RUN, (from, to) -> {
            Answer some = sumRange(from, to);
            synchronized (all) {
                all.addSums(some);
            }
        });
        return all;
    }

    /** The sums over the shooters {@code from} to {@code to - 1}; sets their {@link #flux}. */
    private Answer sumRange(int from, int to) {
        Answer sums = new Answer(faces, mesh.fluxScale());
        for (int p = from; p < to; p++) {
            flux[p] = 0;
            for (int i = 0; i < shooters[p].length; i++) {
                flux[p] += addNode(shooters[p][i], sums);
            }
        }
        return sums;
    }

    /** Adds the elements below a node to the sums; returns their |U| A summed over the channels, W. */
    private double addNode(int node, Answer sums) {
        double total = 0;
        if (!nodes.isElement(node)) {
            for (int k = 0; k < 4; k++) {
                total += addNode(nodes.child(node) + k, sums);
            }
            return total;
        }
        for (int layer = 0; layer < faces.layers(); layer++) {
            total += addLayer(node, layer, sums);
        }
        sums.elements++;
        return total;
    }

    /** Adds one layer of an element to the sums; returns its |U| A summed over the layer's channels, W. */
    private double addLayer(int node, int layer, Answer sums) {
        double total = 0;
        double area = nodes.area(node) * squaredSize;
        ElementLight light = nodes.light();
        for (int c = layer * faces.colours(); c < (layer + 1) * faces.colours(); c++) {
            double bulge = light.bulge(node, c);
            double u = 0;
            double h = 0;
            for (int k = 0; k < 3; k++) {
                u += light.unshot(node, k, c, bulge);
                h += light.irradiance(node, k, c);
            }
            u *= area / 3;
            h = (h / 3 + bulge) * area;
            total += Math.abs(u);
            sums.unshot[c].add(u);
            sums.received[c].add(h);
            sums.absorbed[c].add(h - h * nodes.reflectance(node, c));
        }
        sums.unshotFlux[layer].add(total);
        return total;
    }

    /**
     * Up to {@code most} shooters of at least {@code least} W, largest flux first. Shooters without flux count only
     * where all have to shoot: clusters, and predicted light in closed rooms.
     */
    private int[] largest(int most, double least) {
        boolean all = mesh.shootsClusters() || mesh.predicts() && mesh.rooms.count() > 0;
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
}
