package radiosity.certificate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.VertexBulge;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.settings.Accuracy;
import radiosity.setup.InitialMesh;
import radiosity.util.ParallelFor;
import radiosity.util.R2;

/** Chooses the points at which an {@link Audit} gathers anew: most of them where large errors are expected. */
final class AuditPlaces {

    /*
     * Errors have a heavy tail: a few small elements at the edge of a shadow, or around a lamp, may make up most of the
     * mean square. Points are best distributed in proportion to area times expected error (J. Neyman, On the two
     * different aspects of the representative method, 1934); the error expected here grows with the radiosity of an
     * element and with the differences within the element. A constant is added, so that no point represents much more
     * area than its share where the expectation is wrong (T. Hesterberg, Weighted average importance sampling and
     * defensive mixture distributions, 1995). Each surface has points of its own, at equal steps of this weight through
     * its elements.
     */
    /** Weight of the difference between the corners of an element, relative to the weight of its mean. */
    private static final double DIFFERENCE = 10;
    private static final int LEAST_PER_SURFACE = 2;
    /** About the number of detailed points of a batch; at most every third point is detailed. */
    private static final int DETAILED = 500;
    private static final int LEAST_PER_DETAILED = 3;
    /** Number of blocks whose elements are in memory at a time. */
    private static final int BLOCKS_AT_A_TIME = 32;

    private final InitialMesh mesh;
    private final Faces faces;
    private final IntFunction<RadiosityNodes> nodes;
    /** 1 per colour each: mean reflected radiosity, and mean radiosity leaving surfaces, W/m². */
    private final double[] reflected;
    private final double[] leaving;
    private final ParallelFor parallel;
    private final VertexBulge bulges;
    private final Weighed[] weighed;

    /** The visible elements of a block, 1 per element: its node, the number of its surface, and its sampling weight. */
    private record Weighed(int[] node, int[] surface, double[] weight) { }

    /**
     * @param nodes     returns the nodes of a block, by block id, with their light
     * @param reflected 1 per channel: mean reflected radiosity, W/m²
     * @param leaving   1 per channel: mean radiosity that leaves surfaces, W/m²
     */
    AuditPlaces(InitialMesh mesh, IntFunction<RadiosityNodes> nodes, double[] reflected, double[] leaving,
            ParallelFor parallel) {
        this.mesh = mesh;
        this.nodes = nodes;
        this.parallel = parallel;
        faces = mesh.faces;
        this.reflected = faces.perColour(reflected);
        this.leaving = faces.perColour(leaving);
        weighed = new Weighed[mesh.blocks.size()];
        bulges = new VertexBulge(faces.channels(), faces.colours());
        for (int first = 0; first < weighed.length; first += BLOCKS_AT_A_TIME) {
            weigh(first, Math.min(BLOCKS_AT_A_TIME, weighed.length - first));
        }
    }

    /** Weighs the elements of some blocks, and adds their curved light to that of all, in the order of blocks. */
    private void weigh(int first, int count) {
        RadiosityNodes[] its = new RadiosityNodes[count];
        parallel.run(count, i -> {
            its[i] = nodes.apply(first + i);
            weighed[first + i] = weigh(its[i]);
        });
        for (RadiosityNodes of : its) {
            bulges.add(of, 0);
        }
    }

    private Weighed weigh(RadiosityNodes of) {
        int[] node = IntStream.range(0, of.nodes()).filter(of::isElement).filter(i -> !mesh.rooms.isHidden(of.face(i)))
                .toArray();
        return new Weighed(node, IntStream.of(node).map(i -> surface(of.face(i))).toArray(),
                IntStream.of(node).mapToDouble(i -> weight(of, i)).toArray());
    }

    private int surface(int face) {
        return mesh.scene.surfaceOf()[faces.triangle(face)];
    }

    private double weight(RadiosityNodes of, int node) {
        double most = 0;
        for (int colour = 0; colour < faces.colours(); colour++) {
            most = Math.max(most, expected(of, node, colour));
        }
        return of.area(node) * (1 + most);
    }

    /**
     * Relative error expected on an element, up to a factor. An element with one receiving point may vary by its mean,
     * or by the mean of the scene where its receiving point is darker.
     */
    private double expected(RadiosityNodes of, int node, int colour) {
        double[] corner = new double[3];
        double emitted = 0;
        for (int c = colour; c < faces.channels(); c += faces.colours()) {
            for (int k = 0; k < 3; k++) {
                corner[k] += of.reflectance(node, c) * of.light().irradiance(node, k, c);
            }
            emitted += of.exitance(node, c);
        }
        Arrays.sort(corner);
        double mean = (corner[0] + corner[1] + corner[2]) / 3;
        double differs = DIFFERENCE * (of.isPoint(node) ? Math.max(mean, reflected[colour]) : corner[2] - corner[0]);
        double unit = Math.max(reflected[colour], mean / Accuracy.BRIGHT);
        return ratio(mean + differs, unit) + ratio(emitted, leaving[colour]);
    }

    private static double ratio(double a, double b) {
        return b > 0 ? a / b : 0;
    }

    /** 1 per block: number of its visible elements. */
    int[] elements() {
        return Arrays.stream(weighed).mapToInt(of -> of.node.length).toArray();
    }

