package radiosity.world;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.Gathering;
import radiosity.formfactor.RayCaster;
import radiosity.formfactor.Shooter;
import radiosity.patch.Block;
import radiosity.patch.ElementLight;
import radiosity.patch.Faces;
import radiosity.patch.Path;
import radiosity.patch.PatchTree;
import radiosity.patch.RadiosityNodes;
import radiosity.patch.Subdivision;
import radiosity.patch.Weights;
import radiosity.scene.Surface;

/** Looks at a solution anew, at some points of every surface, and writes its {@link Certificate}. */
final class Audit {

    /** Points: one for so many elements, but no less and no more than that. */
    private static final int ELEMENTS_PER_POINT = 100;
    private static final int LEAST_POINTS = 64;
    private static final int MOST_POINTS = 400;
    /** What a ray may carry, relative to the mean, where light is found anew. */
    private static final double TOLERANCE = 0.004;
    /** The same for sums of form factors. */
    private static final double FACTOR_TOLERANCE = 0.05;
    /** The R2 sequence's steps. */
    private static final double STEP_U = 0.7548776662466927;
    private static final double STEP_V = 0.5698402909980532;

    private final InitialMesh mesh;
    private final Faces faces;
    private final List<byte[]> states;
    private final EnergyLedger ledger;
    private final Crew crew;
    private final List<AuditPoint> points = new ArrayList<>();

    /**
     * @param states of all blocks, by id
     * @param ledger of the same moment
     */
    Audit(InitialMesh mesh, List<byte[]> states, EnergyLedger ledger, int elements, int threads) {
        this.mesh = mesh;
        this.states = states;
        this.ledger = ledger;
        faces = mesh.faces;
        crew = new Crew(threads);
        pick(Math.max(LEAST_POINTS, Math.min(MOST_POINTS, elements / ELEMENTS_PER_POINT)));
        Burial burial = new Burial(faces, mesh.bounds(), mesh.rooms::isHidden);
        points.removeIf(point -> point.isBuried(burial));
    }

    /*---- Where to look ----*/

    private void pick(int wanted) {
        Map<Surface, List<Integer>> bySurface = new LinkedHashMap<>();
        for (int f = 0; f < faces.count(); f++) {
            bySurface.computeIfAbsent(surface(f), s -> new ArrayList<>()).add(f);
        }
        for (List<Integer> some : bySurface.values()) {
            double area = some.stream().mapToDouble(faces::area).sum();
            pick(some, area, (int) Math.max(2, Math.round(wanted * area / faces.area())));
        }
    }

    private Surface surface(int face) {
        return mesh.scene.surface(faces.triangle(face));
    }

    /** Points at equal steps of area. */
    private void pick(List<Integer> some, double area, int count) {
        double passed = 0;
        int next = 0;
        for (int f : some) {
            passed += faces.area(f);
            for (; next < count && (next + 0.5) / count * area <= passed; next++) {
                double u = (points.size() + 1) * STEP_U % 1;
                double v = (points.size() + 1) * STEP_V % 1;
                boolean fold = u + v > 1;
                points.add(new AuditPoint(faces, f, area / count, fold ? 1 - u : u, fold ? 1 - v : v, next));
            }
        }
    }

    /*---- Looking ----*/

    Certificate certificate(double unshotFlux) throws IOException {
        for (Block block : mesh.blocks) {
            if (points.stream().anyMatch(point -> lies(point, block))) {
                RadiosityNodes nodes = nodes(block);
                points.forEach(point -> point.find(block, nodes));
            }
        }
        LightSources lights = new LightSources(faces, mesh.bounds());
        crew.run(points.size(), i -> points.get(i).light(lights));
        mesh.blocks.forEach(this::gather);
        double reciprocity = reciprocity();
        points.removeIf(AuditPoint::isDark);
        return new AuditResult(faces, points, ledger).certificate(unshotFlux, reciprocity);
    }

    private static boolean lies(AuditPoint point, Block block) {
        return Arrays.stream(block.face()).anyMatch(f -> f == point.face);
    }

