package radiosity.formfactor;

import java.util.List;
import radiosity.util.Aabb;
import radiosity.visibility.RadiosityBounds;

/**
 * Difference of visibility between two scenes that have most triangles in common: 1 for a ray that is free only in the
 * later scene, -1 for a ray that is free only in the earlier scene, else 0. The same ray is cast in both scenes, so the
 * light along rays that no change touches cancels exactly.
 */
public final class VisibilityChange extends ShadowTest {

    private final RadiosityBounds before;
    private final RadiosityBounds now;
    private final RadiosityBounds gone;
    private final RadiosityBounds come;
    /** 4 per object that has come or gone: middle and radius of a sphere around the object. */
    private final float[] spheres;

    /**
     * @param before  all triangles of the earlier scene
     * @param now     all triangles of the later scene
     * @param gone    the triangles of the earlier scene that the later scene lacks
     * @param come    the triangles of the later scene that the earlier scene lacks
     * @param objects boxes around all objects that have come or gone, in the scene brought to size 1
     */
    public VisibilityChange(RadiosityBounds before, RadiosityBounds now, RadiosityBounds gone, RadiosityBounds come,
            List<Aabb> objects) {
        super(now);
        this.before = before;
        this.now = now;
        this.gone = gone;
        this.come = come;
        spheres = new float[4 * objects.size()];
        for (int i = 0; i < objects.size(); i++) {
            objects.get(i).centre().write(spheres, 4 * i);
            spheres[4 * i + 3] = (float) (objects.get(i).diagonal() / 2 * (1 + 1e-3) + 1e-5);
        }
    }

    @Override
    int share(float ox, float oy, float oz, float tx, float ty, float tz) {
        boolean wasStopped = gone.blocked(ox, oy, oz, tx, ty, tz);
        boolean isStopped = come.blocked(ox, oy, oz, tx, ty, tz);
        if (wasStopped == isStopped) {
            return 0;
        }
        return wasStopped ? now.blocked(ox, oy, oz, tx, ty, tz) ? 0 : 1
                : before.blocked(ox, oy, oz, tx, ty, tz) ? 0 : -1;
    }

    /**
     * Whether a sphere around a changed object meets the convex hull of the point and the shooter's sphere. At a part t
     * of the way from the point to the shooter's middle, the hull contains a sphere of t times the shooter's radius.
     * The hull of a point in the shooter's sphere is that sphere.
     */
    @Override
    boolean matters(float px, float py, float pz, float[] sphere, int at) {
        double dx = sphere[at] - px;
        double dy = sphere[at + 1] - py;
        double dz = sphere[at + 2] - pz;
        double r = Math.sqrt(sphere[at + 3]);
        double a = dx * dx + dy * dy + dz * dz - r * r;
        for (int i = 0; i < spheres.length; i += 4) {
            double wx = spheres[i] - px;
            double wy = spheres[i + 1] - py;
            double wz = spheres[i + 2] - pz;
            double wide = spheres[i + 3];
            double b = wx * dx + wy * dy + wz * dz + r * wide;
            double c = wx * wx + wy * wy + wz * wz - wide * wide;
            double t = a > 0 ? Math.max(0, Math.min(1, b / a)) : 1;
            if (c <= 0 || t * (t * a - 2 * b) + c <= 0) {
                return true;
            }
        }
        return false;
    }
}