    /*---- Picking ----*/

    /**
     * Chooses one batch of points.
     *
     * @param wanted about how many points
     * @param start  where the batch begins within the sampling step, from 0 to 1
     * @param known  number of points of earlier batches
     */
    List<AuditPoint> pick(int wanted, double start, int known) {
        int surfaces = mesh.scene.surfaces().size();
        double[] whole = new double[surfaces];
        for (Weighed of : weighed) {
            for (int i = 0; i < of.node.length; i++) {
                whole[of.surface[i]] += of.weight[i];
            }
        }
        double all = Arrays.stream(whole).sum();
        double[] step = new double[surfaces];
        Arrays.setAll(step, s -> whole[s] / Math.max(LEAST_PER_SURFACE, Math.round(wanted * whole[s] / all)));
        List<Pick> picks = new ArrayList<>();
        double[] next = Arrays.stream(step).map(s -> s * start).toArray();
        int[] count = new int[surfaces];
        int perDetailed = Math.max(LEAST_PER_DETAILED, wanted / DETAILED);
        int[] until = new int[weighed.length];
        for (int block = 0; block < weighed.length; block++) {
            pick(block, step, next, count, perDetailed, picks);
            until[block] = picks.size();
        }
        AuditPoint[] points = new AuditPoint[picks.size()];
        parallel.run(until.length, block -> {
            int from = block == 0 ? 0 : until[block - 1];
            RadiosityNodes its = from < until[block] ? nodes.apply(block) : null;
            for (int i = from; i < until[block]; i++) {
                Pick pick = picks.get(i);
                double area = pick.step * its.area(pick.node) / pick.weight;
                points[i] = point(its, pick.node, area, known + i + 1, pick.isDetailed);
            }
        });
        return List.of(points);
    }

    /**
     * An element on which a point is to lie.
     *
     * @param node   the element
     * @param weight its sampling weight
     * @param step   sampling weight from one point of its surface to the next
     */
    private record Pick(int node, double weight, double step, boolean isDetailed) { }

    /**
     * Appends the elements of a block on which points are to lie.
     *
     * @param step  1 per surface: sampling weight from one point to the next
     * @param next  modified, 1 per surface: sampling weight left up to the next point
     * @param count modified, 1 per surface: number of points in this batch; one of each {@code perDetailed} is detailed
     */
    private void pick(int block, double[] step, double[] next, int[] count, int perDetailed, List<Pick> picks) {
        Weighed of = weighed[block];
        for (int i = 0; i < of.node.length; i++) {
            int s = of.surface[i];
            next[s] -= of.weight[i];
            for (; next[s] < 0; next[s] += step[s]) {
                picks.add(new Pick(of.node[i], of.weight[i], step[s], count[s]++ % perDetailed == 0));
            }
        }
    }

    private AuditPoint point(RadiosityNodes of, int node, double area, int number, boolean isDetailed) {
        double u = R2.u(number);
        double v = R2.v(number);
        boolean fold = u + v > 1;
        double b = fold ? 1 - u : u;
        double c = fold ? 1 - v : v;
        return new AuditPoint(of, node, area, new double[] {1 - b - c, b, c}, number, isDetailed, mesh.interior,
                bulges);
    }

    /**
     * Finds the elements on which some places lie, and makes points of them that stand for no area.
     *
     * @param at     where the places lie; not modified
     * @param number 1 per place: number from which the point's rays follow; not modified
     * @return 1 per place: the point, or null where no block has the element
     */
    AuditPoint[] find(List<NearbyPoints.Place> at, int[] number) {
        AuditPoint[] found = new AuditPoint[number.length];
        Map<Integer, List<Integer>> onFace = new HashMap<>();
        for (int i = 0; i < found.length; i++) {
            onFace.computeIfAbsent(at.get(i).face(), face -> new ArrayList<>()).add(i);
        }
        int[][] wanted = mesh.blocks.stream().map(block -> IntStream.of(block.face()).distinct()
                .filter(onFace::containsKey).flatMap(face -> onFace.get(face).stream().mapToInt(i -> i)).toArray())
                .toArray(int[][]::new);
        int[] blocks = IntStream.range(0, wanted.length).filter(b -> wanted[b].length > 0).toArray();
        parallel.run(blocks.length, i -> find(nodes.apply(blocks[i]), wanted[blocks[i]], at, number, found));
        return found;
    }

    /** @param some numbers of the places that may lie on elements of the block with these nodes */
    private void find(RadiosityNodes its, int[] some, List<NearbyPoints.Place> at, int[] number, AuditPoint[] found) {
        for (int i : some) {
            int node = its.element(at.get(i).face(), at.get(i).path());
            if (node >= 0) {
                found[i] = new AuditPoint(its, node, 0, at.get(i).weights(its.path(node)), number[i], false,
                        mesh.interior, bulges);
            }
        }
    }

    /** Returns the point x, y, z of a triangle with these barycentric weights. */
    static float[] within(float[] corner, double... weight) {
        float[] x = new float[3];
        for (int i = 0; i < 9; i++) {
            x[i % 3] += (float) (weight[i / 3] * corner[i]);
        }
        return x;
    }
}