    private RadiosityNodes nodes(Block block) {
        RadiosityNodes nodes = new RadiosityNodes(mesh.patcher, List.of(block));
        BlockState.restore(nodes, nodes.tops(), states.get(block.id()));
        return nodes;
    }

    /** What a block's elements shine with, and then as if all shone with 1. */
    private void gather(Block block) {
        RadiosityNodes nodes = nodes(block);
        int corners = 3 * nodes.channels();
        ElementLight all = nodes.light();
        Shooter light = Shot.of(nodes, nodes.tops(), 0, all::shining).shooter(faces, Weights.of(weight()));
        Shooter ones = Shot.of(nodes, nodes.tops(), 0, (element, values, at) -> Arrays.fill(values, at, at + corners, 1))
                .shooter(faces, Weights.of(ones()));
        FormFactorCalculator many = new RayCaster(mesh.bounds(), 1, TOLERANCE);
        FormFactorCalculator few = few();
        crew.run(points.size(), i -> {
            points.get(i).gather(many, light);
            points.get(i).addFactors(few, ones);
        });
    }

    private FormFactorCalculator few() {
        return mesh.settings.factors().calculator(mesh.bounds(), mesh.rays(), FACTOR_TOLERANCE);
    }

    private double[] ones() {
        double[] ones = new double[faces.channels()];
        Arrays.fill(ones, 1);
        return ones;
    }

    /** One per channel: 1 / mean reflected radiosity, m²/W. */
    private double[] weight() {
        double[] weight = new double[faces.channels()];
        for (int c = 0; c < weight.length; c++) {
            double received = ledger.received()[c];
            double reflected = Math.max(Faces.LEAST_IMPORTANCE * received, received - ledger.absorbed()[c]);
            weight[c] = reflected > 0 ? faces.area() * faces.size() * faces.size() / reflected : 0;
        }
        return weight;
    }

    /*---- Reciprocity: A F from one block's top to another's, and back ----*/

    private double reciprocity() {
        double[] difference = new double[points.size()];
        double[] sum = new double[points.size()];
        crew.run(points.size(), i -> {
            AuditPoint p = points.get(i);
            AuditPoint q = points.get((i + points.size() / 2) % points.size());
            double there = exchange(p, q);
            double back = exchange(q, p);
            difference[i] = Math.abs(there - back);
            sum[i] = (there + back) / 2;
        });
        double all = Arrays.stream(sum).sum();
        return all == 0 ? 0 : Arrays.stream(difference).sum() / all;
    }

    /** Area of a patch times its form factor to another, as a mean over three points within. */
    private double exchange(AuditPoint from, AuditPoint to) {
        PatchTree tree = new PatchTree(to.face, to.top, new int[] {-1}, threeOnes());
        Shooter shooter = new Shooter(faces, List.of(tree), Weights.of(ones()));
        float[] corner = corners(from);
        Gathering.Irradiance sum = new Gathering.Irradiance(faces.channels());
        for (int k = 0; k < 3; k++) {
            float[] x = new float[3];
            for (int i = 0; i < 9; i++) {
                x[i % 3] += corner[i] * (i / 3 == k ? 2 / 3f : 1 / 6f);
            }
            few().gather(x[0], x[1], x[2], faces.normal(from.face, 0), faces.normal(from.face, 1),
                    faces.normal(from.face, 2), k, shooter, sum);
        }
        return sum.value[0] / 3 * faces.area(from.face) / (1L << 2 * Path.level(from.top));
    }

    private double[] threeOnes() {
        double[] ones = new double[3 * faces.channels()];
        Arrays.fill(ones, 1);
        return ones;
    }

    private float[] corners(AuditPoint of) {
        float[] corner = new float[9];
        for (int i = 0; i < 9; i++) {
            corner[i] = faces.corner(of.face, i / 3, i % 3);
        }
        for (int level = 1; level <= Path.level(of.top); level++) {
            Subdivision.child(corner, 0, Path.step(of.top, level), corner, 0);
        }
        return corner;
    }
}
