package radiosity.formfactor;

import radiosity.util.Hash;
import radiosity.visibility.RadiosityBounds;

/**
 * Form factors by ray casting (section 2.3.2 and 4.5.11 of the paper): the exact form factor to an unoccluded triangle
 * times the visible share of the triangle, which is estimated by rays to sample points.
 *
 * <p>A node of the shooter that carries more light than its rays may carry is entered: its parts are treated one by
 * one, down to the elements.
 */
public final class RayCaster implements FormFactorCalculator {

    /*
     * Visible share: sum V K / sum K over the sample points, K = cos cos / r^2. The paper's kernel K A / pi alone errs
     * by up to 95 % near a surface; see docs/PAPER.md, deviation 2. Sample points are those of the R2 sequence, rotated
     * by a hash of receiving point and shooting node, so every host and thread casts the same rays.
     */
    /** Weight of (radius / distance)^2 in the light carried: kernel and shadows change faster over a near node. */
    private static final double NEAR = 16;
    /** (Radius / distance)^2 of a node above which 8, and above which 4 sample points are drawn per ray. */
    private static final double NEAR_8 = 0.05;
    private static final double NEAR_4 = 0.003;
    /** Triangles drawn for one ray at a cluster that carries as much as a ray may; for less light in proportion. */
    private static final int CLUSTER_DRAWS = 8;
    /** Largest number of rays at one element, unless the caller sets another. */
    private static final int MOST_RAYS = 64;
    private final ClusterRays clusters;
    private final TriangleRays triangles;
    private final int rays;
    private final double tolerance;
    private final int mostRays;
    private final ShadowTest sight;
    private final boolean sparing;

    /**
     * @param rays      number of rays at a node, at least 1
     * @param tolerance largest light that these rays may carry: form factor times weighted radiosity (see
     *                  {@link ShooterHierarchy}), more from near nodes. A node that carries more is entered, an element
     *                  gets more rays. Infinite: no node is entered; for shooters of a single patch only
     */
    public RayCaster(RadiosityBounds bounds, int rays, double tolerance) {
        this(bounds, rays, tolerance, Math.max(rays, MOST_RAYS));
    }

    /** @param mostRays largest number of rays at one element, however much light it carries */
    public RayCaster(RadiosityBounds bounds, int rays, double tolerance, int mostRays) {
        this(new ShadowTest(bounds), rays, tolerance, mostRays, false);
    }

    /**
     * A ray caster that plays Russian roulette (J. Arvo, D. Kirk, Particle transport and image synthesis, 1990) with
     * nodes that carry less than an eighth of the tolerance: rays are cast with a probability in proportion to the
     * light that the node carries, and their light is divided by the probability.
     *
     * @throws IllegalArgumentException where the tolerance is infinite
     */
    public static RayCaster sparing(RadiosityBounds bounds, int rays, double tolerance) {
        if (tolerance == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException("sparing rays: expected a finite tolerance, got " + tolerance);
        }
        return new RayCaster(new ShadowTest(bounds), rays, tolerance, Math.max(rays, MOST_RAYS), true);
    }

    /** A ray caster that gathers the difference of light between two scenes: its visibilities are 1, 0 and -1. */
    public RayCaster(VisibilityChange change, int rays, double tolerance) {
        this(change, rays, tolerance, Math.max(rays, MOST_RAYS), false);
    }

    private RayCaster(ShadowTest sight, int rays, double tolerance, int mostRays, boolean sparing) {
        this.sight = sight;
        this.sparing = sparing;
        clusters = new ClusterRays(sight);
        triangles = new TriangleRays(sight);
        this.rays = rays;
        this.tolerance = tolerance;
        this.mostRays = mostRays;
    }

    /** @throws IllegalArgumentException where the tolerance is infinite and the shooter has clusters */
    @Override
    public void gather(float px, float py, float pz, float nx, float ny, float nz, long key, ShooterHierarchy shooter,
                       GatherSink gathering) {
        if (tolerance == Double.POSITIVE_INFINITY && shooter.face[0] < 0) {
            throw new IllegalArgumentException("rays to clusters: expected a finite tolerance, got " + tolerance);
        }
        enter(px, py, pz, nx, ny, nz, key, shooter, 0, gathering);
    }

