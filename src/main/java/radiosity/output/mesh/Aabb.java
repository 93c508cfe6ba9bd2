package radiosity.output.mesh;

import radiosity.scene.Vec3;

/** The smallest box around points. A box around no point is empty at the origin. */
public record Aabb(Vec3 low, Vec3 high) {

    /** @param points x, y, z, 3 per point; not modified */
    public static Aabb of(double[] points) {
        double[] box = {0, 0, 0, 0, 0, 0};
        for (int i = 0; i < points.length; i++) {
            int a = i % 3;
            box[a] = i < 3 ? points[i] : Math.min(box[a], points[i]);
            box[a + 3] = i < 3 ? points[i] : Math.max(box[a + 3], points[i]);
        }
        return new Aabb(new Vec3(box[0], box[1], box[2]), new Vec3(box[3], box[4], box[5]));
    }

    public Vec3 centre() {
        return low.times(0.5).plus(high.times(0.5));
    }

    /** @param i bit 0 for high x, bit 1 for high y, bit 2 for high z */
    public Vec3 corner(int i) {
        return new Vec3((i & 1) == 0 ? low.x() : high.x(), (i & 2) == 0 ? low.y() : high.y(),
                (i & 4) == 0 ? low.z() : high.z());
    }

    public double diagonal() {
        return high.minus(low).length();
    }
}
