package radiosity.visibility;

/**
 * Bounding volumes over triangles, in arrays: whether anything stands between two points (section 2.4.1 and 4.5.9).
 *
 * <p>Triangles block from both sides. Coordinates are those of a scene brought to size 1 around the origin; all
 * tolerances are relative to that size.
 */
public final class RadiosityBounds {

    /*
     * A binary tree in depth-first order with skip pointers: a traversal is one loop without a stack. A segment meets
     * a box unless one of six axes separates them: the three of the box, and the three cross products of these with
     * the segment (S. Gottschalk, Separating axis theorem, UNC TR96-024, 1996; C. Ericson, Real-Time Collision
     * Detection, 2005, 5.3.3). No division, so no infinity and no NaN. Triangles: T. Moeller and B. Trumbore, Fast,
     * minimum storage ray/triangle intersection, 1997, widened by EDGE so that no ray passes between neighbours.
     */

    /** How much of a segment is left out at each end: of the scene's size, and of its own length. */
    static final float END_ABSOLUTE = 4e-6f;
    static final float END_RELATIVE = 1e-5f;
    /** Nearer to a plane than this a point lies on it, of the scene's size. */
    private static final double OFF_PLANE = 2e-7;
    /** How far a triangle reaches beyond its edges, of its own size. */
    static final float EDGE = 1e-5f;
    /** Boxes are this much larger than what they hold, of the scene's size. */
    private static final float PAD = 2e-6f;

    private final float[] box;
    private final int[] skip;
    private final int[] run;
    private final int nodes;
    /** 9 per triangle, in the tree's order: corner 0, edge to corner 1, edge to corner 2. */
    private final float[] triangle;
    /** The caller's number of each triangle in the tree's order. */
    private final int[] number;

    /** @param corners x, y, z of three corners, 9 per triangle; not modified, not kept */
    public RadiosityBounds(float[] corners) {
        int n = corners.length / 9;
        float[] low = new float[3 * n];
        float[] high = new float[3 * n];
        for (int i = 0; i < 3 * n; i++) {
            int k = 9 * (i / 3) + i % 3;
            low[i] = Math.min(corners[k], Math.min(corners[k + 3], corners[k + 6])) - PAD;
            high[i] = Math.max(corners[k], Math.max(corners[k + 3], corners[k + 6])) + PAD;
        }
        BoundsBuilder tree = new BoundsBuilder(low, high);
        box = tree.box;
        skip = tree.skip;
        run = tree.run;
        nodes = tree.nodes;
        number = tree.order;
        triangle = new float[9 * n];
        for (int i = 0; i < n; i++) {
            int k = 9 * number[i];
            for (int a = 0; a < 3; a++) {
                triangle[9 * i + a] = corners[k + a];
                triangle[9 * i + 3 + a] = corners[k + 3 + a] - corners[k + a];
                triangle[9 * i + 6 + a] = corners[k + 6 + a] - corners[k + a];
            }
        }
    }

    /** Number of triangles. */
    public int size() {
        return number.length;
    }

    /** Whether any triangle stands between two points; what touches an end does not count. */
    public boolean blocked(float ox, float oy, float oz, float tx, float ty, float tz) {
        float dx = tx - ox;
        float dy = ty - oy;
        float dz = tz - oz;
        float hx = 0.5f * dx;
        float hy = 0.5f * dy;
        float hz = 0.5f * dz;
        float mx = ox + hx;
        float my = oy + hy;
        float mz = oz + hz;
        float ax = Math.abs(hx);
        float ay = Math.abs(hy);
        float az = Math.abs(hz);
        float end = END_RELATIVE + END_ABSOLUTE / (float) Math.sqrt(dx * dx + dy * dy + dz * dz);
        int node = 0;
        while (node < nodes) {
            int b = 6 * node;
            float cx = mx - box[b];
            float cy = my - box[b + 1];
            float cz = mz - box[b + 2];
            float ex = box[b + 3];
            float ey = box[b + 4];
            float ez = box[b + 5];
            if (Math.abs(cx) > ex + ax || Math.abs(cy) > ey + ay || Math.abs(cz) > ez + az
                    || Math.abs(hy * cz - hz * cy) > ey * az + ez * ay
                    || Math.abs(hz * cx - hx * cz) > ex * az + ez * ax
                    || Math.abs(hx * cy - hy * cx) > ex * ay + ey * ax) {
                node = skip[node];
                continue;
            }
            int r = run[node];
            if (r >= 0) {
                for (int i = r >> 3, last = i + (r & 7); i < last; i++) {
                    if (meets(i, ox, oy, oz, dx, dy, dz, end)) {
                        return true;
                    }
                }
            }
            node++;
        }
        return false;
    }