    private void enter(float px, float py, float pz, float nx, float ny, float nz, long key, ShooterHierarchy s,
            int node,
                       GatherSink gathering) {
        double strength = s.strength[node];
        float[] extent = s.extent;
        float ex = extent[4 * node] - px;
        float ey = extent[4 * node + 1] - py;
        float ez = extent[4 * node + 2] - pz;
        float r2 = extent[4 * node + 3];
        float up = nx * ex + ny * ey + nz * ez;
        if (strength == 0 || up < 0 && up * up >= r2 || !sight.matters(px, py, pz, extent, 4 * node)) {
            return;
        }
        float d2 = ex * ex + ey * ey + ez * ez;
        if (s.face[node] < 0) {
            cluster(px, py, pz, nx, ny, nz, key, s, node, ex, ey, ez, up, (float) Math.sqrt(d2), gathering);
            return;
        }
        float above = -(s.normal[3 * node] * ex + s.normal[3 * node + 1] * ey + s.normal[3 * node + 2] * ez);
        if (above <= ShadowTest.IN_PLANE) {
            return;
        }
        double factor = ContourFactor.triangle(px, py, pz, nx, ny, nz, s.corner, 9 * node);
        if (factor <= 0) {
            return;
        }
        float near = r2 / d2;
        double carried = factor * strength * (1 + NEAR * near);
        int first = s.child[node];
        if (first >= 0 && carried > tolerance) {
            s.open(node);
            for (int k = 0; k < 4; k++) {
                enter(px, py, pz, nx, ny, nz, key, s, first + k, gathering);
            }
            return;
        }
        int wanted = carried > tolerance ? (int) Math.min(mostRays, rays * Math.ceil(carried / tolerance)) : rays;
        int choices = near > NEAR_8 ? Math.max(1, 8 / wanted) : near > NEAR_4 ? Math.max(1, 4 / wanted) : 1;
        long rotation = Hash.mix(key, s.key[node]);
        double chance = sparing ? Math.min(1, CLUSTER_DRAWS * carried / tolerance) : 1;
        if (isChosen(rotation, chance)) {
            triangles.sample(px, py, pz, nx, ny, nz, rotation, factor / chance, wanted, choices, s, node, gathering);
        }
    }

    private static boolean isChosen(long rotation, double chance) {
        return chance == 1 || Hash.unit(Hash.mix(rotation, 2)) < chance;
    }

    /**
     * Casts one ray at a cluster that carries no more than the tolerance, as bounded by the largest possible cosines at
     * cluster and receiver and the smallest distance; enters the cluster's two children otherwise.
     */
    private void cluster(float px, float py, float pz, float nx, float ny, float nz, long key, ShooterHierarchy s,
            int node,
                         float ex, float ey, float ez, float up, float d, GatherSink gathering) {
        float r = (float) Math.sqrt(s.extent[4 * node + 3]);
        if (r < d) {
            float sin = r / d;
            float cos = (float) Math.sqrt(1 - sin * sin);
            float out = s.cones.most(node, ex, ey, ez, d, sin, cos);
            if (out <= 0) {
                return;
            }
            double most = s.strength[node] * s.area[node] * out * NormalCones.most(up / d, sin, cos);
            double may = tolerance * Math.PI * (d - r) * (d - r);
            if (most <= may) {
                double draws = CLUSTER_DRAWS * most / may;
                long rotation = Hash.mix(key, s.key[node]);
                double chance = sparing ? Math.min(1, draws) : 1;
                if (isChosen(rotation, chance)) {
                    clusters.sample(px, py, pz, nx, ny, nz, rotation, (int) Math.ceil(draws), chance, s, node,
                            gathering);
                }
                return;
            }
        }
        enter(px, py, pz, nx, ny, nz, key, s, s.child[node], gathering);
        enter(px, py, pz, nx, ny, nz, key, s, s.child[node] + 1, gathering);
    }
}
