package radiosity.output.mesh;

import java.util.Arrays;
import java.util.function.IntFunction;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.CommonEdges;
import radiosity.util.DisjointSets;
import radiosity.util.PointNumbers;

/**
 * The vertices that are shown with one irradiance where a curved surface is made of facets: light is interpolated
 * across the facets (H. Gouraud, Continuous shading of curved surfaces, 1971).
 *
 * <p>Vertices are joined at the ends of an edge that two facets of one side of one surface of one object have in
 * common, if the angle between the facets' normals is at most the surface's smoothing angle. Joined vertices are shown
 * with the mean of their irradiances, weighted by the areas of the elements around each: the integral of the irradiance
 * that is interpolated on elements stays the same. Only what is shown changes, not the light that was calculated.
 */
public final class SmoothShading {

    /** Cosines that differ by less are equal, as normals are rounded to floats. */
    private static final double ROUNDING = 1e-6;

    /** Vertices of which none are joined. */
    static final SmoothShading NONE = new SmoothShading(new int[0], new double[0]);

    /** 1 per vertex: the lowest vertex that is joined with it. Empty if no vertices are joined. */
    private final int[] joined;
    /** 1 per vertex: its weight in the mean; the weights of joined vertices add up to 1. */
    private final double[] weights;

    private SmoothShading(int[] joined, double[] weights) {
        this.joined = joined;
        this.weights = weights;
    }

    /**
     * The elements among which edges are searched.
     *
     * @param elements    indices of elements of one side of one surface of one object
     * @param corners     vertices, 3 per element of the whole mesh
     * @param normal      unit normal of an element
     * @param leastCosine of the angle between the normals of elements that are joined
     */
    private record Side(int[] elements, int[] corners, IntFunction<Vec3> normal, double leastCosine) {

        /** @param points number of the point at each vertex */
        void join(int[] points, DisjointSets sets) {
            int[] own = new int[3 * elements.length];
            Arrays.setAll(own, i -> corners[3 * elements[i / 3] + i % 3]);
            CommonEdges.visit(Arrays.stream(own).map(v -> points[v]).toArray(), (i, j, k, l) -> {
                if (normal.apply(elements[i / 3]).dot(normal.apply(elements[j / 3])) >= leastCosine) {
                    sets.join(own[i], own[j]);
                    sets.join(own[k], own[l]);
                }
            });
        }
    }

    private static double leastCosine(Surface surface) {
        return StrictMath.cos(surface.smoothing()) - ROUNDING;
    }

    /** @param areas 1 per element, square scene units */
    private static SmoothShading of(DisjointSets sets, int vertices, int[] corners, double[] areas) {
        int[] joined = new int[vertices];
        Arrays.setAll(joined, sets::of);
        double[] weights = new double[vertices];
        double[] sums = new double[vertices];
        for (int i = 0; i < corners.length; i++) {
            weights[corners[i]] += areas[i / 3];
            sums[joined[corners[i]]] += areas[i / 3];
        }
        boolean isAny = false;
        for (int v = 0; v < vertices; v++) {
            isAny |= joined[v] != v;
            weights[v] = sums[joined[v]] > 0 ? weights[v] / sums[joined[v]] : joined[v] == v ? 1 : 0;
        }
        return isAny ? new SmoothShading(joined, weights) : NONE;
    }

    /** The joined vertices of a mesh, by its surface's smoothing angle. */
    static SmoothShading of(Mesh mesh) {
        if (mesh.surface().smoothing() == 0) {
            return NONE;
        }
        float[] n = mesh.normals();
        int[] corners = mesh.corners();
        int[] elements = new int[mesh.elements()];
        double[] areas = new double[mesh.elements()];
        Arrays.setAll(elements, e -> e);
        Arrays.setAll(areas, e -> mesh.cross(e).length() / 2);
        double[] positions = new double[mesh.positions().length];
        Arrays.setAll(positions, i -> mesh.positions()[i]);
        DisjointSets sets = new DisjointSets(mesh.vertices());
        new Side(elements, corners, e -> {
            int i = 3 * corners[3 * e];
            return new Vec3(n[i], n[i + 1], n[i + 2]);
        }, leastCosine(mesh.surface())).join(PointNumbers.of(positions), sets);
        return of(sets, mesh.vertices(), corners, areas);
    }

    /**
     * The solution as it is shown: irradiance at joined vertices replaced by its mean, all else the same.
     *
     * @param closed with T-junctions closed
     */
    public static Solution shown(Solution closed) {
        if (closed.scene().surfaces().stream().allMatch(surface -> surface.smoothing() == 0)) {
            return closed;
        }
        int[] points = PointNumbers.of(closed.positions());
        DisjointSets sets = new DisjointSets(closed.vertices());
        int[][] sides = Mesh.bySide(closed);
        for (int side = 0; side < sides.length; side++) {
            Surface surface = closed.scene().surfaces().get(side >> 1);
            if (surface.smoothing() > 0) {
                Mesh.byNode(closed, sides[side]).values().forEach(elements -> new Side(elements, closed.corners(),
                        e -> Elements.normal(closed, e), leastCosine(surface)).join(points, sets));
            }
        }
        double[] areas = new double[closed.elements()];
        Arrays.setAll(areas, e -> Elements.cross(closed, e).length() / 2);
        SmoothShading shading = of(sets, closed.vertices(), closed.corners(), areas);
        return shading.isFlat() ? closed : new Solution(closed.scene(), closed.channels(), closed.lamps(),
                closed.positions(), shading.means(closed.irradiance(), closed.channels()), closed.corners(),
                closed.faceOf(), closed.shots(), closed.rounds(), closed.unshotFlux(), closed.ledger(),
                closed.state());
    }

    /** Whether no vertices are joined. */
    public boolean isFlat() {
        return joined.length == 0;
    }

    /** Values with those of joined vertices replaced by their mean; of vertices that are not joined, the same bits. */
    private double[] means(double[] values, int channels) {
        double[] sums = new double[values.length];
        for (int i = 0; i < values.length; i++) {
            sums[joined[i / channels] * channels + i % channels] += weights[i / channels] * values[i];
        }
        double[] means = new double[values.length];
        for (int i = 0; i < values.length; i++) {
            means[i] = weights[i / channels] == 1 ? values[i] : sums[joined[i / channels] * channels + i % channels];
        }
        return means;
    }

    /** Values with those of joined vertices replaced by their mean, 3 per vertex. */
    double[] means(float[] values) {
        double[] exact = new double[values.length];
        Arrays.setAll(exact, i -> values[i]);
        return means(exact, 3);
    }

    /**
     * What another program needs to show the mesh as it is shown here, 2 per vertex: the lowest vertex that is joined
     * with a vertex, and the vertex's weight in the mean.
     */
    public float[] pairs() {
        float[] pairs = new float[2 * joined.length];
        for (int v = 0; v < joined.length; v++) {
            pairs[2 * v] = joined[v];
            pairs[2 * v + 1] = (float) weights[v];
        }
        return pairs;
    }
}
