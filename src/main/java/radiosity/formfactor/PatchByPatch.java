package radiosity.formfactor;

import radiosity.visibility.RadiosityBounds;

/** A calculator that treats every patch of a shooter as a whole: it neither clusters nor divides patches. */
abstract class PatchByPatch implements FormFactorCalculator {

    private final ShadowTest sight;

    PatchByPatch(RadiosityBounds bounds) {
        sight = new ShadowTest(bounds);
    }

    /**
     * A receiving point, its shooter and the sink for its light.
     *
     * @param px  coordinates in the scene brought to size 1: px, py, pz
     * @param nx  normal, length 1: nx, ny, nz
     * @param key key of the receiving point, the same on every host
     */
    record Receiver(float px, float py, float pz, float nx, float ny, float nz, long key, ShooterHierarchy shooter,
                    GatherSink gathering) {

        /** Height of a node's corner k above the receiver's horizon. */
        float above(int node, int k) {
            float[] corner = shooter.corner;
            int at = 9 * node + 3 * k;
            return nx * (corner[at] - px) + ny * (corner[at + 1] - py) + nz * (corner[at + 2] - pz);
        }

        /** Height of the receiver above a node's plane. */
        float before(int node) {
            float[] corner = shooter.corner;
            float[] normal = shooter.normal;
            return normal[3 * node] * (px - corner[9 * node]) + normal[3 * node + 1] * (py - corner[9 * node + 1])
                    + normal[3 * node + 2] * (pz - corner[9 * node + 2]);
        }
    }

    @Override
    public final void gather(float px, float py, float pz, float nx, float ny, float nz, long key,
            ShooterHierarchy shooter,
                             GatherSink gathering) {
        enter(new Receiver(px, py, pz, nx, ny, nz, key, shooter, gathering), 0);
    }

    private void enter(Receiver to, int node) {
        ShooterHierarchy s = to.shooter;
        if (s.strength[node] == 0) {
            return;
        }
        if (s.face[node] < 0) {
            enter(to, s.child[node]);
            enter(to, s.child[node] + 1);
        } else if (to.before(node) > ShadowTest.IN_PLANE
                && Math.max(to.above(node, 0), Math.max(to.above(node, 1), to.above(node, 2))) > 0) {
            to.gathering.close(patch(to, node));
        }
    }

    /**
     * Adds to the sink the visible sample points of a patch that faces the receiver and rises above its horizon.
     *
     * @return scale of all these sample points, see {@link GatherSink#close}
     */
    abstract double patch(Receiver to, int node);

    /** Adds to the sink the point of a patch with corner weights a, b, c, if the receiver sees it. */
    final void addSample(Receiver to, int node, float a, float b, float c, double weight) {
        ShooterHierarchy s = to.shooter;
        float[] corner = s.corner;
        float[] normal = s.normal;
        int at = 9 * node;
        float dx = a * corner[at] + b * corner[at + 3] + c * corner[at + 6] - to.px;
        float dy = a * corner[at + 1] + b * corner[at + 4] + c * corner[at + 7] - to.py;
        float dz = a * corner[at + 2] + b * corner[at + 5] + c * corner[at + 8] - to.pz;
        if (sight.sees(to.px, to.py, to.pz, to.nx, to.ny, to.nz, dx, dy, dz, normal[3 * node], normal[3 * node + 1],
                normal[3 * node + 2]) != 0) {
            ShadowTest.reach(s, node, a, b, c, weight, to.gathering);
        }
    }
}
