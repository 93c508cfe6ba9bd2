package radiosity.visibility;

import radiosity.scene.Vec3;

/**
 * Tells which points of surfaces lie inside a solid, such as points of a floor that runs on below a block: all
 * triangles that rays from a point inside meet show their invisible side. Where the solid touches another surface, its
 * own triangle counts and not the other's in the same place. One ray at least has to meet what is no sheet, as the
 * walls of a room may be modelled from both sides.
 */
public final class Solids {

    /**
     * 3 per direction of a ray: the normal, five directions at 55 degrees to it, and five nearly along the surface,
     * which look out of a narrow gap below the back of a sheet; z is along the normal.
     */
    private static final double[] DIRECTIONS = {
        0, 0, 1,
        0.819, 0, 0.574,
        0.253, 0.779, 0.574,
        -0.663, 0.481, 0.574,
        -0.663, -0.481, 0.574,
        0.253, -0.779, 0.574,
        -1, 0, 0.002,
        -0.309, -0.951, 0.002,
        0.809, -0.588, 0.002,
        0.809, 0.588, 0.002,
        -0.309, 0.951, 0.002};
    private static final float LIFT = (float) RadiosityBounds.LIFT;

    private final RadiosityBounds bounds;
    private final float[] front;

    /**
     * @param bounds the original triangles
     * @param front  3 per original triangle: normal of its visible side, 0 where both sides are visible; not modified
     */
    public Solids(RadiosityBounds bounds, float[] front) {
        this.bounds = bounds;
        this.front = front;
    }

    /**
     * Whether the point p of a surface with the normal n, of length 1, is inside a solid; both are rounded to floats.
     */
    public boolean hold(Vec3 p, Vec3 n) {
        return hold((float) p.x(), (float) p.y(), (float) p.z(), (float) n.x(), (float) n.y(), (float) n.z());
    }

    /**
     * Whether the point p of a surface with the normal n, of length 1, is inside a solid, where no light reaches it.
     */
    public boolean hold(float px, float py, float pz, float nx, float ny, float nz) {
        double[] frame = frame(nx, ny, nz);
        float x = px + LIFT * nx;
        float y = py + LIFT * ny;
        float z = pz + LIFT * nz;
        float[] normal = {nx, ny, nz};
        float[] d = new float[3];
        float[] hit = new float[3];
        boolean isInside = false;
        for (int i = 0; i < DIRECTIONS.length; i += 3) {
            for (int a = 0; a < 3; a++) {
                d[a] = (float) (DIRECTIONS[i] * frame[a] + DIRECTIONS[i + 1] * frame[3 + a]
                        + DIRECTIONS[i + 2] * normal[a]);
            }
            int t = bounds.nearest(x, y, z, d[0], d[1], d[2], RadiosityBounds.ACROSS, hit);
            if (t < 0 || !leaves(t, d) && !leavesAt(x, y, z, d, hit[0])) {
                return false;
            }
            isInside = isInside || !isSheet(t, x, y, z, d, hit[0]);
        }
        return isInside;
    }

    /** Whether a ray from x in direction d meets a triangle inside a solid; one that shows both sides never is. */
    public boolean hold(int t, float[] x, float[] d, float distance) {
        boolean isTwoSided = front[3 * t] == 0 && front[3 * t + 1] == 0 && front[3 * t + 2] == 0;
        return !isTwoSided && hold(x[0] + distance * d[0], x[1] + distance * d[1], x[2] + distance * d[2],
                front[3 * t], front[3 * t + 1], front[3 * t + 2]);
    }

    /** Whether a ray meets another triangle from its invisible side at a given distance, {@code place}. */
    private boolean leavesAt(float x, float y, float z, float[] d, double place) {
        return bounds.meets(x, y, z, d[0], d[1], d[2], place / RadiosityBounds.SAME_PLACE,
                place * RadiosityBounds.SAME_PLACE, t -> leaves(t, d), (t, distance) -> true);
    }

    /**
     * Whether a ray meets the other side of another triangle in the place of a triangle, and both have two corners in
     * common: the two sides of a sheet.
     */
    private boolean isSheet(int t, float x, float y, float z, float[] d, double place) {
        return bounds.meets(x, y, z, d[0], d[1], d[2], place - RadiosityBounds.THIN, place + RadiosityBounds.THIN,
                other -> leaves(other, d) != leaves(t, d),
                (other, distance) -> haveEdge(bounds.corners(t), bounds.corners(other)));
    }

    /** Whether two triangles, given by x, y, z of their corners, have two corners in common. */
    private static boolean haveEdge(float[] some, float[] others) {
        int common = 0;
        for (int i = 0; i < 9; i++) {
            int k = 3 * (i / 3);
            int m = 3 * (i % 3);
            double apart = Math.max(Math.abs(some[k] - others[m]), Math.max(Math.abs(some[k + 1] - others[m + 1]),
                    Math.abs(some[k + 2] - others[m + 2])));
            common += apart < RadiosityBounds.THIN ? 1 : 0;
        }
        return common >= 2;
    }

    /** Whether a ray that meets a triangle meets the triangle from its invisible side. */
    public boolean leaves(int t, float[] d) {
        return front[3 * t] * d[0] + front[3 * t + 1] * d[1] + front[3 * t + 2] * d[2] > 0;
    }

    /** Whether a ray in a direction that is not rounded meets a triangle from the triangle's invisible side. */
    public boolean leaves(int t, Vec3 d) {
        return front[3 * t] * d.x() + front[3 * t + 1] * d.y() + front[3 * t + 2] * d.z() > 0;
    }

    /**
     * A direction of light that leaves a surface, x, y, z.
     *
     * @param p with {@code q}: point in the unit circle below the hemisphere; p² + q² < 1
     * @param n unit normal
     */
    public static float[] direction(double p, double q, Vec3 n) {
        double[] frame = frame(n.x(), n.y(), n.z());
        double up = Math.sqrt(Math.max(0, 1 - p * p - q * q));
        float[] d = new float[3];
        for (int a = 0; a < 3; a++) {
            d[a] = (float) (p * frame[a] + q * frame[3 + a] + up * n.coordinate(a));
        }
        return d;
    }

    /** Returns two unit vectors, x, y, z each, at right angles to each other and to a normal of length 1. */
    private static double[] frame(double nx, double ny, double nz) {
        double ax = Math.abs(nx) < 0.6 ? 1 : 0;
        double ay = 1 - ax;
        double ux = -ay * nz;
        double uy = ax * nz;
        double uz = ay * nx - ax * ny;
        double length = Math.sqrt(ux * ux + uy * uy + uz * uz);
        ux /= length;
        uy /= length;
        uz /= length;
        return new double[] {ux, uy, uz, ny * uz - nz * uy, nz * ux - nx * uz, nx * uy - ny * ux};
    }
}
