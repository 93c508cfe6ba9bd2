package radiosity.testkit;

import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/**
 * A block that stands on the plane y = 0, without a bottom face.
 *
 * @param height of its top
 * @param base   x, z per corner, convex, counter-clockwise seen from above
 */
public record Prism(double height, double[] base) {

    public void addTo(SceneBuilder builder, Surface surface) {
        int n = base.length / 2;
        Vec3[] top = new Vec3[n];
        for (int i = 0; i < n; i++) {
            int j = (i + 1) % n;
            top[i] = at(i, height);
            builder.polygon(surface, at(i, 0), at(j, 0), at(j, height), at(i, height));
        }
        builder.polygon(surface, top);
    }

    private Vec3 at(int i, double y) {
        return new Vec3(base[2 * i], y, base[2 * i + 1]);
    }

    /** Whether a point of the floor is hidden under it; its border is. */
    public boolean covers(Vec3 p) {
        int n = base.length / 2;
        boolean inside = p.y() == 0;
        for (int i = 0; i < n; i++) {
            Vec3 a = at(i, 0);
            Vec3 edge = at((i + 1) % n, 0).minus(a);
            inside &= edge.cross(p.minus(a)).y() >= -1e-9;
        }
        return inside;
    }
}