    private boolean meets(int i, float ox, float oy, float oz, float dx, float dy, float dz, float end) {
        int k = 9 * i;
        float ax = triangle[k + 3];
        float ay = triangle[k + 4];
        float az = triangle[k + 5];
        float bx = triangle[k + 6];
        float by = triangle[k + 7];
        float bz = triangle[k + 8];
        float px = dy * bz - dz * by;
        float py = dz * bx - dx * bz;
        float pz = dx * by - dy * bx;
        float det = ax * px + ay * py + az * pz;
        float sx = ox - triangle[k];
        float sy = oy - triangle[k + 1];
        float sz = oz - triangle[k + 2];
        float u = sx * px + sy * py + sz * pz;
        if (det < 0) {
            det = -det;
            u = -u;
            sx = -sx;
            sy = -sy;
            sz = -sz;
        }
        float edge = EDGE * det;
        if (u < -edge || u > det + edge) {
            return false;
        }
        float qx = sy * az - sz * ay;
        float qy = sz * ax - sx * az;
        float qz = sx * ay - sy * ax;
        float v = dx * qx + dy * qy + dz * qz;
        if (v < -edge || u + v > det + edge) {
            return false;
        }
        float t = bx * qx + by * qy + bz * qz;
        return t > end * det && t < (1 - end) * det && isBetween(k, ox, oy, oz, dx, dy, dz);
    }

    /**
     * Whether a triangle's plane truly lies between the ends of a segment: both must be off it by more than float
     * coordinates are. Otherwise a point near a wall would not see that wall, where the ray's end lies on it but for
     * rounding, nor what is seen from a long triangle at a small angle.
     */
    private boolean isBetween(int k, double ox, double oy, double oz, double dx, double dy, double dz) {
        double ax = triangle[k + 3];
        double ay = triangle[k + 4];
        double az = triangle[k + 5];
        double bx = triangle[k + 6];
        double by = triangle[k + 7];
        double bz = triangle[k + 8];
        double nx = ay * bz - az * by;
        double ny = az * bx - ax * bz;
        double nz = ax * by - ay * bx;
        double from = nx * (ox - triangle[k]) + ny * (oy - triangle[k + 1]) + nz * (oz - triangle[k + 2]);
        double to = from + nx * dx + ny * dy + nz * dz;
        double least = OFF_PLANE * Math.sqrt(nx * nx + ny * ny + nz * nz);
        return from > least && to < -least || from < -least && to > least;
    }

    /**
     * The nearest triangle along a ray.
     *
     * @param ox  origin, and so on
     * @param dx  direction, of any length but 0, and so on
     * @param far only hits nearer than far * |d| count
     * @param hit modified where something is hit: distance in units of |d|, and the weights of corners 1 and 2
     * @return the number of the triangle, or -1
     */
    public int nearest(float ox, float oy, float oz, float dx, float dy, float dz, float far, float[] hit) {
        float reach = far;
        int found = -1;
        int node = 0;
        while (node < nodes) {
            if (missed(6 * node, ox, oy, oz, dx * reach * 0.5f, dy * reach * 0.5f, dz * reach * 0.5f)) {
                node = skip[node];
                continue;
            }
            int r = run[node];
            if (r >= 0) {
                for (int i = r >> 3, last = i + (r & 7); i < last; i++) {
                    if (hits(9 * i, ox, oy, oz, dx, dy, dz, reach, hit)) {
                        reach = hit[0];
                        found = number[i];
                    }
                }
            }
            node++;
        }
        return found;
    }

    private boolean missed(int b, float ox, float oy, float oz, float hx, float hy, float hz) {
        float cx = ox + hx - box[b];
        float cy = oy + hy - box[b + 1];
        float cz = oz + hz - box[b + 2];
        float ex = box[b + 3];
        float ey = box[b + 4];
        float ez = box[b + 5];
        float ax = Math.abs(hx);
        float ay = Math.abs(hy);
        float az = Math.abs(hz);
        return Math.abs(cx) > ex + ax || Math.abs(cy) > ey + ay || Math.abs(cz) > ez + az
                || Math.abs(hy * cz - hz * cy) > ey * az + ez * ay
                || Math.abs(hz * cx - hx * cz) > ex * az + ez * ax
                || Math.abs(hx * cy - hy * cx) > ex * ay + ey * ax;
    }

    private boolean hits(int k, float ox, float oy, float oz, float dx, float dy, float dz, float reach, float[] hit) {
        float ax = triangle[k + 3];
        float ay = triangle[k + 4];
        float az = triangle[k + 5];
        float bx = triangle[k + 6];
        float by = triangle[k + 7];
        float bz = triangle[k + 8];
        float px = dy * bz - dz * by;
        float py = dz * bx - dx * bz;
        float pz = dx * by - dy * bx;
        float det = ax * px + ay * py + az * pz;
        if (det == 0) {
            return false;
        }
        float inverse = 1 / det;
        float sx = ox - triangle[k];
        float sy = oy - triangle[k + 1];
        float sz = oz - triangle[k + 2];
        float u = (sx * px + sy * py + sz * pz) * inverse;
        float qx = sy * az - sz * ay;
        float qy = sz * ax - sx * az;
        float qz = sx * ay - sy * ax;
        float v = (dx * qx + dy * qy + dz * qz) * inverse;
        float t = (bx * qx + by * qy + bz * qz) * inverse;
        if (u >= -EDGE && v >= -EDGE && u + v <= 1 + EDGE && t > 0 && t < reach) {
            hit[0] = t;
            hit[1] = u;
            hit[2] = v;
            return true;
        }
        return false;
    }
}
